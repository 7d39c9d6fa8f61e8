#include "ui/tools/probe_tool.h"

#include "model/sculpting/surface_snapping.h"
#include "ui/tools/probe_texts.h"
#include "ui/tools/probes.h"

namespace knotspan {

namespace {

// The picture's place is as far off as the picture is: the nearest one of the surface itself.
std::optional<SurfacePlace> placeUnder(const ToolContext& context, const ToolPointer& pointer)
{
    const Pick pick = context.pick(pointer.position);
    if (!pick.place)
        return std::nullopt;
    const SharedObject object = context.document.scene().find(pick.place->object);
    if (!object)
        return std::nullopt;
    return nearestFrom(pick.place->object, *object, {pick.place->spanU, pick.place->spanV},
                       pick.place->position);
}

}  // namespace

void ProbeTool::hover(const ToolContext& context, const ToolPointer& pointer)
{
    const auto place = placeUnder(context, pointer);
    if (!place) {
        leave(context);
        return;
    }
    const Probe probe{place->object, place->u, place->v};
    context.probes.setLive(probe);
    const Scene& scene = context.document.scene();
    if (const auto found = probed(scene, probe))
        context.hint(probeSentence(*found, QString::fromStdString(scene.units())));
}

void ProbeTool::click(const ToolContext& context, const ToolPointer& pointer)
{
    if (const auto place = placeUnder(context, pointer))
        context.probes.pin(place->object, place->u, place->v);
}

void ProbeTool::leave(const ToolContext& context)
{
    if (!context.probes.live())
        return;
    context.probes.setLive({});
    context.hint({});
}

}  // namespace knotspan
