// Newton's method on the screen: from a place of the surface to the one that a pixel's centre shows.
#ifndef KNOTSPAN_PIXEL_AIM_GLSL
#define KNOTSPAN_PIXEL_AIM_GLSL

#include "pixel_place.glsl"

// How far a point falls from the pixel's centre, and the changes of t that take it a pixel along x and along y, to first
// order.
struct Aim {
    vec2 missed;  // pixels
    vec2 along[2];
};

// `centre`: of the pixel, in pixels.
Aim aimOf(vec2 centre, vec3 position, vec3 du, vec3 dv)
{
    vec4 clip = toClip(position);
    vec4 clipU = frame.projection * vec4(du, 0.0);
    vec4 clipV = frame.projection * vec4(dv, 0.0);
    vec2 halfSize = 0.5 * frame.pixels;
    vec2 place = clip.xy / clip.w;
    vec2 byU = halfSize * (clipU.xy - clipU.w * place) / clip.w;
    vec2 byV = halfSize * (clipV.xy - clipV.w * place) / clip.w;
    float area = byU.x * byV.y - byU.y * byV.x;
    // Seen edge-on a pixel is a long way.
    float least = 1e-6 * length(byU) * length(byV);
    area = abs(area) > least ? area : (area < 0.0 ? -least : least);
    return Aim(centre - halfSize * (place + 1.0), vec2[2](vec2(byV.y, -byU.y) / area, vec2(-byV.x, byU.x) / area));
}

// On the whole surface parameters may leave its domain by this much: it goes on smoothly.
const float kBeyond = 0.05;

PixelPlace stepped(uint surface, PixelPlace place, vec2 change)
{
    vec2 t = place.t + change;
    if (all(greaterThanEqual(t, vec2(0.0))) && all(lessThan(t, vec2(1.0))))
        return PixelPlace(place.ksquad, t);
    uint first = surfaces[surface].firstKsquad;
    uint spansU = surfaces[surface].spansU;
    uint spansV = surfaces[surface].spansV;
    if (spansU + spansV == 2u)
        return PixelPlace(place.ksquad, clamp(t, vec2(-kBeyond), vec2(1.0 + kBeyond)));
    vec2 before = vec2((place.ksquad - first) / spansV, (place.ksquad - first) % spansV);
    vec2 spans = vec2(spansU, spansV);
    vec2 at = clamp(before + t, vec2(-kBeyond), spans + kBeyond);
    vec2 now = clamp(floor(at), vec2(0.0), spans - 1.0);
    return PixelPlace(first + uint(now.x) * spansV + uint(now.y), at - now);
}

// One step, from a place that a triangle shows there: it lies beside the surface, by as much as the tolerance.
// `along`: how t changes from pixel to pixel there. Both stay where the step would lead too far.
PixelPlace aimedPlace(uint surface, PixelPlace place, vec2 centre, inout mat2 along)
{
    const float kMostMissed = 4.0;  // pixels: beyond that nobody takes it for a tolerance
    const float kMostChange = 0.5;  // of a KSQuad
    SurfaceSample at = sampleKsQuad(ksquads[place.ksquad], place.t);
    mat3 turn = mat3(surfaceViews[surface].modelView);
    Aim aim = aimOf(centre, toView(surface, at.position), turn * at.du, turn * at.dv);
    vec2 change = aim.along[0] * aim.missed.x + aim.along[1] * aim.missed.y;
    if (!(length(aim.missed) < kMostMissed && max(abs(change.x), abs(change.y)) < kMostChange))
        return place;
    along = mat2(aim.along[0], aim.along[1]);
    return stepped(surface, place, change);
}

#endif
