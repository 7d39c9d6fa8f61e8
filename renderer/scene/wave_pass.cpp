#include "renderer/scene/wave_pass.h"

#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace knotspan {

namespace {

gpu::WaveRecord recordOf(const Resident& resident, const Wave& wave)
{
    const Mat4& transform = resident.object->transform;
    const Vec3 origin = transformed(resident.frame.origin, transform);
    const double phase = wave.phasePerUnit * (origin.x + origin.y) - wave.phaseAtZero;
    gpu::WaveRecord record{};
    // x + y of the model for a unit along each of the surface's own axes.
    record.phase =
        gpu::vec3(wave.phasePerUnit * Vec3(transform[0].x + transform[0].y, transform[1].x + transform[1].y,
                                           transform[2].x + transform[2].y));
    record.phaseAtOrigin = static_cast<float>(std::remainder(phase, 2 * M_PI));
    record.move = gpu::vec3(glm::inverse(glm::dmat3(transform)) * Vec3(0, 0, wave.amplitude));
    record.time = static_cast<float>(std::remainder(wave.time, 2 * M_PI));
    return record;
}

void copyAfterDrawing(VkCommandBuffer commands, VkBuffer from, VkBuffer to, VkDeviceSize bytes)
{
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                  VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
    const VkBufferCopy region{0, 0, bytes};
    vkCmdCopyBuffer(commands, from, to, 1, &region);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                  VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
}

}  // namespace

WavePass::WavePass(const Device& device, Bindings& bindings, Uploader& uploader)
    : device_(device),
      bindings_(bindings),
      uploader_(uploader)
{
}

void WavePass::prepare(const GpuScene& scene, const std::optional<Wave>& wave)
{
    points_ = scene.controlPointBuffer();
    count_ = scene.controlPointCount();
    waving_ = wave.has_value() && count_ > 0;
    bytes_ = VkDeviceSize{count_} * sizeof(gpu::vec4);
    if (!waving_)
        return;
    if (pipeline_.get() == VK_NULL_HANDLE)
        pipeline_ = makeComputePipeline(device_, bindings_, "wave.comp");
    bindings_.provide(BINDING_REST_POINTS, rest_, bytes_);
    std::vector<gpu::WaveRecord> records;
    for (const Resident& resident : scene.residents())
        records.push_back(recordOf(resident, *wave));
    uploader_.forget(waves_);
    bindings_.provide(BINDING_WAVES, waves_, records.size() * sizeof(gpu::WaveRecord));
    uploader_.write(waves_, 0, std::span<const gpu::WaveRecord>(records));
}

void WavePass::recordRest(VkCommandBuffer commands)
{
    if (moved_)
        copyAfterDrawing(commands, rest_.get(), points_, bytes_);
    moved_ = false;
}

void WavePass::recordWave(VkCommandBuffer commands)
{
    if (!waving_)
        return;
    copyAfterDrawing(commands, points_, rest_.get(), bytes_);
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_.get());
    const GroupCount groups = groupsFor(count_, WAVE_POINTS);
    vkCmdDispatch(commands, groups.x, groups.y, 1);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT);
    moved_ = true;
}

}  // namespace knotspan
