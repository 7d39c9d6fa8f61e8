// A surface's point and tangents on one KSQuad from the basis functions of both directions: the same text for every
// shader stage and for C++.
//
// Control points are homogeneous (w x, w y, w z, w), relative to the surface's own origin. The NURBS Book, A4.4.
#ifndef KNOTSPAN_NURBS_SURFACE_GLSL
#define KNOTSPAN_NURBS_SURFACE_GLSL

#include "nurbs_basis.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_TEMPLATE
struct SurfaceSample {
    KNOTSPAN_VEC3 position;
    KNOTSPAN_VEC3 du;  // by the span's own t, not by u
    KNOTSPAN_VEC3 dv;
    Real weight;  // the sum that position is divided by
};

// `firstPoint` is the index of B_{i-p,j-q}, `stride` the distance between rows of the net.
KNOTSPAN_SOURCE_TEMPLATE
SurfaceSample KNOTSPAN_OF_REAL contractNet(KNOTSPAN_SOURCE uint firstPoint, uint stride, int degreeU, int degreeV,
                                           Basis KNOTSPAN_OF_REAL basisU, Basis KNOTSPAN_OF_REAL basisV)
{
    KNOTSPAN_VEC4 sum = KNOTSPAN_VEC4(Real(0));
    KNOTSPAN_VEC4 sumU = KNOTSPAN_VEC4(Real(0));
    KNOTSPAN_VEC4 sumV = KNOTSPAN_VEC4(Real(0));
    for (int i = 0; i <= degreeU; ++i) {
        KNOTSPAN_VEC4 row = KNOTSPAN_VEC4(Real(0));
        KNOTSPAN_VEC4 rowV = KNOTSPAN_VEC4(Real(0));
        for (int j = 0; j <= degreeV; ++j) {
            KNOTSPAN_VEC4 point = KNOTSPAN_POINT(firstPoint + uint(i) * stride + uint(j));
            row += basisV.value[j] * point;
            rowV += basisV.slope[j] * point;
        }
        sum += basisU.value[i] * row;
        sumU += basisU.slope[i] * row;
        sumV += basisU.value[i] * rowV;
    }
    SurfaceSample KNOTSPAN_OF_REAL result;
    result.weight = sum.w;
    result.position = KNOTSPAN_VEC3(sum) / sum.w;
    result.du = (KNOTSPAN_VEC3(sumU) - sumU.w * result.position) / sum.w;
    result.dv = (KNOTSPAN_VEC3(sumV) - sumV.w * result.position) / sum.w;
    return result;
}

KNOTSPAN_TEMPLATE
struct BentSample {
    KNOTSPAN_VEC3 position;
    KNOTSPAN_VEC3 du;  // by the span's own t, as all that follow
    KNOTSPAN_VEC3 dv;
    KNOTSPAN_VEC3 duu;
    KNOTSPAN_VEC3 duv;
    KNOTSPAN_VEC3 dvv;
};

// The same with second derivatives.
KNOTSPAN_SOURCE_TEMPLATE
BentSample KNOTSPAN_OF_REAL contractBentNet(KNOTSPAN_SOURCE uint firstPoint, uint stride, int degreeU, int degreeV,
                                            BentBasis KNOTSPAN_OF_REAL basisU, BentBasis KNOTSPAN_OF_REAL basisV)
{
    KNOTSPAN_VEC4 sum = KNOTSPAN_VEC4(Real(0));
    KNOTSPAN_VEC4 sumU = KNOTSPAN_VEC4(Real(0));
    KNOTSPAN_VEC4 sumV = KNOTSPAN_VEC4(Real(0));
    KNOTSPAN_VEC4 sumUU = KNOTSPAN_VEC4(Real(0));
    KNOTSPAN_VEC4 sumUV = KNOTSPAN_VEC4(Real(0));
    KNOTSPAN_VEC4 sumVV = KNOTSPAN_VEC4(Real(0));
    for (int i = 0; i <= degreeU; ++i) {
        KNOTSPAN_VEC4 row = KNOTSPAN_VEC4(Real(0));
        KNOTSPAN_VEC4 rowV = KNOTSPAN_VEC4(Real(0));
        KNOTSPAN_VEC4 rowVV = KNOTSPAN_VEC4(Real(0));
        for (int j = 0; j <= degreeV; ++j) {
            KNOTSPAN_VEC4 point = KNOTSPAN_POINT(firstPoint + uint(i) * stride + uint(j));
            row += basisV.value[j] * point;
            rowV += basisV.slope[j] * point;
            rowVV += basisV.bend[j] * point;
        }
        sum += basisU.value[i] * row;
        sumU += basisU.slope[i] * row;
        sumUU += basisU.bend[i] * row;
        sumV += basisU.value[i] * rowV;
        sumUV += basisU.slope[i] * rowV;
        sumVV += basisU.value[i] * rowVV;
    }
    // Derivatives of w S = A, The NURBS Book, eq. 4.20.
    BentSample KNOTSPAN_OF_REAL at;
    at.position = KNOTSPAN_VEC3(sum) / sum.w;
    at.du = (KNOTSPAN_VEC3(sumU) - sumU.w * at.position) / sum.w;
    at.dv = (KNOTSPAN_VEC3(sumV) - sumV.w * at.position) / sum.w;
    at.duu = (KNOTSPAN_VEC3(sumUU) - Real(2) * sumU.w * at.du - sumUU.w * at.position) / sum.w;
    at.duv = (KNOTSPAN_VEC3(sumUV) - sumU.w * at.dv - sumV.w * at.du - sumUV.w * at.position) / sum.w;
    at.dvv = (KNOTSPAN_VEC3(sumVV) - Real(2) * sumV.w * at.dv - sumVV.w * at.position) / sum.w;
    return at;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
