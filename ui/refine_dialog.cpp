#include "ui/refine_dialog.h"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "model/refining/directions.h"

namespace knotspan {

namespace {

constexpr int kWaitMs = 120;  // for the hand that still turns a value

// No length grows by more than this: exact where the transform turns, moves and scales evenly.
double largestScale(const Mat4& transform)
{
    const glm::dmat3 linear(transform);
    const glm::dmat3 squares = glm::transpose(linear) * linear;
    double largest = 0;
    for (int row = 0; row < 3; ++row)
        largest = std::max(largest,
                           std::abs(squares[0][row]) + std::abs(squares[1][row]) + std::abs(squares[2][row]));
    return std::sqrt(largest);
}

}  // namespace

RefineDialog::RefineDialog(Document& document, Selection& selection, QWidget* parent)
    : QDialog(parent),
      document_(document),
      selection_(selection),
      shown_(document, tr("Refine surface"), this)
{
    setWindowTitle(tr("Refine surface"));
    setObjectName("refine-dialog");
    makeLayout();
    wait_.setSingleShot(true);
    wait_.setInterval(kWaitMs);
    connect(&wait_, &QTimer::timeout, this, &RefineDialog::look);
    connect(&selection_, &Selection::changed, this, [this] {
        if (target() == taken_)
            return;
        takeTarget();
        lookSoon();
    });
    connect(&shown_, &Preview::modelChanged, this, [this] {
        done_.clear();
        mayShow_ = false;
        if (isVisible())
            wait_.start();
    });
    showWhatCounts();
}

void RefineDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    takeTarget();
    lookSoon();
}

void RefineDialog::hideEvent(QHideEvent* event)
{
    wait_.stop();
    shown_.takeBack();
    QDialog::hideEvent(event);
}

std::optional<ObjectId> RefineDialog::target() const
{
    if (selection_.objects().size() != 1)
        return std::nullopt;
    return *selection_.objects().begin();
}

// The boxes begin with what the surface has.
void RefineDialog::takeTarget()
{
    shown_.takeBack();
    taken_ = target();
    const SharedObject object = taken_ ? document_.scene().find(*taken_) : nullptr;
    if (!object)
        return;
    const NurbsSurface& surface = object->surface;
    const std::pair<QSpinBox*, int> numbers[] = {{countU_, surface.countU()},
                                                 {countV_, surface.countV()},
                                                 {degreeU_, surface.degreeU()},
                                                 {degreeV_, surface.degreeV()}};
    for (const auto& [box, value] : numbers) {
        const QSignalBlocker quiet(box);
        box->setValue(value);
    }
    offerParameter();
}

// The middle of the longest span, or the knot nearest the middle where one is to go.
void RefineDialog::offerParameter()
{
    const SharedObject object = taken_ ? document_.scene().find(*taken_) : nullptr;
    if (!object)
        return;
    const KnotVector& knots = knotsOf(object->surface, direction());
    const double length = knots.domainEnd() - knots.domainStart();
    const double middle = knots.domainStart() + length / 2;
    double offered = middle;
    double best = 0;
    for (const int span : knots.spans()) {
        const double at = knots[span];
        if (kind() == RefinementKind::removeKnot) {
            if (at > knots.domainStart() &&
                (best == 0 || std::abs(at - middle) < std::abs(offered - middle))) {
                offered = at;
                best = 1;
            }
        } else if (knots[span + 1] - at > best) {
            best = knots[span + 1] - at;
            offered = at + best / 2;
        }
    }
    const QSignalBlocker quiet(parameter_);
    parameter_->setRange(knots.domainStart(), knots.domainEnd());
    parameter_->setSingleStep(length / 100);
    parameter_->setValue(offered);
}

RefinementKind RefineDialog::kind() const
{
    return static_cast<RefinementKind>(kind_->currentData().toInt());
}

Direction RefineDialog::direction() const
{
    return static_cast<Direction>(direction_->currentData().toInt());
}

RefinementRequest RefineDialog::request() const
{
    RefinementRequest request;
    request.kind = kind();
    request.direction = direction();
    request.parameter = parameter_->value();
    request.tolerance = tolerance_->value();
    request.shape = {countU_->value(), countV_->value(), degreeU_->value(), degreeV_->value()};
    return request;
}

void RefineDialog::lookSoon()
{
    mayShow_ = true;
    done_.clear();
    wait_.start();
}

void RefineDialog::look()
{
    wait_.stop();
    shown_.takeBack();
    edit_ = {};
    apply_->setEnabled(false);
    const std::optional<ObjectId> id = target();
    const Scene& scene = document_.scene();
    const SharedObject object = id ? scene.find(*id) : nullptr;
    const QString suffix = " " + QString::fromStdString(scene.units());
    if (tolerance_->suffix() != suffix)  // else a number that is being typed would be rewritten
        tolerance_->setSuffix(suffix);
    if (!object) {
        details_->setText(selection_.objects().empty() ? tr("Select a surface: click it in the viewport.")
                                                       : tr("Select one surface only."));
        return;
    }
    RefinementRequest wanted = request();
    wanted.tolerance /= largestScale(object->transform);
    auto refinement = refined(*object, wanted);
    if (!refinement) {
        details_->setText(QString::fromStdString(refinement.error().sentence()));
        return;
    }
    details_->setText(done_.isEmpty() ? report(*object, *refinement) : done_);
    edit_.set(*id, std::make_shared<SceneObject>(std::move(refinement->object)));
    if (refinement->other) {
        Scene numbered = scene;  // hands out the id
        const ObjectId second = numbered.add(*std::move(refinement->other));
        edit_.set(second, numbered.find(second));
    }
    apply_->setEnabled(true);
    if (preview_->isChecked() && mayShow_ && isVisible())
        shown_.show(edit_);
}

QString RefineDialog::report(const SceneObject& before, const RefinedObject& after) const
{
    const auto net = [](const NurbsSurface& surface) {
        return tr("%1 × %2 control points of degree %3 × %4")
            .arg(surface.countU())
            .arg(surface.countV())
            .arg(surface.degreeU())
            .arg(surface.degreeV());
    };
    QStringList lines{tr("Now: %1").arg(net(before.surface)), tr("Then: %1").arg(net(after.object.surface))};
    if (after.other)
        lines << tr("and a second surface: %1").arg(net(after.other->surface));
    const double scale = largestScale(before.transform);
    const double rounding = 1e-12 * before.surface.bounds().diagonal();
    const QString units = QString::fromStdString(document_.scene().units());
    if (after.deviation.bound <= rounding)
        lines << tr("The shape stays as it is.");
    else
        lines << tr("The surface moves by %1 %3 somewhere, and nowhere by more than %2 %3.")
                     .arg(scale * after.deviation.measured, 0, 'g', 3)
                     .arg(scale * after.deviation.bound, 0, 'g', 3)
                     .arg(units);
    return lines.join('\n');
}

void RefineDialog::apply()
{
    if (wait_.isActive())
        look();
    if (edit_.isEmpty())
        return;
    shown_.apply(edit_);
    mayShow_ = false;
    done_ = tr("Done. Apply does it once more; another choice is shown first.");
    taken_ = target();
    look();
}

}  // namespace knotspan
