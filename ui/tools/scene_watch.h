// Tells whether the scene or what is selected has changed, so that what depends on nothing else can be kept.
#pragma once

#include <cstdint>
#include <memory>

#include <QPointer>

#include "ui/tools/tool.h"

namespace knotspan {

class SceneWatch {
public:
    // The same number as long as neither has. Costs nothing that grows with the scene.
    [[nodiscard]] std::uint64_t change(const ToolContext& context);

private:
    std::unique_ptr<QObject> ear_;  // hears of both as long as it lives
    QPointer<const Document> document_;
    QPointer<const Selection> selection_;
    std::uint64_t change_ = 0;
    bool isSelectionNews_ = false;  // perhaps only what is hovered
    std::set<ObjectId> objects_;
    PointSelection points_;
};

}  // namespace knotspan
