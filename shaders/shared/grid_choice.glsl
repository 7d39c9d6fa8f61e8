// The grid of few cells that keeps a KSQuad within a tolerance in pixels: the bound of model/analysis/screen_error.h, as
// the sampling pass computes it; the same text for GLSL and for C++.
//
// The promise: of a grid n_u x n_v, every triangle between points of the surface whose box in the KSQuad's parameters is no
// wider than 1 / n_u and no higher than 1 / n_v, wherever that box lies, is within the tolerance where the picture shows it.
//
// A window is a part of the KSQuad. Over a triangle inside it the distance on screen is |E.xy - s E.w| / w: E the error of
// linear interpolation in homogeneous pixels, s a shown point of the triangle, w the surface's. Second derivatives bound E;
// those of the window's Bezier net lie in a box, whose middle counts as if they were constant, and whose size, with what
// other s of the window would change, is added (spread). One net for the whole KSQuad says whether one cell is enough, and
// about which factors are (first_grid.glsl); then 4 x 4 windows or more that overlap, so large that each triangle's box lies in one, say
// it more closely.
#ifndef KNOTSPAN_GRID_CHOICE_GLSL
#define KNOTSPAN_GRID_CHOICE_GLSL

#include "pixel_map.glsl"

#ifdef __cplusplus
#include <glm/common.hpp>

