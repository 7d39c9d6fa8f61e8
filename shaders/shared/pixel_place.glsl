// What a pixel shows: a place of which KSQuad.
#ifndef KNOTSPAN_PIXEL_PLACE_GLSL
#define KNOTSPAN_PIXEL_PLACE_GLSL

struct PixelPlace {
    uint ksquad;
    vec2 t;
};

// As pictures hold it: the KSQuad's index + 1, so that 0 is the background, and t in steps of 2^-16.
uvec2 pickedOf(PixelPlace place) { return uvec2(place.ksquad + 1u, packUnorm2x16(clamp(place.t, 0.0, 1.0))); }
PixelPlace placeOf(uvec2 picked) { return PixelPlace(picked.x - 1u, unpackUnorm2x16(picked.y)); }

#endif
