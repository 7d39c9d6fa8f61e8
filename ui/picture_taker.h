// Keeps a picture of the open file for the start page: once the viewport rests on the model as the file has
// it.
#pragma once

#include <QObject>
#include <QTimer>

#include "model/document/document.h"
#include "ui/viewport/viewport.h"

namespace knotspan {

class PictureTaker : public QObject {
    Q_OBJECT

public:
    // Both outlive it.
    PictureTaker(Document& document, Viewport& viewport, QObject* parent = nullptr);

private:
    void take();

    Document& document_;
    Viewport& viewport_;
    QTimer rest_;  // runs while a picture is wanted
};

}  // namespace knotspan
