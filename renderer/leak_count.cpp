#include "renderer/leak_count.h"

#include "model/analysis/silhouette_mask.h"
#include "model/core/check.h"

namespace knotspan {

namespace {

PixelMask maskOf(const Scene& scene, const Frame& frame, double errorPx)
{
    Mat4 toEye(1.0);
    toEye[3] = Vec4(-frame.camera.eye, 1.0);
    const double aspect = static_cast<double>(frame.width) / frame.height;
    const Mat4 toClip = frame.camera.projection(aspect, scene.bounds()) * frame.camera.rotation() * toEye;
    std::vector<SurfaceInClip> surfaces;
    for (const auto& [id, object] : scene.objects())
        if (object->visible)
            surfaces.push_back({object->surface, toClip * object->transform});
    return silhouetteMask(surfaces, frame.width, frame.height, errorPx);
}

}  // namespace

std::uint64_t countLeaks(const Scene& scene, const Frame& frame, const KsQuadIndices& shown, double errorPx)
{
    check(shown.width == frame.width && shown.height == frame.height, "the indices are of this frame");
    const PixelMask mask = maskOf(scene, frame, errorPx);
    std::uint64_t leaks = 0;
    for (size_t pixel = 0; pixel < shown.indices.size(); ++pixel)
        leaks += mask.covered[pixel] != 0 && shown.indices[pixel] == 0 ? 1 : 0;
    return leaks;
}

}  // namespace knotspan
