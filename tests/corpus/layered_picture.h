// A picture of triangles made on the CPU, with every layer that a pixel's centre meets: a second opinion on
// what the renderer draws, sharing nothing with it but the camera.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/scene/camera.h"
#include "tests/corpus/fine_mesh.h"

namespace knotspan::corpus {

struct Layer {
    float depth = 0;  // along the view, model units
    int face = 0;
};

class LayeredPicture {
public:
    LayeredPicture(const FineMesh& mesh, const Camera& camera, int width, int height);

    struct Layers {
        const Layer* first;
        const Layer* last;
        [[nodiscard]] const Layer* begin() const { return first; }
        [[nodiscard]] const Layer* end() const { return last; }
        [[nodiscard]] bool empty() const { return first == last; }
    };
    // Nearest first.
    [[nodiscard]] Layers at(int x, int y) const
    {
        const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
        return {layers_.data() + starts_[pixel], layers_.data() + starts_[pixel + 1]};
    }
    [[nodiscard]] bool covered(int x, int y) const { return !at(x, y).empty(); }
    // Whether a face passes the pixel that is seen on edge there, thinner than kThinPx, at a depth up to
    // `depth`: it may show or not, but covers nothing here unless it meets the centre.
    [[nodiscard]] bool onEdge(int x, int y, int face, double depth) const;
    static constexpr double kThinPx = 0.05;

private:
    struct Fragment {
        std::uint32_t pixel;
        Layer layer;
    };
    void paint(const Vec3 (&corners)[3], bool orthographic, int face);
    void markOnEdge(const Vec3 (&corners)[3], int face);
    void sortByPixel();

    int width_;
    int height_;
    std::vector<Fragment> fragments_;
    std::vector<Fragment> onEdge_;       // by pixel
    std::vector<Layer> nearestOnEdge_;   // of the last face that passed each pixel
    std::vector<std::uint32_t> starts_;  // by pixel, and the end
    std::vector<Layer> layers_;
};

}  // namespace knotspan::corpus
