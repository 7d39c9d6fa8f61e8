// What trim loops leave of each KSQuad, bound.
#ifndef KNOTSPAN_TRIMMING_WORDS_GLSL
#define KNOTSPAN_TRIMMING_WORDS_GLSL

#include "scene.glsl"

layout(set = 0, binding = BINDING_TRIM_WORDS, scalar) readonly buffer TrimBuffer { uint trimWords[]; };

#include "trimming.glsl"

#endif
