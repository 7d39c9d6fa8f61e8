#include "ui/viewport/shown_combs.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

// Reddish purple and yellow (Okabe and Ito, 2008): apart from the surfaces and from what is selected.
constexpr std::uint32_t kAcrossUColour = 0xcc79a7;
constexpr std::uint32_t kAcrossVColour = 0xf0e442;
constexpr float kWidthPx = 1.2F;

constexpr double kTeethPerCurve = 100;
constexpr double kMostTeeth = 300'000;  // of all objects
constexpr double kMost = 0.99;          // of the teeth are no longer than asked for,
constexpr double kLongest = 3;          // and the others no longer than so many times that

SharedSpaceLines linesOf(const std::vector<IsoComb>& combs, Direction across, double scale, double longest)
{
    auto made = std::make_shared<SpaceLines>();
    made->colour = across == Direction::U ? kAcrossUColour : kAcrossVColour;
    made->widthPx = kWidthPx;
    for (const IsoComb& comb : combs) {
        if (comb.across != across)
            continue;
        Vec3 last(0);
        for (size_t k = 0; k < comb.teeth.size(); ++k) {
            const CombTooth& tooth = comb.teeth[k];
            Vec3 out = -scale * tooth.curvature;
            if (const double length = glm::length(out); length > longest)
                out *= longest / length;
            const Vec3 tip = tooth.foot + out;
            made->lines.push_back({tooth.foot, tip});
            if (k > 0)
                made->lines.push_back({last, tip});
            last = tip;
        }
    }
    return made;
}

}  // namespace

ShownCombs::ShownCombs(const Document& document, const Selection& selection, QObject* parent)
    : QObject(parent),
      document_(document),
      selection_(selection)
{
}

void ShownCombs::setSettings(const CombSettings& settings)
{
    CombSettings wanted = settings;
    wanted.curves = std::clamp(wanted.curves, 1, kMostCombCurves);
    if (wanted == settings_)
        return;
    if (wanted.curves != settings_.curves)
        combs_.clear();
    settings_ = wanted;
    Q_EMIT changed();
}

const std::vector<SharedSpaceLines>& ShownCombs::lines()
{
    lines_.clear();
    if (!settings_.shown) {
        combs_.clear();
        return lines_;
    }
    followSelection();
    const double now = scale();
    const double longest = kLongest * now * strongest_;
    for (auto& [id, comb] : combs_) {
        if (comb.scale != now || !comb.acrossU) {
            comb.scale = now;
            comb.acrossU = linesOf(comb.combs, Direction::U, now, longest);
            comb.acrossV = linesOf(comb.combs, Direction::V, now, longest);
        }
        lines_.push_back(comb.acrossU);
        lines_.push_back(comb.acrossV);
    }
    return lines_;
}

void ShownCombs::followSelection()
{
    std::map<ObjectId, SharedObject> shown;
    for (const ObjectId id : selection_.objects())
        if (const SharedObject object = document_.scene().find(id); object && object->visible)
            shown.emplace(id, object);
    std::erase_if(combs_, [&](const auto& comb) { return shown.count(comb.first) == 0; });
    const double share = kMostTeeth / (2.0 * settings_.curves * std::max<double>(1, double(shown.size())));
    strongest_ = 0;
    for (const auto& [id, object] : shown) {
        Comb& comb = combs_[id];
        const double spans =
            std::max(object->surface.knotsU().spans().size(), object->surface.knotsV().spans().size());
        follow(comb, object,
               static_cast<int>(std::clamp(std::min(kTeethPerCurve, share) / spans, 2.0, 24.0)));
        strongest_ = std::max(strongest_, comb.strongest);
    }
}

void ShownCombs::follow(Comb& comb, const SharedObject& object, int cells) const
{
    if (comb.object == object)
        return;
    comb.object = object;
    comb.combs = isoCombs(object->surface, object->transform, settings_.curves, cells, object->trimLoops);
    comb.strongest = curvatureOfMost(comb.combs, kMost);
    comb.acrossU.reset();
}

// Model units a tooth of curvature 1 is long. In steps, so that combs do not breathe while the hand drags.
double ShownCombs::scale() const
{
    constexpr double kStepsPerOctave = 2;
    const double wanted = 0.01 * settings_.longestPercent * document_.scene().bounds().diagonal();
    if (!(strongest_ > 0) || !(wanted > 0))
        return 0;
    const double scale = wanted / strongest_;
    return std::isfinite(scale) ? std::exp2(std::floor(std::log2(scale) * kStepsPerOctave) / kStepsPerOctave)
                                : 0;
}

}  // namespace knotspan
