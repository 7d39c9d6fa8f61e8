// How anything in the picture is lit, and how its colour is written.
#ifndef KNOTSPAN_LIGHTING_GLSL
#define KNOTSPAN_LIGHTING_GLSL

// The inside of a surface is a little darker and warmer, so that its orientation shows.
const vec3 kInside = vec3(0.75, 0.62, 0.5);

// Two soft lamps that go with the camera, a hemisphere of sky, and a broad highlight that shows flaws.
vec3 lit(vec3 albedo, vec3 n, vec3 towardsEye)
{
    const vec3 key = normalize(vec3(-0.4, 0.7, 0.6));
    const vec3 fill = normalize(vec3(0.7, 0.1, 0.5));
    float sky = 0.5 + 0.5 * n.y;
    vec3 light = vec3(0.13, 0.13, 0.14) + 0.14 * sky * vec3(0.9, 0.95, 1.0);
    light += 0.62 * max(dot(n, key), 0.0) * vec3(1.0, 0.98, 0.95) + 0.2 * max(dot(n, fill), 0.0);
    float gloss = pow(max(dot(n, normalize(key + towardsEye)), 0.0), 40.0);
    return albedo * light + 0.16 * gloss;
}

vec3 encodedSrgb(vec3 linear)
{
    linear = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThan(linear, vec3(0.0031308)));
}

#endif
