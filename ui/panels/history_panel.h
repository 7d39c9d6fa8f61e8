// The steps of the document, the latest below; a click goes back or forth to how the model was after one.
#pragma once

#include <QListWidget>

#include "model/document/document.h"

namespace knotspan {

class HistoryPanel : public QListWidget {
    Q_OBJECT

public:
    // The document outlives it.
    explicit HistoryPanel(Document& document, QWidget* parent = nullptr);

private:
    void takeOver();
    void go(int row);

    Document& document_;
    bool isTaking_ = false;
};

}  // namespace knotspan
