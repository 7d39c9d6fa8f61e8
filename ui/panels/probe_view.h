// The probes: what the surface is like under the cursor, the pinned ones in a table, how far those are from
// each other. Nothing is computed while it is hidden.
#pragma once

#include <QGroupBox>

#include "ui/panels/probe_table.h"

class QLabel;
class QPushButton;
class QTableView;

namespace knotspan {

class ProbeView : public QGroupBox {
    Q_OBJECT

public:
    // Both outlive it.
    ProbeView(Document& document, Probes& probes, QWidget* parent = nullptr);

private:
    void makeTable();
    QWidget* makeButtons();
    void follow();
    void showSelection();
    void copy() const;
    void removeSelected();
    void showDistances(const std::vector<int>& selected);
    [[nodiscard]] std::vector<int> selectedRows() const;  // from the top down

    Document& document_;
    Probes& probes_;
    ProbeTable* table_;
    QTableView* view_ = nullptr;
    QLabel* readout_ = nullptr;
    QLabel* distances_ = nullptr;
    QPushButton* copy_ = nullptr;
    QPushButton* remove_ = nullptr;
    QPushButton* clear_ = nullptr;
};

}  // namespace knotspan
