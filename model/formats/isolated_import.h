// Files whose library may crash, hang or swallow the memory are read by another process, which is ended when
// it does, or when it is to stop: parsing cannot be cancelled in any other way.
//
// The other process is the program itself, as main() says with setImportWorker(). Programs that say nothing
// (tests, benchmarks) read such files in their own process, without limits and without cancel: they must not
// start themselves. Where a worker is set but cannot be started, the file is refused with a sentence: a model
// from anywhere does not get past the limits unseen.
#pragma once

#include <atomic>
#include <optional>

#include "model/files/format.h"
#include "model/formats/worker_process.h"

namespace knotspan::formats {

// The program that is run as `PROGRAM import-worker FILE`; empty: none. From any thread.
void setImportWorker(const std::filesystem::path& program);
[[nodiscard]] std::filesystem::path importWorker();

// How a long reading is followed and stopped.
struct ImportWatch {
    ImportProgress progress;                       // called from the reading thread
    const std::atomic<bool>* cancelled = nullptr;  // acts within a tenth of a second
};

// Half the machine's memory; computing time by the size of the file, ten times and more what it should take.
[[nodiscard]] ProcessLimits limitsFor(const std::filesystem::path& path);

// Lets the worker read the file. The error says where that failed by a crash, a limit or a cancel; no process
// is left behind.
[[nodiscard]] Result<Import> importIsolated(const std::filesystem::path& path, const ImportWatch& watch,
                                            const ProcessLimits& limits);

}  // namespace knotspan::formats
