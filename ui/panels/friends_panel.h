// Where surfaces meet, and how smoothly: a table to sort and filter, the tolerances, and a graph along the
// chosen edge. A click goes to the worst point; with the keyboard the arrows choose and Enter goes there.
// Nothing is computed while the panel is hidden.
#pragma once

#include <QWidget>

#include "ui/panels/friends_table.h"
#include "ui/viewport/viewport.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QStackedWidget;
class QTableView;

namespace knotspan {

class FriendGraph;

class FriendsPanel : public QWidget {
    Q_OBJECT

public:
    // All outlive the panel.
    FriendsPanel(Document& document, ShownFriends& shown, Viewport& viewport, QWidget* parent = nullptr);

    // Chooses an edge, by its number in the table, and goes to where it is worst.
    void goTo(size_t number);

    [[nodiscard]] QSize sizeHint() const override { return {500, 420}; }

private:
    QWidget* makeFilter();
    QWidget* makeTolerances();
    QWidget* makeTable();
    QWidget* makeLegend();
    void follow();
    void choose(const QModelIndex& shown);
    void showChosen();
    void showSummary();
    void showGraph();
    void changeTolerances();
    [[nodiscard]] QString instead() const;
    [[nodiscard]] size_t numberOf(const QModelIndex& shown) const;

    Document& document_;
    ShownFriends& shown_;
    Viewport& viewport_;
    FriendsTable* table_;
    FriendsFilter* filter_;
    QTableView* view_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    QLabel* empty_ = nullptr;
    QLabel* summary_ = nullptr;
    QComboBox* which_ = nullptr;
    QLineEdit* text_ = nullptr;
    QDoubleSpinBox* gap_ = nullptr;
    QDoubleSpinBox* angle_ = nullptr;
    QComboBox* quantity_ = nullptr;
    FriendGraph* graph_ = nullptr;
    bool following_ = false;  // showing what is chosen, not choosing
};

}  // namespace knotspan
