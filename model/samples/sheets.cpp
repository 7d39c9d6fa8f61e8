#include <cmath>

#include "model/samples/net.h"
#include "model/samples/samples.h"

namespace knotspan {

// A sheet with two wave trains across each other, 9 x 9 units, +z up.
Scene makeSingle100()
{
    const KnotVector knots = KnotVector::clampedUniform(3, 7);
    const auto wave = [&](int i, int j) -> ControlPoint {
        const double x = 9 * grevilleAbscissa(knots, i) - 4.5;
        const double y = 9 * grevilleAbscissa(knots, j) - 4.5;
        return {{x, y, 1.1 * std::sin(0.9 * x + 0.35 * y) + 0.8 * std::cos(0.95 * y - 0.3 * x)}, 1};
    };
    Scene scene;
    scene.add(namedObject("Sheet", colourOf(205, 0.45, 0.85), surfaceOf(knots, knots, wave)));
    return scene;
}

// Nine cushions: each bulges to its own height, neighbours share straight seams and nothing more.
Scene makeNine16()
{
    const KnotVector knots = KnotVector::clampedUniform(3, 1);
    Scene scene;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) {
            const double height = 1.1 + 0.45 * ((column + 2 * row) % 3);
            const auto cushion = [&](int i, int j) -> ControlPoint {
                const bool inside = i % 3 != 0 && j % 3 != 0;
                return {{3 * column + i - 4.5, 3 * row + j - 4.5, inside ? height : 0.0}, 1};
            };
            scene.add(namedObject("Cushion " + std::to_string(3 * column + row + 1),
                                  colourOf(20 + 40.0 * (3 * column + row), 0.4, 0.88),
                                  surfaceOf(knots, knots, cushion)));
        }
    return scene;
}

}  // namespace knotspan
