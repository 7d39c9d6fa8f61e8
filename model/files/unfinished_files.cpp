#include "model/files/unfinished_files.h"

#include <array>
#include <atomic>
#include <cstring>
#include <utility>

#include <unistd.h>

namespace knotspan::formats {

namespace {

// A signal may come at any moment, and its handler may not wait or allocate.
struct Slot {
    enum State { free, being_filled, filled };
    std::atomic<int> state = free;
    std::array<char, 4096> path{};
};

std::array<Slot, 16> slots;

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& path)
{
    const std::string& text = path.native();
    if (text.size() >= slots[0].path.size())
        return;
    for (size_t k = 0; k < slots.size(); ++k) {
        int expected = Slot::free;
        if (!slots[k].state.compare_exchange_strong(expected, Slot::being_filled))
            continue;
        std::memcpy(slots[k].path.data(), text.c_str(), text.size() + 1);
        slots[k].state = Slot::filled;
        slot_ = static_cast<int>(k);
        return;
    }
}

UnfinishedFile::UnfinishedFile(UnfinishedFile&& other) noexcept : slot_(std::exchange(other.slot_, -1)) {}

UnfinishedFile::~UnfinishedFile()
{
    if (slot_ >= 0)
        slots[static_cast<size_t>(slot_)].state = Slot::free;
}

void removeUnfinishedFiles() noexcept
{
    for (const Slot& slot : slots)
        if (slot.state == Slot::filled)
            ::unlink(slot.path.data());
}

}  // namespace knotspan::formats
