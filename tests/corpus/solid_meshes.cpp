#include "tests/corpus/solid_meshes.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <sstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/corpus/corpus_run.h"
#include "tests/corpus/program_run.h"

namespace knotspan::corpus {

namespace {

constexpr double kSecondsAllowed = 300;  // for all shells of a file

bool hasShells(const ModelFile& file)
{
    std::string extension = file.path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".step" || extension == ".stp" || extension == ".p21" || extension == ".igs" ||
           extension == ".iges" || extension == ".brep" || extension == ".brp";
}

void add(SolidMeshes& to, const ModelFile& file, const ProgramRun& run)
{
    ++to.files;
    const auto answer = nlohmann::json::parse(run.output, nullptr, false);
    if (run.status != 0 || !answer.is_object() || !answer.contains("shells")) {
        ++to.unread;
        return;
    }
    size_t number = 0;
    for (const auto& shell : answer["shells"]) {
        ++to.shells;
        const std::string name = file.name + ", shell " + std::to_string(++number) + ": ";
        if (shell.contains("problem")) {
            to.unlike.push_back(name + shell["problem"].get<std::string>());
            continue;
        }
        const auto boundary = shell["boundary"].get<size_t>();
        const auto measured = shell["measured"].get<double>();
        to.closed += boundary == 0 ? 1 : 0;
        to.manifold += shell["manifold"].get<bool>() ? 1 : 0;
        to.within += measured <= 1 ? 1 : 0;
        to.beyondBound += measured > shell["bound"].get<double>() + 1e-9 ? 1 : 0;
        if (boundary > 0 || measured > 1)
            to.unlike.push_back(name + std::to_string(boundary) + " boundary edges, measured " +
                                std::to_string(measured) + " of the deviation; " +
                                shell.value("notes", std::string()));
    }
}

}  // namespace

SolidMeshes solidMeshesOf(const std::vector<ModelFile>& files, const std::filesystem::path& scratch)
{
    SolidMeshes result;
    std::mutex mutex;
    std::atomic<size_t> next = 0;
    const auto work = [&] {
        for (size_t k = next++; k < files.size(); k = next++) {
            if (!hasShells(files[k]))
                continue;
            const ProgramRun run =
                runOn({KNOTSPAN_SOLID_MESHES, files[k].path.string()}, kSecondsAllowed, scratch);
            const std::scoped_lock lock(mutex);
            result.corpus = files[k].corpus;
            add(result, files[k], run);
        }
    };
    std::vector<std::thread> workers;
    for (int k = 0; k < jobs(); ++k)
        workers.emplace_back(work);
    for (std::thread& worker : workers)
        worker.join();
    std::sort(result.unlike.begin(), result.unlike.end());
    return result;
}

std::string tableOf(const std::vector<SolidMeshes>& corpora)
{
    std::ostringstream table;
    table << "| corpus | files | not read | closed shells | mesh closed | a manifold | within the deviation "
             "| beyond "
             "the bound |\n|---|---|---|---|---|---|---|---|\n";
    for (const SolidMeshes& of : corpora)
        table << "| " << of.corpus << " | " << of.files << " | " << of.unread << " | " << of.shells << " | "
              << of.closed << " | " << of.manifold << " | " << of.within << " | " << of.beyondBound << " |\n";
    for (const SolidMeshes& of : corpora)
        for (const std::string& sentence : of.unlike)
            table << "- " << of.corpus << ": " << sentence << '\n';
    return table.str();
}

}  // namespace knotspan::corpus
