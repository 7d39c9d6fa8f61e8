// What the last frame cost and did: one row for each field of the statistics' table.
#pragma once

#include <QTreeWidget>

#include "renderer/stats/frame_stats.h"

namespace knotspan {

class StatsPanel : public QTreeWidget {
    Q_OBJECT

public:
    explicit StatsPanel(QWidget* parent = nullptr);

    void setStats(const FrameStats& stats);
    // What the row of the field with this JSON name shows; empty before the first frame.
    [[nodiscard]] QString shown(std::string_view fieldName) const;

    [[nodiscard]] QSize sizeHint() const override { return {310, 420}; }
};

}  // namespace knotspan
