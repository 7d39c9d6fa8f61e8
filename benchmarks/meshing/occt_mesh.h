// The same surfaces meshed by OpenCASCADE.
#pragma once

#include <memory>

#include "model/mesh/deviation_measuring.h"

namespace knotspan::benchmarks {

class OcctMesh {
public:
    // The visible objects, each a face of its own.
    explicit OcctMesh(const Scene& scene);
    ~OcctMesh();
    OcctMesh(const OcctMesh&) = delete;
    OcctMesh& operator=(const OcctMesh&) = delete;

    // BRepMesh_IncrementalMesh on one thread, to a deflection alone: no angle makes it finer. Seconds.
    double make(double deflection);
    [[nodiscard]] size_t triangleCount() const;
    // As measuredDeviation(): at the same places of each triangle's parameters.
    [[nodiscard]] double measured() const;

private:
    struct Faces;
    std::unique_ptr<Faces> faces_;
};

}  // namespace knotspan::benchmarks
