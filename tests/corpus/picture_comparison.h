// Whether a picture of ours shows what OpenCASCADE's mesh of the same file shows, from the same place.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/corpus/layered_picture.h"

namespace knotspan::corpus {

// What our picture shows: which face of the file at each pixel, and -1 where none. Rows from the top.
struct ShownFaces {
    int width = 0;
    int height = 0;
    std::vector<int> faces;

    [[nodiscard]] int at(int x, int y) const
    {
        return faces[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

// How a pixel differs.
enum class Fault : std::uint8_t {
    none,
    missing,    // theirs shows something, ours nothing within a pixel of it
    surplus,    // the other way round
    gap,        // ours shows nothing, theirs something there and all around
    leak,       // where faces meet within a pixel, ours shows what theirs hides behind them
    otherFace,  // the same elsewhere: a hole that is missing or too many
};

struct PictureDifference {
    int width = 0;
    std::vector<Fault> faults;  // by pixel
    size_t silhouette = 0;      // pixels of theirs beside one that shows nothing
    size_t unlike = 0;          // pixels that one covers and the other does not
    size_t offSilhouette = 0;   // missing or surplus
    size_t gaps = 0;
    size_t leaks = 0;
    size_t wide =
        0;  // blocks of two by two pixels that are gaps, leaks or other faces: a pixel wide and more
    size_t shown = 0;  // pixels that theirs covers
    size_t otherFaces = 0;

    [[nodiscard]] double ratio() const
    {
        return silhouette == 0 ? 0 : static_cast<double>(offSilhouette) / static_cast<double>(silhouette);
    }
};

// `depthSlack`: faces that lie this near behind each other may both show, model units.
[[nodiscard]] PictureDifference differenceOf(const ShownFaces& ours, const LayeredPicture& theirs,
                                             double depthSlack);

}  // namespace knotspan::corpus
