// A part of the panel Tools: labelled boxes that show what the viewport's tools are told, and tell it.
#pragma once

#include <QGroupBox>

#include "ui/viewport/viewport.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace knotspan {

class ToolForm : public QGroupBox {
    Q_OBJECT

public:
    // Document and viewport outlive it.
    ToolForm(Document& document, Viewport& viewport, const QString& title, QWidget* parent);

protected:
    // From what the viewport has, and back.
    virtual void show(const ToolSettings& settings) = 0;
    virtual void read(ToolSettings& settings) const = 0;
    // Once all boxes are made.
    void begin();

    struct Range {
        double least = 0;
        double most = 1e9;
        int decimals = 4;
    };
    QComboBox* list(const char* id, const QString& label, const QString& tip, const QStringList& texts);
    QDoubleSpinBox* number(const char* id, const QString& label, const QString& tip, const Range& range);
    QCheckBox* check(const char* id, const QString& text, const QString& tip);

    [[nodiscard]] const Document& document() const { return document_; }
    [[nodiscard]] QString units() const;      // as a suffix
    [[nodiscard]] double stepLength() const;  // some tens across the model

private:
    void takeOver();  // from the viewport
    void tell();      // the viewport

    Document& document_;
    Viewport& viewport_;
    QFormLayout* form_ = nullptr;
    bool isTelling_ = false;
};

}  // namespace knotspan
