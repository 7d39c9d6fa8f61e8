// The list of the scene's objects; choosing there and in the viewport is one and the same selection.
#pragma once

#include <QListView>

#include "model/document/object_list.h"
#include "ui/tools/selection.h"

namespace knotspan {

class ObjectsPanel : public QListView {
    Q_OBJECT

public:
    ObjectsPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override { return {200, 300}; }

private:
    void choose();
    void showChosen();

    Selection& selection_;
    ObjectList* list_;
    bool following_ = false;  // showing the selection, not making it
};

}  // namespace knotspan
