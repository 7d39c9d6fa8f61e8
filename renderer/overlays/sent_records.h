// Records of an overlay in a buffer of their own, that travel only where they differ from those that the
// device has.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "renderer/vulkan/pipeline.h"

namespace knotspan {

template <class Record>
class SentRecords {
public:
    SentRecords(Bindings& bindings, Uploader& uploader, int binding)
        : bindings_(bindings),
          uploader_(uploader),
          binding_(binding)
    {
    }

    void send(std::vector<Record> records)
    {
        if (isHeld(records))
            return;
        if (!records.empty()) {
            uploader_.forget(buffer_);
            bindings_.provide(binding_, buffer_, records.size() * sizeof(Record));
            uploader_.write(buffer_, 0, std::span(std::as_const(records)));
        }
        held_ = std::move(records);
    }
    // What was written may not have arrived.
    void forget() { held_.clear(); }

    [[nodiscard]] bool isEmpty() const { return held_.empty(); }
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(held_.size()); }

private:
    [[nodiscard]] bool isHeld(const std::vector<Record>& records) const
    {
        return records.size() == held_.size() &&
               (held_.empty() ||
                std::memcmp(records.data(), held_.data(), held_.size() * sizeof(Record)) == 0);
    }

    Bindings& bindings_;
    Uploader& uploader_;
    int binding_;
    Buffer buffer_;
    std::vector<Record> held_;
};

}  // namespace knotspan
