// A STEP, IGES or BREP file as Knotspan draws it beside what OpenCASCADE makes of it, from six sides and in
// perspective.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "tests/corpus/corpora.h"

namespace knotspan::corpus {

// How much of a silhouette may be off by more than a pixel.
inline constexpr double kMostOff = 1e-3;
// How many of the pixels may show another face: triangles that are seen on edge have any depth.
inline constexpr double kMostStray = 1e-5;

struct ComparedFile {
    std::string corpus;
    std::string file;
    std::string format;
    std::string unread;  // why there is nothing to compare; empty: there is
    int faces = 0;
    int trimmed = 0;    // drawn with loops
    int untrimmed = 0;  // whose loops could not be followed
    int refused = 0;    // left out by us
    int unmeshed = 0;   // left out by OpenCASCADE
    double worst = 0;   // share of the silhouette's pixels that are off, in the worst view
    std::string worstView;
    // Pixels of all views (picture_comparison.h).
    size_t silhouette = 0;
    size_t unlike = 0;
    size_t gaps = 0;
    size_t leaks = 0;
    size_t wide = 0;
    size_t otherFaces = 0;
    size_t shown = 0;
    double slackPx = 0;  // how far the file says that its own edges may be off

    [[nodiscard]] bool agrees() const
    {
        return worst <= kMostOff && wide == 0 &&
               static_cast<double>(otherFaces) <= kMostStray * static_cast<double>(shown);
    }
};

// With a folder, pictures of the views that differ go there: ours, theirs, and red where ours lacks
// something, blue where it has too much, yellow where another face shows, pink and green where faces gape.
[[nodiscard]] ComparedFile comparedPictures(Renderer& renderer, const ModelFile& file,
                                            const std::optional<std::filesystem::path>& pictures);

// "STEP", "IGES", "BREP"; empty: another format, of which OpenCASCADE makes nothing.
[[nodiscard]] std::string cadFormatOf(const ModelFile& file);

// A line of tab-separated values, and what they are.
[[nodiscard]] std::string lineOf(const ComparedFile& compared);
[[nodiscard]] std::string headerOfComparisons();
// In Markdown: a row a corpus and format.
[[nodiscard]] std::string tableOf(const std::vector<ComparedFile>& compared);

}  // namespace knotspan::corpus
