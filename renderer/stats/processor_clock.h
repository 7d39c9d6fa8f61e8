// Processor time of this thread: what the program itself worked, however busy the machine is.
#pragma once

namespace knotspan {

// In milliseconds, from some moment on; without what the thread waited, and without other threads.
[[nodiscard]] double processorMs();

// What a frame cost this thread, in milliseconds of processor time.
struct FrameWork {
    double sync = 0;     // taking over the model's changes since the frame before
    double prepare = 0;  // everything else before the commands are recorded
    double record = 0;   // recording them, the driver's part of it included
    double finish = 0;   // handing them to the driver, waking up, and reading what was counted

    // Before the driver gets them.
    [[nodiscard]] double before() const { return sync + prepare + record; }
};

}  // namespace knotspan
