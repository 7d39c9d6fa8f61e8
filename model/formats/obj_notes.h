// What the user is told about an OBJ file: what was not read, and why.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "model/files/format.h"

namespace knotspan::formats {

class ObjNotes {
public:
    // Whether the statement is one that is not read; those that would have been seen are counted.
    bool skip(std::string_view keyword);

    void countSurface() { ++surfaces_; }
    [[nodiscard]] int surfaces() const { return surfaces_; }
    void leaveOut(int line, const std::string& reason);
    void leaveUntrimmed(int line, const std::string& reason);

    [[nodiscard]] std::vector<std::string> sentences() const;
    // Why nothing came of the file.
    [[nodiscard]] tl::unexpected<Error> refusal() const;

private:
    struct Tally {
        int count = 0;
        std::string first;
        void add(int line, const std::string& reason);
    };
    enum class Skipped { meshLine, spaceCurve, special, connection, call, oldPatch };

    std::array<int, 6> skipped_{};
    int surfaces_ = 0;
    Tally leftOut_;
    Tally untrimmed_;
};

}  // namespace knotspan::formats