namespace knotspan::gpu {
using std::abs;
using std::pow;
using std::sqrt;
#endif

#define GRID_LARGEST 1024u       // cells along one side that are ever asked for
#define GRID_LANES 16u           // windows of a KSQuad; and candidates that are tried beside each other
#define GRID_LEVELS 5u
#define GRID_FEW_CELLS 48u  // for so many and fewer the next level costs more than it saves
#define GRID_MOST_LEAST 8u       // beyond that many cells smaller windows gain little
#define GRID_NONE 0xffffffffu    // no grid within GRID_LARGEST
#define GRID_HUGE 3.0e38f
// Of the numbers that a net's points are summed from: what float arithmetic may be off. In double it costs nothing.
#define GRID_ROUNDING 4.8e-7f

// Where a KSQuad's numbers are.
struct KsQuadPlace {
    uint firstPoint;
    uint stride;
    uint tableU;  // its spans' Bezier matrices: row k has the shares of the control points in Bezier point k
    uint tableV;
    int degreeU;
    int degreeV;
};

// The part [start, end] of a direction.
KNOTSPAN_TEMPLATE
struct Stretch {
    Real start;
    Real end;
};

KNOTSPAN_TEMPLATE
struct WindowFigures {
    KNOTSPAN_VEC2 a;  // second derivatives by the KSQuad's t as the window's middle sees them: along u twice
    KNOTSPAN_VEC2 b;  // along u and v
    KNOTSPAN_VEC2 c;  // along v twice
    KNOTSPAN_VEC3 spread;   // of a, b, c
    KNOTSPAN_VEC3 inW;      // the largest of w; zero where all of the window is in front of the near plane
    Real nearest;           // the least w of what shows
    bool visible;
};

// Window `number` of `count` along a direction, for factors of at least `least`: each stretch of 1 / least lies in one of
// them.
KNOTSPAN_TEMPLATE
Stretch KNOTSPAN_OF_REAL windowStretch(uint number, uint count, uint least)
{
    Stretch KNOTSPAN_OF_REAL stretch;
    stretch.start = Real(0);
    stretch.end = Real(1);
    if (count > 1u) {
        // A little longer, so that rounding leaves no gap.
        Real size = (Real(1) + Real(1.0001f) * Real(count - 1u) / Real(least)) / Real(count);
        stretch.start = (Real(1) - size) * Real(number) / Real(count - 1u);
        stretch.end = min(stretch.start + size, Real(1));
    }
    return stretch;
}

// The smallest box of some numbers.
KNOTSPAN_TEMPLATE
struct NumberBox {
    KNOTSPAN_VEC3 low;
    KNOTSPAN_VEC3 high;
};

KNOTSPAN_TEMPLATE
NumberBox KNOTSPAN_OF_REAL emptyBox()
{
    NumberBox KNOTSPAN_OF_REAL box;
    box.low = KNOTSPAN_VEC3(Real(GRID_HUGE));
    box.high = KNOTSPAN_VEC3(Real(-GRID_HUGE));
    return box;
}

// With a second difference of points (x, y, z, w): x, y and w count.
KNOTSPAN_TEMPLATE
NumberBox KNOTSPAN_OF_REAL including(NumberBox KNOTSPAN_OF_REAL box, KNOTSPAN_VEC4 d)
{
    KNOTSPAN_VEC3 value = KNOTSPAN_VEC3(d.x, d.y, d.w);
    box.low = min(box.low, value);
    box.high = max(box.high, value);
    return box;
}

// A derivative's middle, as seen from `middle`, and its spread for s no further than `radius` from there.
KNOTSPAN_TEMPLATE
struct SeenFigure {
    KNOTSPAN_VEC2 value;
    Real spread;
    Real inW;
};

KNOTSPAN_TEMPLATE
SeenFigure KNOTSPAN_OF_REAL seenFigure(NumberBox KNOTSPAN_OF_REAL box, Real scale, KNOTSPAN_VEC3 rounding,
                                       KNOTSPAN_VEC2 middle, Real radius)
{
    SeenFigure KNOTSPAN_OF_REAL figure;
    figure.value = KNOTSPAN_VEC2(Real(0));
    figure.spread = Real(0);
    figure.inW = Real(0);
    if (scale == Real(0))
        return figure;
    KNOTSPAN_VEC3 at = Real(0.5f) * scale * (box.low + box.high);
    KNOTSPAN_VEC3 size = scale * (Real(0.5f) * (box.high - box.low) + rounding);
    figure.value = KNOTSPAN_VEC2(at) - at.z * middle;
    figure.inW = abs(at.z) + size.z;
    figure.spread = length(KNOTSPAN_VEC2(size) + size.z * abs(middle)) + radius * figure.inW;
    return figure;
}

// Reads the control points as they come and keeps three rows of the window's net.
KNOTSPAN_SOURCE_TEMPLATE
WindowFigures KNOTSPAN_OF_REAL windowFigures(KNOTSPAN_SOURCE KsQuadPlace place, PixelMap KNOTSPAN_OF_REAL map,
                                             Stretch KNOTSPAN_OF_REAL u, Stretch KNOTSPAN_OF_REAL v)
{
    int p = place.degreeU;
    int q = place.degreeV;
    // Coordinates are taken from a control point, and pixels from where it falls: small numbers round little.
    KNOTSPAN_VEC4 centre = KNOTSPAN_POINT(place.firstPoint + uint(p / 2) * place.stride + uint(q / 2));
    KNOTSPAN_VEC3 origin = KNOTSPAN_VEC3(centre) / centre.w;
    KNOTSPAN_VEC4 local = KNOTSPAN_VEC4(origin, Real(1));
    KNOTSPAN_VEC4 moved = KNOTSPAN_VEC4(dot(map.x, local), dot(map.y, local), dot(map.z, local), dot(map.w, local));
    KNOTSPAN_VEC2 from = KNOTSPAN_VEC2(Real(0));
    if (moved.w > Real(0))
        from = min(max(KNOTSPAN_VEC2(moved) / moved.w, -map.middle), map.middle);
    KNOTSPAN_VEC4 rowX = KNOTSPAN_VEC4(KNOTSPAN_VEC3(map.x - from.x * map.w), moved.x - from.x * moved.w);
    KNOTSPAN_VEC4 rowY = KNOTSPAN_VEC4(KNOTSPAN_VEC3(map.y - from.y * map.w), moved.y - from.y * moved.w);
    KNOTSPAN_VEC4 rowZ = KNOTSPAN_VEC4(KNOTSPAN_VEC3(map.z), moved.z);
    KNOTSPAN_VEC4 rowW = KNOTSPAN_VEC4(KNOTSPAN_VEC3(map.w), moved.w);
    KNOTSPAN_VEC2 low = -map.middle - KNOTSPAN_VEC2(Real(1)) - from;  // a pixel more, for rounding
    KNOTSPAN_VEC2 high = map.middle + KNOTSPAN_VEC2(Real(1)) - from;

    NumberBox KNOTSPAN_OF_REAL boxA = emptyBox KNOTSPAN_OF_REAL();
    NumberBox KNOTSPAN_OF_REAL boxB = boxA;
    NumberBox KNOTSPAN_OF_REAL boxC = boxA;
    NumberBox KNOTSPAN_OF_REAL shown = boxA;  // x and y on screen
    Real nearest = Real(GRID_HUGE);
    Real depth = Real(GRID_HUGE);
    Real extent = Real(0);  // squared
    Real heaviest = Real(0);
    bool front = true;
    uint beyond = 31u;  // sides of the picture beyond which all points are
    KNOTSPAN_VEC4 before[KNOTSPAN_MAX_ORDER];
    KNOTSPAN_VEC4 beforeThat[KNOTSPAN_MAX_ORDER];
    for (int l = 0; l <= q; ++l) {
        // How much each Bezier point along v counts for point l of the window: the blossom at (q - l) times the start
        // and l times the end; then each control point.
        Real share[KNOTSPAN_MAX_ORDER];
        share[0] = Real(1);
        for (int d = 1; d <= q; ++d) {
            Real t = d <= l ? v.end : v.start;
            share[d] = t * share[d - 1];
            for (int m = d - 1; m > 0; --m)
                share[m] = (Real(1) - t) * share[m] + t * share[m - 1];
            share[0] *= Real(1) - t;
        }
        Real count[KNOTSPAN_MAX_ORDER];
        for (int j = 0; j <= q; ++j) {
            Real sum = Real(0);
            for (int m = 0; m <= q; ++m)
                sum += share[m] * KNOTSPAN_TABLE(place.tableV + uint(m * (q + 1) + j));
            count[j] = sum;
        }
        KNOTSPAN_VEC4 given[KNOTSPAN_MAX_ORDER];
        for (int i = 0; i <= p; ++i) {
            KNOTSPAN_VEC4 sum = KNOTSPAN_VEC4(Real(0));
            for (int j = 0; j <= q; ++j) {
                KNOTSPAN_VEC4 point = KNOTSPAN_POINT(place.firstPoint + uint(i) * place.stride + uint(j));
                KNOTSPAN_VEC3 offset = KNOTSPAN_VEC3(point) - point.w * origin;
                extent = max(extent, dot(offset, offset));
                heaviest = max(heaviest, point.w);
                sum += count[j] * KNOTSPAN_VEC4(offset, point.w);
            }
            given[i] = sum;
        }
        KNOTSPAN_VEC4 net[KNOTSPAN_MAX_ORDER];
        for (int k = 0; k <= p; ++k) {
            KNOTSPAN_VEC4 sum = KNOTSPAN_VEC4(Real(0));
            for (int i = 0; i <= p; ++i)
                sum += KNOTSPAN_TABLE(place.tableU + uint(k * (p + 1) + i)) * given[i];
            net[k] = KNOTSPAN_VEC4(dot(rowX, sum), dot(rowY, sum), dot(rowZ, sum), dot(rowW, sum));
        }
        // Cut off beyond the end, then, read backwards, before the start. Few places where arrays are read or written:
        // each is much code for a software driver.
        for (int pass = 0; pass < 2; ++pass) {
            Real own = pass == 0 ? u.end : Real(1) - u.start / u.end;
            if (own == Real(1))
                continue;
            for (int d = 1; d <= p; ++d)
                for (int k = p; k >= d; --k) {
                    int at = pass == 0 ? k : p - k;
                    net[at] = own * net[at] + (Real(1) - own) * net[pass == 0 ? at - 1 : at + 1];
                }
        }
        KNOTSPAN_VEC4 last = KNOTSPAN_VEC4(Real(0));  // net[k - 1]
        KNOTSPAN_VEC4 lastButOne = last;
        KNOTSPAN_VEC4 lastBefore = last;  // before[k - 1]
        for (int k = 0; k <= p; ++k) {
            KNOTSPAN_VEC4 at = net[k];
            front = front && at.z <= at.w && at.w > Real(0);
            nearest = min(nearest, at.w);
            depth = min(depth, at.z);
            if (front) {
                KNOTSPAN_VEC2 on = KNOTSPAN_VEC2(at) / at.w;
                shown = including KNOTSPAN_OF_REAL(shown, KNOTSPAN_VEC4(on, Real(0), Real(0)));
            }
            beyond &= (at.x < low.x * at.w ? 1u : 0u) | (at.x > high.x * at.w ? 2u : 0u) |
                      (at.y < low.y * at.w ? 4u : 0u) | (at.y > high.y * at.w ? 8u : 0u) |
                      (at.z - at.w > Real(GRID_ROUNDING) * (abs(at.z) + abs(moved.w)) ? 16u : 0u);
            if (k > 1)
                boxA = including KNOTSPAN_OF_REAL(boxA, (at + lastButOne) - Real(2) * last);
            if (l > 0) {
                KNOTSPAN_VEC4 below = before[k];
                if (k > 0)
                    boxB = including KNOTSPAN_OF_REAL(boxB, (at - last) - (below - lastBefore));
                if (l > 1)
                    boxC = including KNOTSPAN_OF_REAL(boxC, (at + beforeThat[k]) - Real(2) * below);
                beforeThat[k] = below;
                lastBefore = below;
            }
            before[k] = at;
            lastButOne = last;
            last = at;
        }
    }

    extent = sqrt(extent);
    Real roundingW = Real(GRID_ROUNDING) * (length(KNOTSPAN_VEC3(rowW)) * extent + abs(rowW.w) * heaviest);
    KNOTSPAN_VEC3 rounding =
        Real(4) * KNOTSPAN_VEC3(Real(GRID_ROUNDING) * (length(KNOTSPAN_VEC3(rowX)) * extent + abs(rowX.w) * heaviest),
                                Real(GRID_ROUNDING) * (length(KNOTSPAN_VEC3(rowY)) * extent + abs(rowY.w) * heaviest),
                                roundingW);
    if (front) {
        low = max(low, KNOTSPAN_VEC2(shown.low));
        high = min(high, KNOTSPAN_VEC2(shown.high));
    } else {
        nearest = max(nearest, depth);  // what shows has w >= z
    }
    KNOTSPAN_VEC2 middle = Real(0.5f) * (low + high);
    Real radius = Real(0.5f) * length(high - low) + Real(0.001f);
    Real sizeU = u.end - u.start;
    Real sizeV = v.end - v.start;
    SeenFigure KNOTSPAN_OF_REAL a =
        seenFigure KNOTSPAN_OF_REAL(boxA, Real(p * (p - 1)) / (sizeU * sizeU), rounding, middle, radius);
    SeenFigure KNOTSPAN_OF_REAL b =
        seenFigure KNOTSPAN_OF_REAL(boxB, Real(p * q) / (sizeU * sizeV), rounding, middle, radius);
    SeenFigure KNOTSPAN_OF_REAL c =
        seenFigure KNOTSPAN_OF_REAL(boxC, Real(q * (q - 1)) / (sizeV * sizeV), rounding, middle, radius);
    WindowFigures KNOTSPAN_OF_REAL figures;
    figures.a = a.value;
    figures.b = b.value;
    figures.c = c.value;
    figures.spread = KNOTSPAN_VEC3(a.spread, b.spread, c.spread);
    figures.inW = front ? KNOTSPAN_VEC3(Real(0)) : KNOTSPAN_VEC3(a.inW, b.inW, c.inW);
    figures.nearest = nearest - roundingW;
    figures.visible = beyond == 0u;
    return figures;
}

// 8 times a bound of the error of any triangle in a cell over which the second derivatives (times the cell's size) differ
// from a, b, c by no more than the spread. At barycentric place l_i the error is at most half of
// |M : H| + M_11 spread_a + 2 sum l_i |d_ix d_iy| spread_b + M_22 spread_c, M = sum l_i d_i d_i^T, d_i to the corners; the
// sum in it is at most (M_11 + M_22) / 2. M is positive semidefinite with M_11, M_22 <= 1/4, so it lies in a quarter of the
// hull of (1, t; t, t^2) and (t^2, t; t, 1), |t| <= 1, and that in the hull of t = 0, (1, t/2; t/2, 0), (0, t/2; t/2, 1)
// and (1, t; t, 1) for t = 1 and -1.
KNOTSPAN_TEMPLATE
Real largestError(KNOTSPAN_VEC2 a, KNOTSPAN_VEC2 b, KNOTSPAN_VEC2 c, KNOTSPAN_VEC3 spread)
{
    Real alongU = dot(a, a) + abs(Real(2) * dot(a, b)) + dot(b, b);  // the larger of |a + b|^2 and |a - b|^2
    Real alongV = dot(c, c) + abs(Real(2) * dot(c, b)) + dot(b, b);
    alongU = max(alongU, dot(a, a));
    alongV = max(alongV, dot(c, c));
    KNOTSPAN_VEC2 sum = a + c;
    Real across = dot(sum, sum) + Real(4) * (abs(dot(sum, b)) + dot(b, b));
    return max(sqrt(across) + spread.x + Real(2) * spread.y + spread.z,
               max(sqrt(alongU) + spread.x, sqrt(alongV) + spread.z) + spread.y);
}

// A bound, in pixels, of the error of triangles of size (hu, hv) in the window. Where there is none: not a number or huge.
KNOTSPAN_TEMPLATE
Real windowBound(WindowFigures KNOTSPAN_OF_REAL figures, Real hu, Real hv)
{
    if (!figures.visible)
        return Real(0);
    KNOTSPAN_VEC3 sizes = KNOTSPAN_VEC3(hu * hu, hu * hv, hv * hv);
    Real error = largestError KNOTSPAN_OF_REAL(sizes.x * figures.a, sizes.y * figures.b, sizes.z * figures.c,
                                               sizes * figures.spread);
    Real w = figures.nearest - Real(0.125f) * (dot(sizes, figures.inW) + sizes.y * figures.inW.y);
    return w > Real(0) ? Real(0.125f) * error / w : Real(GRID_HUGE);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
