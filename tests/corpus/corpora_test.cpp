// The program on every file of the corpora that are installed: it reads each or refuses it with a sentence,
// and neither crashes nor hangs nor leaves a process behind. `./test --corpus`, or `ctest -L corpus`.
//
//     KNOTSPAN_CORPUS_JOBS=N      how many files at once
//     KNOTSPAN_CORPUS_SHARE=N/M   the N-th of M parts, so that several machines can divide the work
//     KNOTSPAN_CORPUS_RESULTS=F   where the tables go; a run that was stopped goes on from there
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "tests/corpus/corpora.h"
#include "tests/corpus/corpus_run.h"
#include "tests/corpus/summary.h"
#include "tests/support.h"

namespace knotspan::corpus {
namespace {

std::filesystem::path resultsFolder()
{
    const char* asked = std::getenv("KNOTSPAN_CORPUS_RESULTS");
    std::filesystem::path folder = asked != nullptr ? asked : KNOTSPAN_CORPUS_RESULTS;
    std::filesystem::create_directories(folder);
    return folder;
}

std::vector<ModelFile> shareAskedFor(const std::vector<ModelFile>& files)
{
    const char* asked = std::getenv("KNOTSPAN_CORPUS_SHARE");
    size_t n = 1;
    size_t m = 1;
    if (asked != nullptr && (std::sscanf(asked, "%zu/%zu", &n, &m) != 2 || n < 1 || n > m))
        ADD_FAILURE() << "KNOTSPAN_CORPUS_SHARE is " << asked << ", not as 2/3 is";
    return shareOf(files, n, m);
}

TEST(Corpora, AreReadOrRefusedWithASentenceFileByFile)
{
    const testing::TemporaryFolder scratch;
    const std::filesystem::path results = resultsFolder();
    std::vector<Record> all;
    for (const Corpus& corpus : corpora(scratch.path())) {
        if (corpus.files.empty()) {
            std::cout << corpus.name << ": not installed\n";
            continue;
        }
        const auto files = shareAskedFor(shuffled(corpus.files));
        std::cout << corpus.name << ": " << files.size() << " files" << std::endl;
        for (Record& record : runOver(files, scratch.path(), results / (corpus.name + ".tsv")))
            all.push_back(std::move(record));
        const std::string summary = tableOf(all) + "\n" + reasonsOf(all);
        testing::writeFile(results / "summary.md", summary);
    }
    if (all.empty())
        GTEST_SKIP() << "none of the corpora is installed: ./test --corpus installs them";
    std::cout << testing::readFile(results / "summary.md");
    EXPECT_EQ(wrongsOf(all), "");
}

}  // namespace
}  // namespace knotspan::corpus
