#include "tests/corpus/corpus_run.h"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <thread>

#include "model/formats/isolated_import.h"

namespace knotspan::corpus {
namespace fs = std::filesystem;

namespace {

using Records = std::map<std::string, Record>;

std::string keyOf(const std::string& corpus, const std::string& file)
{
    return corpus + '\t' + file;
}

Records recordsIn(const fs::path& table)
{
    Records records;
    std::ifstream file(table);
    for (std::string line; std::getline(file, line);)
        if (auto record = recordFrom(line))
            records.emplace(keyOf(record->corpus, record->file), std::move(*record));
    return records;
}

// The program ends its importer itself at its limits; what is still there a minute later hangs.
double secondsAllowedFor(const fs::path& path)
{
    return formats::limitsFor(path).wallSeconds + 60.0;
}

// A copy: a build beside it may replace the program, which starts itself as its importer.
fs::path programIn(const fs::path& scratch)
{
    const fs::path program = scratch / "knotspan";
    fs::copy_file(KNOTSPAN_PROGRAM, program, fs::copy_options::overwrite_existing);
    return program;
}

}  // namespace

int jobs()
{
    const char* asked = std::getenv("KNOTSPAN_CORPUS_JOBS");
    const int number = asked != nullptr ? std::atoi(asked) : 0;
    return number > 0 ? number : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::vector<Record> runOver(const std::vector<ModelFile>& files, const fs::path& scratch,
                            const fs::path& table)
{
    const fs::path program = programIn(scratch);
    Records records = recordsIn(table);
    std::ofstream lines(table, std::ios::app);
    if (records.empty())
        lines << headerLine() << std::endl;
    std::mutex mutex;
    std::atomic<size_t> next = 0;
    const auto work = [&] {
        for (size_t k = next++; k < files.size(); k = next++) {
            const ModelFile& file = files[k];
            const std::string key = keyOf(file.corpus, file.name);
            {
                const std::scoped_lock lock(mutex);
                if (records.count(key) != 0)
                    continue;
            }
            const Record record =
                recordOf(file, runOn({program.string(), "info", "--json", file.path.string()},
                                     secondsAllowedFor(file.path), scratch));
            const std::scoped_lock lock(mutex);
            lines << lineOf(record) << std::endl;
            records.emplace(key, record);
        }
    };
    std::vector<std::thread> workers;
    for (int k = 0; k < jobs(); ++k)
        workers.emplace_back(work);
    for (std::thread& worker : workers)
        worker.join();
    std::vector<Record> ours;
    for (const ModelFile& file : files)
        if (const auto found = records.find(keyOf(file.corpus, file.name)); found != records.end())
            ours.push_back(found->second);
    return ours;
}

}  // namespace knotspan::corpus
