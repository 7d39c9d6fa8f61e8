// One way to turn visible KSQuads into triangles, with one evaluator. A path is one file with a class and a
// factory, and one line in path_list.cpp; it knows no other path and no culling.
#pragma once

#include <memory>

#include "model/geometry/basis_evaluators.h"
#include "renderer/paths/path_list.h"
#include "renderer/scene/render_lists.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

// The draws through the VisibleList, for paths that take it.
struct VisibleDraws {
    VkBuffer draws = VK_NULL_HANDLE;  // VkDrawIndirectCommand, a vertex for each KSQuad
    std::uint32_t count = 0;
};

class SurfacePath {
public:
    virtual ~SurfacePath() = default;

    // Paths with a task stage cull there; the others draw the VisibleList that the culling pass made.
    [[nodiscard]] virtual bool takesVisibleList() const = 0;

    // The rule that stands for SamplingRule::pathDefault, and whether the path can follow another.
    [[nodiscard]] virtual SamplingRule defaultSampling() const = 0;
    [[nodiscard]] virtual bool supports(SamplingRule rule) const = 0;

    // How many KSQuads one draw through the VisibleList may hold.
    [[nodiscard]] virtual std::uint32_t ksquadsPerDraw(SamplingRule) const { return ~0U; }

    // Inside a rendering, with viewport and bindings set.
    virtual void draw(VkCommandBuffer commands, std::uint32_t ksquads, const VisibleDraws& visible) const = 0;
};

struct PathFactory {
    PathInfo info;
    // Empty where the device can run it, otherwise the reason as a sentence.
    std::string (*whyUnavailable)(const Device& device);
    std::unique_ptr<SurfacePath> (*create)(const Device& device, const Bindings& bindings,
                                           Evaluator evaluator);
};

// In the order of paths().
[[nodiscard]] const std::vector<PathFactory>& pathFactories();
[[nodiscard]] const PathFactory& pathFactory(PathId id);

// One a file.
[[nodiscard]] PathFactory mesh9x9Path();
[[nodiscard]] PathFactory tessellationPath();

}  // namespace knotspan
