// What a dialog shows of an edit before it is applied. Whatever else is done to the model takes it back.
#pragma once

#include "model/document/document.h"

namespace knotspan {

class Preview : public QObject {
    Q_OBJECT

public:
    // The document outlives it. `text` names the step.
    Preview(Document& document, QString text, QObject* parent);
    ~Preview() override;

    void setText(const QString& text) { text_ = text; }  // of what is shown or applied from now on

    void show(const Edit& edit);  // in the place of what is shown
    void takeBack();
    // Makes the edit, shown or not, one step.
    void apply(const Edit& edit);
    [[nodiscard]] bool isShown() const { return gesture_ != 0; }

Q_SIGNALS:
    void modelChanged();  // otherwise than by these

private:
    Document& document_;
    QString text_;
    int gesture_ = 0;      // 0: nothing is shown
    bool isOurs_ = false;  // the change of the scene that is going on
};

}  // namespace knotspan
