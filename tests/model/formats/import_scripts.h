// Stand-ins for the importer: programs that crash, hang, swallow memory or talk rubbish, and a count of
// processes left behind.
#pragma once

#include <string>

#include "model/formats/isolated_import.h"
#include "tests/support.h"

namespace knotspan::testing {

// A shell script in the folder that is the importer for as long as the object lives.
class ScriptedImporter {
public:
    ScriptedImporter(const TemporaryFolder& folder, const std::string& script);
    ~ScriptedImporter();
    ScriptedImporter(const ScriptedImporter&) = delete;
    ScriptedImporter& operator=(const ScriptedImporter&) = delete;
};

// Children of this process that are still there, running or not waited for, after those that were killed had time
// to go: 0 is what it should be.
[[nodiscard]] int childProcessesLeft();

// Whether a process of that number runs (a zombie does not).
[[nodiscard]] bool isRunning(int pid);

}  // namespace knotspan::testing
