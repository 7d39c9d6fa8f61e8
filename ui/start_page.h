// What the window shows in the viewport's place while there is no model: files that were open last and the
// samples, with pictures.
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace knotspan {

class DocumentFiles;

class StartPage : public QWidget {
    Q_OBJECT

public:
    // `files` opens what is chosen and outlives it.
    StartPage(DocumentFiles& files, QWidget* parent = nullptr);

protected:
    // Recent files and their pictures are looked up each time.
    void showEvent(QShowEvent* event) override;

private:
    void makeLayout();
    [[nodiscard]] QListWidget* makeList(const char* id, const QString& name, const QString& tip);
    void fillWithSamples();
    void fillWithRecent();

    DocumentFiles& files_;
    QPushButton* open_ = nullptr;
    QPushButton* new_ = nullptr;
    QLabel* recentTitle_ = nullptr;
    QListWidget* recent_ = nullptr;
    QListWidget* samples_ = nullptr;
};

}  // namespace knotspan
