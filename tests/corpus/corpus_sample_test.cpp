// A few files of the corpora, for every run of the tests: how the whole of them is run is tested too.
#include <algorithm>

#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/corpus/corpora.h"
#include "tests/corpus/corpus_run.h"
#include "tests/corpus/solid_meshes.h"
#include "tests/corpus/summary.h"
#include "tests/support.h"

namespace knotspan::corpus {
namespace {

TEST(CorpusSample, OfTenFilesIsReadOrRefusedWithASentence)
{
    const testing::TemporaryFolder scratch;
    std::vector<ModelFile> sample;
    for (const Corpus& corpus : corpora(scratch.path()))
        for (const ModelFile& file : shuffled(corpus.files))
            // Two of each, and none that takes long.
            if (std::filesystem::file_size(file.path) < 1'000'000 &&
                std::count_if(sample.begin(), sample.end(),
                              [&](const ModelFile& one) { return one.corpus == corpus.name; }) < 2)
                sample.push_back(file);
    if (sample.empty())
        GTEST_SKIP() << "none of the corpora is installed: ./test --corpus installs gmsh-doc, "
                        "calculix-cgx-examples, freecad-common, kicad-demos and kicad-packages3d";
    const auto records = runOver(sample, scratch.path(), scratch / "sample.tsv");
    EXPECT_EQ(records.size(), sample.size());
    EXPECT_EQ(wrongsOf(records), "");
    EXPECT_TRUE(std::any_of(records.begin(), records.end(), [](const Record& record) {
        return record.outcome == Outcome::read;
    })) << reasonsOf(records);
}

TEST(CorpusSample, OfClosedShellsHasClosedMeshes)
{
    const testing::TemporaryFolder scratch;
    size_t shells = 0;
    for (const Corpus& corpus : corpora(scratch.path())) {
        std::vector<ModelFile> sample;
        for (const ModelFile& file : shuffled(corpus.files))
            if (std::filesystem::file_size(file.path) < 300'000 && sample.size() < 12)
                sample.push_back(file);
        const SolidMeshes meshes = solidMeshesOf(sample, scratch.path());
        shells += meshes.shells;
        EXPECT_EQ(meshes.closed, meshes.shells) << tableOf({meshes});
        EXPECT_EQ(meshes.within, meshes.shells) << tableOf({meshes});
        EXPECT_EQ(meshes.beyondBound, 0U) << tableOf({meshes});
    }
    if (shells == 0)
        GTEST_SKIP() << "none of the corpora is installed: ./test --corpus installs them";
}

class ProgramsOnAFile : public ::testing::Test {
protected:
    [[nodiscard]] ProgramRun runScript(const std::string& script, double secondsAllowed)
    {
        return runOn({"/bin/sh", "-c", script}, secondsAllowed, scratch_.path());
    }

    [[nodiscard]] Outcome outcomeOf(const std::string& script)
    {
        return recordOf(file_, runScript(script, 30)).outcome;
    }

    testing::TemporaryFolder scratch_;
    ModelFile file_{"none", "file.step", scratch_ / "file.step"};
};

TEST_F(ProgramsOnAFile, AreJudgedByHowTheyEnd)
{
    EXPECT_EQ(outcomeOf("echo '{\"surfaces\": [], \"bounds\": null}'"), Outcome::read);
    EXPECT_EQ(outcomeOf("echo 'knotspan: no.' >&2; exit 1"), Outcome::refused);
    EXPECT_EQ(outcomeOf("kill -SEGV $$"), Outcome::crashed);
    EXPECT_EQ(outcomeOf("exit 1"), Outcome::strange);
    EXPECT_EQ(outcomeOf("echo one >&2; echo two >&2; exit 1"), Outcome::strange);
    EXPECT_EQ(outcomeOf("echo no JSON"), Outcome::strange);
}

TEST_F(ProgramsOnAFile, ThatDoNotEndAreEnded)
{
    const ProgramRun run = runScript("sleep 600", 0.2);
    EXPECT_TRUE(run.tookTooLong);
    EXPECT_LT(run.seconds, testing::kHang);
    EXPECT_LT(run.computing, 1);
    EXPECT_EQ(run.leaked, 0);
    EXPECT_EQ(recordOf(file_, run).outcome, Outcome::hung);
}

TEST_F(ProgramsOnAFile, ThatLeaveAProcessBehindAreCaught)
{
    EXPECT_EQ(runScript("sleep 6 & exit 0", 30).leaked, 1);
    EXPECT_EQ(runScript("sleep 0.1 & exit 0", 30).leaked, 0);
}

TEST_F(ProgramsOnAFile, AreRememberedInALine)
{
    Record record;
    record.corpus = "one";
    record.file = "two\tthree";
    record.outcome = Outcome::refused;
    record.relativeError = 1.5e-7;
    record.seconds = 0.25;
    record.computing = 0.125;
    record.sentence = "It is no model. Choose another.";
    record.refusals = {{"The cone has # tips", 3}};
    const std::string line = lineOf(record);
    const auto back = recordFrom(line);
    ASSERT_TRUE(back);
    EXPECT_EQ(lineOf(*back), line);
    EXPECT_EQ(back->refusals, record.refusals);
    EXPECT_FALSE(recordFrom(line.substr(0, line.size() / 2)));
    EXPECT_FALSE(recordFrom(headerLine()));
    const std::string header = headerLine();
    EXPECT_EQ(std::count(header.begin(), header.end(), '\t'), std::count(line.begin(), line.end(), '\t'));
}

TEST(Shares, OfACorpusAreDisjointAndTheWholeTogether)
{
    std::vector<ModelFile> files;
    for (int k = 0; k < 10; ++k)
        files.push_back({"c", std::to_string(k), {}});
    std::vector<std::string> names;
    for (size_t n = 1; n <= 3; ++n)
        for (const ModelFile& file : shareOf(shuffled(files), n, 3))
            names.push_back(file.name);
    std::sort(names.begin(), names.end());
    ASSERT_EQ(names.size(), files.size());
    for (size_t k = 0; k < names.size(); ++k)
        EXPECT_EQ(names[k], files[k].name);
}

}  // namespace
}  // namespace knotspan::corpus
