#include "ui/tools/scene_watch.h"

namespace knotspan {

std::uint64_t SceneWatch::change(const ToolContext& context)
{
    if (document_ != &context.document || selection_ != &context.selection) {
        document_ = &context.document;
        selection_ = &context.selection;
        ear_ = std::make_unique<QObject>();
        QObject::connect(&context.document, &Document::sceneChanged, ear_.get(), [this] { ++change_; });
        QObject::connect(&context.selection, &Selection::changed, ear_.get(),
                         [this] { isSelectionNews_ = true; });
        ++change_;
        isSelectionNews_ = true;
    }
    if (isSelectionNews_) {
        isSelectionNews_ = false;
        if (objects_ != context.selection.objects() || points_ != context.selection.points()) {
            objects_ = context.selection.objects();
            points_ = context.selection.points();
            ++change_;
        }
    }
    return change_;
}

}  // namespace knotspan
