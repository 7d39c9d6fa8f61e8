// How far from a pixel's centre the border runs of what trim loops leave, along the picture's axes: for pixels that show a
// trimmed surface. Those that are hidden cost nothing.
#ifndef KNOTSPAN_TRIM_EDGE_GLSL
#define KNOTSPAN_TRIM_EDGE_GLSL

#include "../shared/trim_edge_code.glsl"
#include "../shared/trimming_words.glsl"
#include "../shared/pixel_aim.glsl"

// Pixels along kTrimSides; where it is above TRIM_EDGE_REACH nobody asks.
#define FAR_FROM_EDGES vec4(2.0)

void meetAlongAxis(float here, float other, float before, float after, float low, float high, inout vec2 distances)
{
    if (before == after)
        return;
    float k = before / (before - after);
    if (k < low || k > high)
        return;
    float at = mix(here, other, k);
    if (at >= 0.0)
        distances.x = min(distances.x, at);
    else
        distances.y = min(distances.y, -at);
}

// Takes a piece's distances into account. `centre` in the KSQuad; `toPixels` turns changes there into pixels.
void meetPiece(TrimPiece piece, vec2 centre, mat2 toPixels, vec2 scale, inout vec4 distances)
{
    const float kStraight = 1.0;  // pixels: what is left of a piece is a line
    vec2 from = piece.first - centre;
    vec2 to = piece.last - centre;
    float below = 0.0;
    float above = 1.0;
    int steps = trimIsLine(piece) ? 0 : TRIM_STEPS;
    for (int step = 0; step < steps; ++step) {
        vec2 way = (to - from) * scale;
        if (max(abs(way.x), abs(way.y)) < kStraight)
            break;
        // The part that comes nearest: by the axis along which it is longer.
        float s = 0.5 * (below + above);
        vec2 at = trimPlace(piece, s) - centre;
        bool isPast = abs(way.x) > abs(way.y) ? at.x * way.x > 0.0 : at.y * way.y > 0.0;
        if (isPast) {
            to = at;
            above = s;
        } else {
            from = at;
            below = s;
        }
    }
    // A part goes on as a line, by two pixels; the whole piece ends where it ends.
    vec2 a = toPixels * from;
    vec2 b = toPixels * to;
    float more = 2.0 / max(length(b - a), 1e-3);
    float low = below == 0.0 ? 0.0 : -more;
    float high = above == 1.0 ? 1.0 : 1.0 + more;
    vec2 across = distances.xy;
    vec2 along = distances.zw;
    meetAlongAxis(a.x, b.x, a.y, b.y, low, high, across);
    meetAlongAxis(a.y, b.y, a.x, b.x, low, high, along);
    distances = vec4(across, along);
}

// What a KSQuad's record says of a place: whether it is inside, and how far the curves are that run near.
struct PlaceInLoops {
    bool inside;
    vec4 distances;
};

PlaceInLoops placeInLoops(uint record, vec2 centre, mat2 toPixels, vec2 reach)
{
    PlaceInLoops found = PlaceInLoops(false, FAR_FROM_EDGES);
    vec2 t = vec2(centre.x, min(centre.y, TRIM_BELOW_ONE));  // as trimRecordContains() has it
    vec2 low = centre - reach;
    vec2 high = centre + reach;
    vec2 scale = vec2(length(toPixels[0]), length(toPixels[1]));
    uint bands = trimWords[record + 1u];
    uint entries = record + 2u;
    for (uint k = trimEntry(entries, 3u, bands, low.y); k < bands; ++k) {
        uint band = entries + 3u * k;
        float bottom = trimNumber(band);
        if (bottom > max(high.y, 0.0))
            break;
        bool isHere = bottom <= t.y && (k + 1u == bands || trimNumber(band + 3u) > t.y);
        uint count = trimWords[band + 2u];
        if (isHere)
            found.inside = (count & 1u) != 0u;
        uint cells = record + trimWords[band + 1u];
        uint cell = cells + 4u * trimEntry(cells, 4u, count >> 1u, high.x);
        // From the last cell that may be near backwards, to the first one that tells what lies to its left.
        for (uint left = count >> 1u; left > 0u && cell >= cells; cell -= 4u, --left) {
            float start = trimNumber(cell);
            if (start > high.x)
                break;
            float end = trimNumber(cell + 1u);
            uint pieces = trimWords[cell + 3u];
            bool tells = isHere && start <= t.x;
            if (tells)
                found.inside = (pieces & (end < t.x ? 2u : 1u)) != 0u;
            if (end < low.x)
                break;
            uint list = record + trimWords[cell + 2u];
            for (uint at = list; at < list + (pieces >> 2u); ++at) {
                TrimPiece piece = trimPieceEnds(record + trimWords[at]);
                if (tells && end >= t.x && trimPieceCrosses(piece, t))
                    found.inside = !found.inside;
                if (all(lessThanEqual(min(piece.first, piece.last), high)) &&
                    all(greaterThanEqual(max(piece.first, piece.last), low))) {
                    trimHoldInner(piece);
                    meetPiece(piece, centre, toPixels, scale, found.distances);
                }
            }
            isHere = isHere && !tells;
        }
    }
    return found;
}

