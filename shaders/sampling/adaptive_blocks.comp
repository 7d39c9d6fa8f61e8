// Where the path tessellation-adaptive may leave out every other line of a KSQuad's drawn grid. The grid is as fine as the
// KSQuad's most curved part asks. For each of its 4 x 4 blocks one window (grid_choice.glsl), that holds every base cell
// whose middle lies in the block, says whether triangles of a base cell's size, twice the drawn grid's, keep the
// tolerance, too, or those that are halved in one direction. Two bits a block: lines of u, lines of v are needed.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/grid_scene.glsl"
#include "sampling_rules.glsl"

layout(local_size_x = LIST_KSQUADS) in;

layout(set = 0, binding = BINDING_ADAPTIVE_BLOCKS, scalar) writeonly buffer BlockBuffer { uint adaptiveBlocks[]; };

#define AT_ONCE (LIST_KSQUADS / GRID_LANES)

shared uint needed[AT_ONCE];

// Block k of 4, wider by half a base cell, and a little more, so that rounding leaves no gap.
Stretch blockStretch(uint k, uint cells)
{
    float aside = 1.0001 / float(cells);
    return Stretch(max(0.25 * float(k) - aside, 0.0), min(0.25 * float(k + 1u) + aside, 1.0));
}

void main()
{
    uint thread = gl_LocalInvocationID.x;
    uint place = thread / GRID_LANES;
    uint block = thread % GRID_LANES;
    if (block == 0u)
        needed[place] = 0u;
    barrier();
    uint index = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * AT_ONCE + place;
    uint ksquad = index < counters.visible ? visible[index] : 0u;
    bool works = index < counters.visible && (grids[ksquad].alongU | grids[ksquad].alongV) != 0u;
    if (works) {
        DrawnGrid grid = drawnGrid(ksquad, frame.snap);
        if (max(grid.u, grid.v) > 1u) {
            KsQuadRecord record = ksquads[ksquad];
            WindowFigures figures =
                windowFigures(placeOfNumbers(record), pixelMap(record.surface), blockStretch(block / 4u, grid.u),
                              blockStretch(block % 4u, grid.v));
            uint lines = 3u;
            float least = GRID_HUGE;
            for (uint tried = 0u; tried < 3u && lines != 0u; ++tried) {
                float u = (tried == 1u ? 1.0 : 2.0) / float(grid.u);
                float v = (tried == 2u ? 1.0 : 2.0) / float(grid.v);
                float bound = windowBound(figures, min(u, 1.0), min(v, 1.0));
                if (bound <= frame.tolerancePx && bound < least) {
                    lines = tried;
                    least = bound;
                }
            }
            if (lines != 3u)
                atomicMax(counters.errorBound, floatBitsToUint(least));
            atomicOr(needed[place], lines << 2u * block);
        }
    }
    barrier();
    if (works && block == 0u)
        adaptiveBlocks[ksquad] = needed[place];
}
