#include "renderer/overlays/trim_edges.h"

#include <algorithm>

#include "shaders/shared/trim_tiles.h"

namespace knotspan {

namespace {

constexpr VkDeviceSize kWord = sizeof(std::uint32_t);
constexpr VkDeviceSize kWordsOfAPixel = 5;  // colour, depth, two of what it shows, and a place in the list
// Of rows that are smoothed at once: a picture of full HD. Devices need not bind more than 128 MB.
constexpr VkDeviceSize kMostBytes = VkDeviceSize{64} << 20U;

}  // namespace

TrimEdges::TrimEdges(const Device& device, Bindings& bindings)
    : device_(device),
      bindings_(bindings),
      find_(makeComputePipeline(device, bindings, "trim_edge_find.comp")),
      blend_(makeComputePipeline(device, bindings, "trim_edge_blend.comp")),
      put_(makeComputePipeline(device, bindings, "trim_edge_put.comp"))
{
}

std::uint32_t TrimEdges::rowsAtOnce(VkExtent2D extent)
{
    const VkDeviceSize held = kMostBytes / (kWord * kWordsOfAPixel * extent.width);
    if (extent.height <= held)
        return extent.height;
    return static_cast<std::uint32_t>(std::max<VkDeviceSize>(held, 4 * TRIM_ROWS_BESIDE) -
                                      2 * TRIM_ROWS_BESIDE);
}

void TrimEdges::prepare(VkExtent2D extent, Specialization specialization)
{
    extent_ = extent;
    const std::uint32_t rows = rowsAtOnce(extent);
    const bool isWhole = rows == extent.height;
    const VkDeviceSize held = VkDeviceSize{extent.width} * (isWhole ? rows : rows + 2 * TRIM_ROWS_BESIDE);
    bindings_.provide(BINDING_DRAWN, pixels_, kWord * (TRIM_HEAD + kWordsOfAPixel * held));
    const VkDeviceSize whole = isWhole ? 0 : kWord * extent.width * extent.height;
    if (smoothed_.bytes() != whole) {
        smoothed_ = {};
        if (whole > 0)
            smoothed_ = Buffer(device_, whole, Buffer::Place::device);
    }
    specialization.captures = false;
    specialization_ = specialization;
    if (codes_.count(specialization) == 0)
        codes_[specialization] =
            makeComputePipeline(device_, bindings_, "trim_edge_codes.comp", specialization);
}

TrimEdges::Colours TrimEdges::record(VkCommandBuffer commands,
                                     const std::function<void(const Rows&)>& copy) const
{
    constexpr VkDeviceSize kColours = kWord * TRIM_HEAD;
    const std::uint32_t atOnce = rowsAtOnce(extent_);
    for (std::uint32_t row = 0; row < extent_.height; row += atOnce) {
        const std::uint32_t first = row - std::min<std::uint32_t>(row, TRIM_ROWS_BESIDE);
        const std::uint32_t last = std::min(row + atOnce + TRIM_ROWS_BESIDE, extent_.height);
        const VkDeviceSize each = kWord * extent_.width * (last - first);
        smoothRows(commands,
                   {first, last - first, pixels_.get(), kColours, kColours + each, kColours + 2 * each},
                   copy);
        if (atOnce == extent_.height)
            break;
        const std::uint32_t done = std::min(atOnce, extent_.height - row);
        const VkBufferCopy part{kColours + kWord * extent_.width * (row - first), kWord * extent_.width * row,
                                kWord * extent_.width * done};
        vkCmdCopyBuffer(commands, pixels_.get(), smoothed_.get(), 1, &part);
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                      VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                      VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
    }
    if (atOnce == extent_.height)
        return {pixels_.get(), kColours};
    return {smoothed_.get(), 0};
}

void TrimEdges::smoothRows(VkCommandBuffer commands, const Rows& rows,
                           const std::function<void(const Rows&)>& copy) const
{
    const std::uint32_t head[TRIM_HEAD] = {0, 1, 1, 0, rows.first, rows.count, 0, 0};
    vkCmdUpdateBuffer(commands, rows.to, 0, sizeof head, head);
    copy(rows);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    bindings_.bind(commands, VK_PIPELINE_BIND_POINT_COMPUTE);
    const auto tiles = [](std::uint32_t pixels, std::uint32_t side) { return (pixels + side - 1) / side; };
    computeStep(commands, find_,
                groupsFor(tiles(extent_.width, TRIM_TILE_WIDTH) * tiles(rows.count, TRIM_TILE_HEIGHT), 1));
    for (const Pipeline* step : {&codes_.at(specialization_), &blend_, &put_}) {
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT);
        computeStep(commands, *step, GroupsOnDevice{rows.to, 0});
    }
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                  VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
}

void TrimEdges::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"picture for trim edges", pixels_.bytes() + smoothed_.bytes()});
}

}  // namespace knotspan
