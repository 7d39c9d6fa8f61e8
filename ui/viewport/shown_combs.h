// Curvature combs on iso-curves of the selected surfaces (model/analysis/curvature_comb.h), for the picture:
// made again only for surfaces that changed.
#pragma once

#include <map>

#include "model/analysis/curvature_comb.h"
#include "model/document/document.h"
#include "renderer/frame.h"
#include "ui/tools/selection.h"

namespace knotspan {

constexpr int kMostCombCurves = 50;

struct CombSettings {
    bool shown = false;
    int curves = 5;             // each way, 1 .. kMostCombCurves
    double longestPercent = 8;  // how long the longest teeth are, of the model's size; about

    [[nodiscard]] bool operator==(const CombSettings&) const = default;
};

class ShownCombs : public QObject {
    Q_OBJECT

public:
    // Both outlive it.
    ShownCombs(const Document& document, const Selection& selection, QObject* parent = nullptr);

    [[nodiscard]] const CombSettings& settings() const { return settings_; }
    void setSettings(const CombSettings& settings);

    // What the next picture has to show; where that is nothing, nothing is computed.
    [[nodiscard]] const std::vector<SharedSpaceLines>& lines();
    // Of the teeth that lines() showed last: the strongest, but for one in a hundred; 1 per model unit.
    [[nodiscard]] double strongest() const { return strongest_; }

Q_SIGNALS:
    void changed();

private:
    struct Comb {
        SharedObject object;
        std::vector<IsoComb> combs;
        double strongest = 0;
        double scale = 0;  // of the lines
        SharedSpaceLines acrossU;
        SharedSpaceLines acrossV;
    };
    void followSelection();
    void follow(Comb& comb, const SharedObject& object, int cells) const;
    [[nodiscard]] double scale() const;

    const Document& document_;
    const Selection& selection_;
    CombSettings settings_;
    std::map<ObjectId, Comb> combs_;
    double strongest_ = 0;
    std::vector<SharedSpaceLines> lines_;
};

}  // namespace knotspan
