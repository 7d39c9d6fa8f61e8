#include "renderer/scene/surface_views.h"

#include <glm/matrix.hpp>

namespace knotspan {

gpu::SurfaceView surfaceView(const Resident& resident, const Camera& camera, float side, std::uint32_t shell)
{
    const Mat4& transform = resident.object->transform;
    const Mat4 inverse = glm::inverse(transform);
    const Mat4 toView = camera.viewFrom(transform, resident.frame.origin);

    gpu::SurfaceView view{};
    view.modelView = gpu::mat4x3(glm::dmat4x3(toView));
    view.eye = camera.orthographic
                   ? gpu::vec4(Vec4(glm::normalize(Vec3(inverse * Vec4(-camera.forward(), 0.0))), 0.0))
                   : gpu::vec4(Vec4(transformed(camera.eye, inverse) - resident.frame.origin, 1.0));
    view.facing = glm::determinant(transform) < 0.0 ? -1.0F : 1.0F;
    view.side = side;
    view.shell = shell;
    return view;
}

}  // namespace knotspan
