#include "ui/border_trim.h"

#include <algorithm>

#include <QStatusBar>

#include "model/trimming/border_trimming.h"
#include "ui/main_window.h"
#include "ui/tools/trim_sight.h"

namespace knotspan {

namespace {

struct Chosen {
    ObjectId id{};
    SharedObject face;
    std::vector<SharedObject> cutters;
};

Result<Chosen> chosenBy(const Selection& selection, const Scene& scene)
{
    if (selection.objects().size() < 2)
        return failure("One more surface is needed",
                       "Select the surfaces whose borders cut, and last the one that is to be trimmed");
    if (!selection.latest())
        return failure(
            "Several surfaces were selected at once, so that it is not known which one to trim",
            "Add the one that is to be trimmed last: Shift and a click, in the list Ctrl and a click");
    Chosen chosen{*selection.latest(), scene.find(*selection.latest()), {}};
    if (!chosen.face || chosen.face->locked)
        return failure("The surface that was selected last is gone or locked", "Select another");
    if (!chosen.face->visible)
        return failure("The surface that was selected last is hidden", "Show it, or select another");
    for (const ObjectId id : selection.objects())
        if (const SharedObject cutter = id != chosen.id ? scene.find(id) : nullptr)
            chosen.cutters.push_back(cutter);
    return chosen;
}

struct Trimmed {
    SceneObject face;
    double error = 0;
};

// Without the borders' insides, of one after the other; or what is inside any of them. What cannot be used is
// named, where there is a choice.
Result<Trimmed> trimmed(const Chosen& chosen, const Sight& sight, double tolerance, KeptSide side)
{
    Trimmed result{*chosen.face, 0};
    SceneObject& face = result.face;
    std::vector<std::vector<TrimLoop>> parts;
    for (const SharedObject& cutter : chosen.cutters) {
        auto trim =
            trimmedByBorder({face.surface, face.transform, face.trimLoops},
                            {cutter->surface, cutter->transform, cutter->trimLoops}, sight, tolerance, side);
        if (!trim) {
            Error error = trim.error();
            if (chosen.cutters.size() > 1 && !cutter->name.empty())
                error.what = cutter->name + ": " + error.what;
            return tl::unexpected(std::move(error));
        }
        result.error = std::max(result.error, trim->error);
        if (side == KeptSide::inside)
            parts.push_back(std::move(trim->loops));
        else
            face.trimLoops = std::move(trim->loops);
    }
    if (side == KeptSide::outside)
        return result;
    auto joined = joinedParts(parts, face.surface);
    if (!joined)
        return tl::unexpected(joined.error());
    face.trimLoops = *std::move(joined);
    return result;
}

QString report(const Trimmed& trimmed, const std::string& units, KeptSide side)
{
    const SceneObject& face = trimmed.face;
    const QString name =
        face.name.empty() ? MainWindow::tr("The surface") : QString::fromStdString(face.name);
    const QString nearness = nearnessText(trimmed.error, face, units);
    return side == KeptSide::outside ? MainWindow::tr("%1 lost what lies inside the borders, %2; turn the "
                                                      "view where they hide it. The other way "
                                                      "round: undo, Edit > Keep inside selected")
                                           .arg(name, nearness)
                                     : MainWindow::tr("%1 kept only what lies inside the borders, %2; turn "
                                                      "the view where they hide it. The other "
                                                      "way round: undo, Edit > Trim by selected")
                                           .arg(name, nearness);
}

}  // namespace

void trimBySelected(MainWindow& window, KeptSide side)
{
    Document& document = window.document();
    document.endPreview();
    const auto chosen = chosenBy(window.selection(), document.scene());
    if (!chosen) {
        window.statusBar()->showMessage(QString::fromStdString(chosen.error().sentence()));
        return;
    }
    const Viewport& viewport = window.viewport();
    const PictureSize size = viewport.pictureSize();
    auto result = trimmed(*chosen, sightOf(viewport.frame().camera, size.width, size.height),
                          trimTolerance(viewport.toolSettings(), *chosen->face), side);
    if (!result) {
        window.statusBar()->showMessage(QString::fromStdString(result.error().sentence()));
        return;
    }
    Edit edit;
    edit.set(chosen->id, std::make_shared<SceneObject>(result->face));
    document.apply(edit, side == KeptSide::outside ? MainWindow::tr("Trim by selected")
                                                   : MainWindow::tr("Keep inside selected"));
    window.statusBar()->showMessage(report(*result, document.scene().units(), side));
}

}  // namespace knotspan
