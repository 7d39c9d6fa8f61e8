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
        return failure("Several surfaces were selected at once, so that it is not known which one to trim",
                       "Select the one that is to be trimmed last: Shift adds it to the others");
    Chosen chosen{*selection.latest(), scene.find(*selection.latest()), {}};
    if (!chosen.face || chosen.face->locked)
        return failure("The surface that was selected last is gone or locked", "Select another");
    for (const ObjectId id : selection.objects())
        if (const SharedObject cutter = id != chosen.id ? scene.find(id) : nullptr)
            chosen.cutters.push_back(cutter);
    return chosen;
}

struct Trimmed {
    SceneObject face;
    double error = 0;
};

// By each in turn. What cannot be used is named, where there is a choice.
Result<Trimmed> trimmed(const Chosen& chosen, const Sight& sight, double tolerance, KeptSide side)
{
    Trimmed result{*chosen.face, 0};
    SceneObject& face = result.face;
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
        face.trimLoops = std::move(trim->loops);
        result.error = std::max(result.error, trim->error);
    }
    return result;
}

QString report(double error, const std::string& units, KeptSide side)
{
    const QString off = QString::number(error, 'g', 2) + ' ' + QString::fromStdString(units);
    return side == KeptSide::outside
               ? MainWindow::tr(
                     "What lies outside the borders is left, to within %1. For the inside undo this and take "
                     "Edit > Keep inside selected")
                     .arg(off)
               : MainWindow::tr(
                     "What lies inside the borders is left, to within %1. For the outside undo this and take "
                     "Edit > Trim by selected")
                     .arg(off);
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
    edit.set(chosen->id, std::make_shared<SceneObject>(std::move(result->face)));
    document.apply(edit, MainWindow::tr("Trim by selected"));
    window.statusBar()->showMessage(report(result->error, document.scene().units(), side));
}

}  // namespace knotspan
