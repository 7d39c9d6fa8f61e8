// The window: a document, the viewport on it, the panels beside it, and the actions on all of them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <QMainWindow>
#include <QPointer>

#include "model/document/document.h"
#include "ui/questions.h"
#include "ui/tools/selection.h"
#include "ui/viewport/viewport.h"

class QDockWidget;
class QLabel;
class QMenu;
class QToolBar;

namespace knotspan {

class KeysDialog;
class MessageBar;
class SpeedDialog;
class StatsPanel;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Questions questions = askTheUser());
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return document_; }
    [[nodiscard]] Selection& selection() { return selection_; }
    [[nodiscard]] Viewport& viewport() { return *viewport_; }
    [[nodiscard]] StatsPanel& stats() { return *stats_; }
    [[nodiscard]] QAction* action(std::string_view id) const;  // of actionList()
    // The sentence that the message bar shows; empty: none.
    [[nodiscard]] QString message() const;

    // Opens the first, adds the others; asks first where changes would be lost. What fails is said in the
    // message bar, the open document stays.
    void openFiles(const std::vector<std::filesystem::path>& files);
    void openSample(const std::string& name);

    // What the actions do.
    void askAndOpen();
    void askAndAdd();
    bool save();  // false where it failed or was called off; so for the next
    bool saveAs();
    void undo();
    void redo();
    void escape();
    void selectAll();
    void deleteSelected();
    void setOrthographic(bool on);
    void setControlNets(bool on);
    void setKnotLines(bool on);
    void changeUniformCells(int by);  // of the path cpu
    void showSpeed();
    void showKeys();
    void showAbout();

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // main_window_layout.cpp
    void makeCentre();
    void makeActions();
    void makeMenus();
    void makePanels();
    void makeToolBar();
    void makeStatusBar();
    void fillSamples(QMenu& menu);
    void fillRecentFiles(QMenu& menu);
    void addPanel(Qt::DockWidgetArea area, const char* name, const QString& title, QWidget* content);
    void restoreLayout();

    bool mayDropDocument();
    bool openFile(const std::filesystem::path& path);
    // `trimmedBefore`: how many trimmed faces the user knows of.
    void addFiles(const std::vector<std::filesystem::path>& files, std::ptrdiff_t trimmedBefore);
    void report(const Error& error);
    void showTitle();
    void showActionStates();
    void showFrameLine(const FrameStats& stats);

    Questions questions_;
    Document document_;
    Selection selection_;
    std::map<std::string, QAction*, std::less<>> actions_;
    Viewport* viewport_ = nullptr;
    MessageBar* messages_ = nullptr;
    StatsPanel* stats_ = nullptr;
    QLabel* frameLine_ = nullptr;
    QToolBar* toolBar_ = nullptr;
    QPointer<KeysDialog> keys_;
    SpeedDialog* speed_ = nullptr;  // made when it is first shown
    std::vector<QDockWidget*> panels_;
};

}  // namespace knotspan
