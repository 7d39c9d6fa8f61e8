// The older scheme that RPNS compares itself with: a whole surface is the primitive. One patch each, cut as
// finely as its longest lines ask, up to what the tessellator makes; neighbours are not asked, so there are
// cracks.
#include "renderer/paths/surface_path.h"

#include <algorithm>
#include <bit>
#include <map>

namespace knotspan {

namespace {

// Where the spans of all surfaces lie (shaders/shared/surface_spans.glsl); equal ones are kept once.
std::vector<std::uint32_t> spanNumbers(const std::vector<Resident>& residents)
{
    std::vector<std::uint32_t> numbers(2 * residents.size());
    std::map<std::vector<std::uint32_t>, std::uint32_t> starts;
    const auto startOf = [&](const KnotVector& knots) {
        const std::vector<int>& spans = knots.spans();
        const auto knot = [&](int index) { return knots.values()[static_cast<size_t>(index)]; };
        const double low = knot(spans.front());
        const double length = knot(spans.back() + 1) - low;
        std::vector<std::uint32_t> borders;
        for (const int span : spans)
            borders.push_back(std::bit_cast<std::uint32_t>(static_cast<float>((knot(span) - low) / length)));
        borders.push_back(std::bit_cast<std::uint32_t>(1.0F));
        const auto [found, isNew] = starts.try_emplace(borders, static_cast<std::uint32_t>(numbers.size()));
        if (isNew)
            numbers.insert(numbers.end(), borders.begin(), borders.end());
        return found->second;
    };
    for (size_t k = 0; k < residents.size(); ++k) {
        const NurbsSurface& surface = residents[k].object->surface;
        const std::uint32_t u = startOf(surface.knotsU());
        const std::uint32_t v = startOf(surface.knotsV());
        numbers[2 * k] = u;
        numbers[2 * k + 1] = v;
    }
    return numbers;
}

class WholeSurfacePath : public SurfacePath {
public:
    WholeSurfacePath(const Device& device, Bindings& bindings, const PathVariant& variant)
        : device_(device),
          bindings_(bindings),
          pipeline_(makeGraphicsPipeline(
              device, bindings,
              {.stages = {"tile.vert", "whole_surface.tesc", "whole_surface.tese", variant.fragmentStage()},
               .topology = VK_PRIMITIVE_TOPOLOGY_PATCH_LIST,
               .specialization = variant.specialization}))
    {
    }

    [[nodiscard]] std::optional<TileLimits> tiles() const override { return std::nullopt; }
    [[nodiscard]] std::uint32_t followed(std::uint32_t cullBits, SamplingRule) const override
    {
        return cullBits & 1U;  // the mode surface, as whole_surface.tesc has it
    }
    [[nodiscard]] std::string limit() const override
    {
        if (cutShort_ == 0)
            return {};
        return (cutShort_ == 1 ? "1 surface asks" : std::to_string(cutShort_) + " surfaces ask") +
               " for more cells along a side than the " + std::to_string(level()) +
               " that the tessellator makes here";
    }

    void prepare(const PathFrame& frame, gpu::FrameRecord& record) override
    {
        const auto& residents = frame.scene.residents();
        surfaces_ = static_cast<std::uint32_t>(residents.size());
        record.tileSide = level();
        record.flags |= FRAME_SPANS;
        auto numbers = spanNumbers(residents);
        const bool isHeld = numbers == numbers_;
        if (!isHeld)
            frame.uploader.forget(spanBuffer_);
        // Another variant's may stand there now.
        bindings_.provide(BINDING_SURFACE_SPANS, spanBuffer_, numbers.size() * sizeof(std::uint32_t));
        if (isHeld)
            return;
        numbers_ = std::move(numbers);
        frame.uploader.write(spanBuffer_, 0, std::span<const std::uint32_t>(numbers_));
    }
    void forget() override { numbers_.clear(); }
    [[nodiscard]] bool hadRoom(const gpu::Counters& counted) override
    {
        cutShort_ = counted.tiles;
        return true;
    }

    void draw(VkCommandBuffer commands, std::uint32_t, const TileDraws&) const override
    {
        const std::uint32_t most = device_.abilities().tessellatedVerticesPerDraw;
        const std::uint32_t perDraw = most == 0 ? surfaces_ : most / ((level() + 1) * (level() + 1));
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
        for (std::uint32_t first = 0; first < surfaces_; first += perDraw)
            vkCmdDraw(commands, std::min(perDraw, surfaces_ - first), 1, first, 0);
    }

private:
    [[nodiscard]] std::uint32_t level() const { return device_.abilities().maxTessellationLevel; }

    const Device& device_;
    Bindings& bindings_;
    Pipeline pipeline_;
    Buffer spanBuffer_;
    std::vector<std::uint32_t> numbers_;  // what the device holds
    std::uint32_t surfaces_ = 0;
    std::uint32_t cutShort_ = 0;  // surfaces of the last frame
};

}  // namespace

PathFactory wholeSurfacePath()
{
    return {{PathId::surface,
             "surface",
             "Tessellation stages, a whole surface as one patch: the older scheme",
             true,
             {{SamplingRule::Kind::area}, {SamplingRule::Kind::edge}, {SamplingRule::Kind::fixed}}},
            [](const Device& device) { return device.abilities().noTessellation; },
            [](const Device& device, Bindings& bindings,
               const PathVariant& variant) -> std::unique_ptr<SurfacePath> {
                return std::make_unique<WholeSurfacePath>(device, bindings, variant);
            }};
}

}  // namespace knotspan
