// Basis functions at eight parameters at once, whatever spans these lie on: compiled once for each
// instruction set and chosen while running.
#pragma once

#include <cstddef>
#include <cstdint>

namespace knotspan::kernels {

constexpr size_t kBasisLanes = 8;

// Of one direction: tables[l] is where in `numbers` the table of lane l's span starts (span_tables.h).
struct BasisRequest {
    const double* numbers = nullptr;
    int degree = 1;
    int order = 0;  // the rows of derivatives up to this one, 0 .. 2
    std::int64_t tables[kBasisLanes] = {};
    double t[kBasisLanes] = {};
};

// rows[b][k][l]: of lane l the k-th function of degree `degree - b`.
struct alignas(64) BasisLanes {
    double rows[3][16][kBasisLanes];
};

void basisFunctions(const BasisRequest& request, BasisLanes& lanes);

}  // namespace knotspan::kernels
