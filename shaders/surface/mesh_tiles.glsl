// The mesh stages of the path mesh.
#include "../shared/tiles.glsl"
#include "drawn_vertex.glsl"
#include "tile_payload.glsl"

layout(local_size_x = TILE_THREADS) in;
layout(triangles, max_vertices = 256, max_primitives = 256) out;

taskPayloadSharedEXT TilePayload payload;

out gl_MeshPerVertexEXT
{
    vec4 gl_Position;
    float gl_CullDistance[1];
}
gl_MeshVerticesEXT[];

#include "surface_io.glsl"
SURFACE_OUT([])

#ifdef KNOTSPAN_EVS
#include "../culling/evs.glsl"
perprimitiveEXT out gl_MeshPerPrimitiveEXT { bool gl_CullPrimitiveEXT; }
gl_MeshPrimitivesEXT[];
shared uint beyond[256];  // of each vertex
shared uint culledTriangles;
#endif

uint start(uint group) { return payload.starts[group / 4u] >> 8u * (group % 4u) & 0xffu; }

void main()
{
    uint lane = gl_LocalInvocationID.x;
    uint first = payload.firstTile + start(gl_WorkGroupID.x);
    uint count = start(gl_WorkGroupID.x + 1u) - start(gl_WorkGroupID.x);
    uint vertices = 0u;
    uint triangles = 0u;
    for (uint k = 0u; k < count; ++k) {
        TileSize size = sizeOf(tiles[first + k]);
        vertices += size.vertices;
        triangles += size.triangles;
    }
    SetMeshOutputsEXT(vertices, triangles);
    if (lane == 0u) {
        countDice((triangles + 1u) / 2u, triangles, vertices);
        KNOTSPAN_COUNT(counters.laneSlots, (vertices + TILE_THREADS - 1u) / TILE_THREADS * TILE_THREADS)
    }

    // No shared memory: the software driver compiles a stage with long code beside a barrier for half a minute.
    uint tile = first;
    uint vertexStart = 0u;  // number of its first vertex
    TileSize size = sizeOf(tiles[tile]);
    for (uint slot = lane; slot < vertices; slot += TILE_THREADS) {
        while (slot >= vertexStart + size.vertices) {
            vertexStart += size.vertices;
            size = sizeOf(tiles[++tile]);
        }
        GridVertex at = tileVertex(tiles[tile], slot - vertexStart);
        DrawnVertex vertex = drawnVertex(at, tiles[tile].ksquad);
        gl_MeshVerticesEXT[slot].gl_Position = vertex.clip;
        gl_MeshVerticesEXT[slot].gl_CullDistance[0] = vertex.shown;
#ifdef KNOTSPAN_EVS
        beyond[slot] = vertexBeyond(vertex.clip, vertex.shown);
#endif
        outPosition[slot] = vertex.view;
        outNormal[slot] = vertex.normal;
        outT[slot] = vertex.t;
        outWeightedT[slot] = vertex.inverseWeight * vertex.t;
        outInverseWeight[slot] = vertex.inverseWeight;
        outKsquad[slot] = tiles[tile].ksquad;
    }
#ifdef KNOTSPAN_EVS
    if (lane == 0u)
        culledTriangles = 0u;
    barrier();
#endif
    tile = first;
    size = sizeOf(tiles[tile]);
    vertexStart = 0u;
    uint triangleStart = 0u;
    for (uint triangle = lane; triangle < triangles; triangle += TILE_THREADS) {
        while (triangle >= triangleStart + size.triangles) {
            triangleStart += size.triangles;
            vertexStart += size.vertices;
            size = sizeOf(tiles[++tile]);
        }
        uvec3 corners = vertexStart + tileTriangle(tiles[tile], triangle - triangleStart);
        gl_PrimitiveTriangleIndicesEXT[triangle] = corners;
#ifdef KNOTSPAN_EVS
        bool culled = (beyond[corners.x] & beyond[corners.y] & beyond[corners.z]) != 0u;
        gl_MeshPrimitivesEXT[triangle].gl_CullPrimitiveEXT = culled;
        if (culled)
            atomicAdd(culledTriangles, 1u);
#endif
    }
#ifdef KNOTSPAN_EVS
    barrier();
    if (lane == 0u && culledTriangles > 0u)
        KNOTSPAN_COUNT(counters.trianglesCulled, culledTriangles)
#endif
}
