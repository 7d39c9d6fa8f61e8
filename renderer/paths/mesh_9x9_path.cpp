// The path of Lema, "Culling techniques for deformable NURBS surfaces" (2023): a task group looks at 32
// KSQuads, a mesh group draws one as 9x9 vertices.
#include "renderer/paths/surface_path.h"

namespace knotspan {

namespace {

constexpr SamplingRule kNineByNine{SamplingRule::Kind::fixed, 8};

class Mesh9x9Path : public SurfacePath {
public:
    Mesh9x9Path(const Device& device, const Bindings& bindings, const PathVariant& variant)
        : drawMeshTasks_(device.drawMeshTasks()),
          pipeline_(
              makeGraphicsPipeline(device, bindings,
                                   {.stages = {"mesh_9x9.task", "mesh_9x9.mesh", variant.fragmentStage()},
                                    .specialization = variant.specialization}))
    {
    }

    [[nodiscard]] std::optional<TileLimits> tiles() const override { return std::nullopt; }

    void draw(VkCommandBuffer commands, std::uint32_t ksquads, const TileDraws&) const override
    {
        const GroupCount groups = groupsFor(ksquads, TASK_KSQUADS);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
        drawMeshTasks_(commands, groups.x, groups.y, 1);
    }

private:
    PFN_vkCmdDrawMeshTasksEXT drawMeshTasks_;
    Pipeline pipeline_;
};

}  // namespace

PathFactory mesh9x9Path()
{
    return {{PathId::mesh9x9,
             "mesh-9x9",
             "Task and mesh stages, every KSQuad as 9 by 9 vertices",
             false,
             {kNineByNine}},
            [](const Device& device) { return device.abilities().noMeshStages; },
            [](const Device& device, Bindings& bindings,
               const PathVariant& variant) -> std::unique_ptr<SurfacePath> {
                return std::make_unique<Mesh9x9Path>(device, bindings, variant);
            }};
}

}  // namespace knotspan