// Where the way leaves the KSQuad: where the surface ends, or past a loop along a knot line, or on in the next KSQuad.
float distanceBeyond(uint surface, PixelPlace place, vec2 way)
{
    const int kHalvings = 4;
    PixelPlace end = stepped(surface, place, way);
    vec2 exits = mix(-place.t, 1.0 - place.t, greaterThan(way, vec2(0.0))) / way;
    float low = clamp(min(way.x == 0.0 ? 2.0 : exits.x, way.y == 0.0 ? 2.0 : exits.y), 0.0, 1.0);
    if (any(notEqual(end.t, clamp(end.t, 0.0, 1.0))))
        return low;
    if (trimContains(end.ksquad, end.t))
        return 2.0;
    float high = 1.0;
    for (int k = 0; k < kHalvings; ++k) {
        float middle = 0.5 * (low + high);
        PixelPlace at = stepped(surface, place, middle * way);
        if (trimContains(at.ksquad, at.t))
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

// The pixel that shows a place, to about what its triangle is off.
uint trimEdgeCodeAt(PixelPlace shown, vec2 centre)
{
    const float kAsGood = 0.05;  // pixels
    uint surface = ksquads[shown.ksquad].surface;
    mat2 along = mat2(0.0);  // how t changes from pixel to pixel
    PixelPlace place = aimedPlace(surface, shown, centre, along);
    uint word = trimWords[place.ksquad];
    PlaceInLoops found = PlaceInLoops(word != TRIM_OUTSIDE, FAR_FROM_EDGES);
    if (word >= TRIM_RECORDS)
        found = placeInLoops(word, clamp(place.t, 0.0, 1.0), inverse(along),
                             TRIM_EDGE_REACH * (abs(along[0]) + abs(along[1])));
    vec4 distances = found.distances;
    for (int k = 0; k < 4; ++k) {
        vec2 way = (k & 1) != 0 ? -along[k >> 1] : along[k >> 1];
        vec2 end = place.t + way;
        if (distances[k] > TRIM_EDGE_REACH && any(notEqual(end, clamp(end, 0.0, 1.0))))
            distances[k] = distanceBeyond(surface, place, way);
    }
    if (determinant(along) == 0.0)
        return TRIM_EDGE_FAR;
    int side = nearestTrimSide(distances);
    if (distances[side] < kAsGood || (!found.inside && distances[side] <= TRIM_EDGE_REACH)) {
        // The centre is as good as on the border, so that rounding chose between the two ways.
        vec2 way = (side & 1) != 0 ? -along[side >> 1] : along[side >> 1];
        PixelPlace end = stepped(surface, place, way);
        if (all(equal(end.t, clamp(end.t, 0.0, 1.0))) && trimContains(end.ksquad, end.t)) {
            distances[side ^ 1] = found.inside ? distances[side] : 0.0;
            distances[side] = 2.0;
        } else if (!found.inside) {
            distances[side] = 0.0;
        }
    }
    return trimEdgeCode(distances);
}

#endif
