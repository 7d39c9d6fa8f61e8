#include "tests/model/formats/import_scripts.h"

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include <sys/stat.h>
#include <unistd.h>

namespace knotspan::testing {
namespace fs = std::filesystem;

namespace {

// The state letter and the parent of a process; 0 where it is gone.
struct ProcessState {
    char state = 0;
    int parent = 0;
};

ProcessState stateOf(const std::string& pid)
{
    const std::string text = readFile("/proc/" + pid + "/stat");
    const size_t name = text.rfind(')');  // a name may hold anything
    if (name == std::string::npos)
        return {};
    ProcessState state;
    std::istringstream(text.substr(name + 1)) >> state.state >> state.parent;
    return state;
}

int childProcesses()
{
    int count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename().string();
        if (name.find_first_not_of("0123456789") == std::string::npos && stateOf(name).parent == ::getpid())
            ++count;
    }
    return count;
}

}  // namespace

ScriptedImporter::ScriptedImporter(const TemporaryFolder& folder, const std::string& script)
{
    const fs::path path = folder / "importer.sh";
    writeFile(path, "#!/bin/sh\n" + script + "\n");
    ::chmod(path.c_str(), 0700);
    formats::setImportWorker(path);
}

ScriptedImporter::~ScriptedImporter()
{
    formats::setImportWorker({});
}

int childProcessesLeft()
{
    // What was killed is waited for a tenth of a second by who killed it, then by a thread.
    const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(kHang);
    int count = childProcesses();
    for (; count > 0 && std::chrono::steady_clock::now() < latest; count = childProcesses())
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return count;
}

bool isRunning(int pid)
{
    const char state = stateOf(std::to_string(pid)).state;
    return state != 0 && state != 'Z';
}

}  // namespace knotspan::testing
