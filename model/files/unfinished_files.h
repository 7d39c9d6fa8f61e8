// The files that are just being written under a name of their own, so that a process that is told to end can
// remove them.
#pragma once

#include <filesystem>

namespace knotspan::formats {

// Stands for one such file. Where too many are being written at once it stands for none.
class UnfinishedFile {
public:
    explicit UnfinishedFile(const std::filesystem::path& path);
    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&&) = delete;
    ~UnfinishedFile();

private:
    int slot_ = -1;
};

// May be called in a signal handler; the process is to end then.
void removeUnfinishedFiles() noexcept;

}  // namespace knotspan::formats
