// The vertices along faces' outlines, which all who meet there use: as many as the one asks for that needs
// the most.
#pragma once

#include <optional>

#include "model/mesh/face_errors.h"
#include "model/mesh/outline_weld.h"

namespace knotspan {

class OutlineSamples {
public:
    struct Sample {
        std::uint32_t vertex = 0;
        std::vector<double> t;  // on the arc of each of the seam's stretches
    };

    // All have to stay. Vertices along an edge are no nearer to each other than `same`.
    OutlineSamples(const std::vector<OutlinedFace>& faces, const OutlineWeld& weld, double same,
                   const std::vector<FaceErrors>& errors);

    // Of a seam, along its first stretch, ends included.
    [[nodiscard]] const std::vector<Sample>& of(std::uint32_t seam) const { return samples_[seam]; }
    [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }
    // One more in the middle of two that follow each other; false where they are too near to each other.
    bool split(std::uint32_t seam, size_t segment);
    // How far a face's own points are from those vertices, at most.
    [[nodiscard]] double gap(std::uint32_t face) const { return gaps_[face]; }

private:
    static constexpr std::uint32_t kUnknownVertex = 0xffffffffU;

    void sampleSeam(std::uint32_t seam, size_t fewest);
    [[nodiscard]] std::vector<Sample> forcedOn(std::uint32_t seam) const;
    void dropNextToEnds(std::uint32_t seam, std::vector<Sample>& samples) const;
    [[nodiscard]] std::optional<double> middleOf(std::uint32_t seam, double from, double to) const;
    [[nodiscard]] Sample between(std::uint32_t seam, const Sample& a, const Sample& b, double t) const;
    void complete(std::uint32_t seam, std::vector<Sample>& samples) const;
    void place(std::uint32_t seam, Sample& sample);
    [[nodiscard]] bool isFine(std::uint32_t seam, size_t segment) const;
    [[nodiscard]] const OutlineStretch& stretch(std::uint32_t seam, size_t member) const
    {
        return weld_.stretches[weld_.seams[seam].stretches[member]];
    }
    [[nodiscard]] const OutlinedFace& face(std::uint32_t seam, size_t member) const
    {
        return faces_[stretch(seam, member).face];
    }

    const std::vector<OutlinedFace>& faces_;
    const OutlineWeld& weld_;
    double same_;
    const std::vector<FaceErrors>& errors_;
    std::vector<std::vector<Sample>> samples_;
    std::vector<Vec3> positions_;
    std::vector<double> gaps_;
};

}  // namespace knotspan
