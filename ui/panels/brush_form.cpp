#include "ui/panels/brush_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>

namespace knotspan {

BrushForm::BrushForm(Document& document, Viewport& viewport, QWidget* parent)
    : ToolForm(document, viewport, tr("Brushes"), parent)
{
    radius_ = number("brush-radius", tr("&Brush radius"),
                     tr("The circle's radius in pixels; the keys [ and ] change it"),
                     {kLeastBrushPx, kMostBrushPx, 0});
    radius_->setSuffix(tr(" pixels"));
    strength_ =
        number("brush-strength", tr("S&trength"),
               tr("How much a stroke of smooth, inflate or flatten does; grab follows the hand"), {0, 1, 2});
    strength_->setSingleStep(0.1);
    shape_ = list("brush-shape", tr("Fade&s"), tr("How the brush fades out towards its circle"),
                  {tr("smooth"), tr("sphere"), tr("linear"), tr("sharp"), tr("constant")});
    begin();
}

void BrushForm::show(const ToolSettings& settings)
{
    radius_->setValue(settings.brush.radiusPx);
    strength_->setValue(settings.brush.strength);
    shape_->setCurrentIndex(static_cast<int>(settings.brush.shape));
}

void BrushForm::read(ToolSettings& settings) const
{
    settings.brush = {radius_->value(), strength_->value(),
                      static_cast<FalloffShape>(shape_->currentIndex())};
}

}  // namespace knotspan
