// How much OpenCASCADE mends of the shapes that it reads.
#pragma once

#include <XSAlgo_AlgoContainer.hxx>

namespace knotspan::formats {

// While one lives, boundaries of more than 200 edges are taken as they are where they are complete,
// and are else not searched for places where they cross themselves: OpenCASCADE does that in cubic time,
// hours for 10,000 edges. We say where loops cross. Shorter boundaries are mended as always.
class SwiftHealing {
public:
    SwiftHealing();
    ~SwiftHealing();
    SwiftHealing(const SwiftHealing&) = delete;
    SwiftHealing& operator=(const SwiftHealing&) = delete;

private:
    Handle(XSAlgo_AlgoContainer) before_;
};

}  // namespace knotspan::formats
