// The geometry stage of the path geometry with culling by evs: KSDice that nobody can see are not put out.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_EVS
#include "geometry_tiles.glsl"
