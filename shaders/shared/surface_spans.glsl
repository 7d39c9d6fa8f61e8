// Where the spans of whole surfaces lie, for stages that draw a surface as one primitive: of each surface where its numbers
// for u and for v start, then those: the spans' borders from 0 to 1.
#ifndef KNOTSPAN_SURFACE_SPANS_GLSL
#define KNOTSPAN_SURFACE_SPANS_GLSL

layout(set = 0, binding = BINDING_SURFACE_SPANS, scalar) readonly buffer SpanBuffer { uint surfaceSpans[]; };

float spanBorder(uint start, uint k) { return uintBitsToFloat(surfaceSpans[start + k]); }

// The span of `count` that u, 0 .. 1, lies in, plus its t there.
float spanOf(uint start, uint count, float u)
{
    uint low = 0u;
    uint high = count;
    while (low + 1u < high) {
        uint middle = (low + high) / 2u;
        if (spanBorder(start, middle) <= u)
            low = middle;
        else
            high = middle;
    }
    float from = spanBorder(start, low);
    return float(low) + clamp((u - from) / (spanBorder(start, low + 1u) - from), 0.0, 1.0);
}

#endif
