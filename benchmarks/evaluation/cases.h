// What the peers evaluate: the same surfaces at the same grids.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "model/geometry/nurbs_surface.h"

namespace knotspan::benchmarks {

struct Case {
    std::string name;                    // "10x10 degree 3, rational, 65^2"
    std::vector<NurbsSurface> surfaces;  // all are evaluated in one go
    std::vector<double> parameters;      // of the grid, in both directions; the domain is [0, 1]

    [[nodiscard]] double points() const
    {
        const auto side = static_cast<double>(parameters.size());
        return side * side * static_cast<double>(surfaces.size());
    }
};

// {10x10 bicubic, nine 4x4 Beziers, 50x50 bicubic, 20x20 degree 5, 20x20 degree 9} x {polynomial, rational} x
// grids of 65^2 and 257^2 points.
[[nodiscard]] const std::vector<Case>& cases();

// Registers `body` as "who: case": what it does inside its loop is one evaluation of all the case's points.
void add(const std::string& who, const Case& what, std::function<void(benchmark::State&)> body);

// What one core can do at best.
void addCeiling();

// One function a peer; each registers itself for every case.
void addOurs(const Case& what);
void addOcct(const Case& what);
void addSisl(const Case& what);

}  // namespace knotspan::benchmarks
