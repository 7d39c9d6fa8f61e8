// The window: a document, the viewport on it, and what the lists of panels and actions put around it.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QMainWindow>

#include "model/document/document_friends.h"
#include "ui/questions.h"
#include "ui/tools/selection.h"
#include "ui/viewport/shown_friends.h"
#include "ui/viewport/viewport.h"

class QDockWidget;
class QLabel;
class QToolBar;

namespace knotspan {

class CommandKeys;
class DocumentFiles;
class MessageBar;
class ReadingLine;
class Recovery;
class RecoveryBar;
class StartPage;
struct ToolInfo;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Questions questions = askTheUser());
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return document_; }
    [[nodiscard]] Selection& selection() { return selection_; }
    [[nodiscard]] DocumentFriends& friends() { return friends_; }
    [[nodiscard]] ShownFriends& shownFriends() { return shownFriends_; }
    [[nodiscard]] Viewport& viewport() { return *viewport_; }
    [[nodiscard]] DocumentFiles& files() { return *files_; }
    // From now on keeps what a crash would lose in that folder, and offers what was left there.
    void keepForRecovery(const std::filesystem::path& folder, std::chrono::milliseconds interval);
    [[nodiscard]] QAction* action(std::string_view id) const;  // of actionList()
    // All of those and what shows panels and the tool bar, in the order of the menus. objectName() is the id.
    [[nodiscard]] QList<QAction*> commands() const;
    [[nodiscard]] CommandKeys& commandKeys() { return *commandKeys_; }
    // In the viewport's place, until another model comes or this one changes.
    void showStartPage(bool on = true);
    [[nodiscard]] bool isStartPageShown() const;
    // The sentence that the message bar shows; empty: none.
    [[nodiscard]] QString message() const;

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // main_window_layout.cpp
    void makeCentre();
    void makeStartPage();
    void makeActions();
    void makeMenus();
    void makePanels();
    void makeToolBar();
    void makeStatusBar();
    void restoreLayout();

    void letGoOfEdge();
    void showTitle();
    [[nodiscard]] QString navigationHint(const ToolInfo& tool) const;
    void showActionStates();
    void showFrameLine(const FrameStats& stats);

    Document document_;
    DocumentFriends friends_{document_};
    ShownFriends shownFriends_{friends_};
    Selection selection_;
    std::map<std::string, QAction*, std::less<>> actions_;
    CommandKeys* commandKeys_ = nullptr;
    Viewport* viewport_ = nullptr;
    StartPage* startPage_ = nullptr;
    MessageBar* messages_ = nullptr;
    ReadingLine* readingLine_ = nullptr;
    RecoveryBar* recoveryBar_ = nullptr;
    std::unique_ptr<DocumentFiles> files_;
    std::unique_ptr<Recovery> recovery_;  // null: nothing is kept
    QLabel* frameLine_ = nullptr;
    QToolBar* toolBar_ = nullptr;
    std::vector<QDockWidget*> panels_;
};

}  // namespace knotspan
