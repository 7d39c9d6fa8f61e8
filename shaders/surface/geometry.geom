// The geometry stage of the path geometry (RPNS' first variant): one point in, a whole tile out as triangle strips. A strip
// of cells repeats the row it shares with the one before, a ring gives out each triangle by itself, so that a stage without
// shared memory evaluates every vertex once and keeps it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "geometry_tiles.glsl"
