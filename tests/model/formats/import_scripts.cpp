#include "tests/model/formats/import_scripts.h"

#include <fstream>
#include <sstream>

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

bool isRunning(int pid)
{
    const char state = stateOf(std::to_string(pid)).state;
    return state != 0 && state != 'Z';
}

}  // namespace knotspan::testing
