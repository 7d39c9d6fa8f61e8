// What became of the faces of a file that another program wrote, and how a reader tells how far it is.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace knotspan::formats {

struct RefusedFace {
    std::string name;
    std::string reason;
};

// Of formats that hold nothing but what Knotspan has, no faces are told of.
struct ImportReport {
    int faces = 0;         // in the file
    int exact = 0;         // whose surface is the file's own, to rounding
    int approximated = 0;  // whose surface no NURBS surface equals
    int refused = 0;       // left out
    int untrimmed = 0;     // of the exact and approximated: whose boundary could not be followed
    // The largest distance measured between the file's surface and ours where it is approximated, in the
    // scene's units.
    double approximationError = 0;
    std::vector<RefusedFace> refusals;  // the first hundred
    std::string fileUnits;              // the unit the file was in, before conversion; empty: it names none
    double seconds = 0;                 // that reading took, by the clock
    // The most memory that the process which read it had in use; 0: it was read in this one.
    std::uint64_t peakBytes = 0;
};

// Called while a file is read, from the reading thread: what is done now, and how much of all is done, 0 to
// 1; below 0 where nobody knows.
using ImportProgress = std::function<void(const std::string& stage, double done)>;

}  // namespace knotspan::formats
