// Pinned probes as a table, one row each; what did not change stays as it is, so that a selection outlasts an
// edit.
#pragma once

#include <QAbstractTableModel>

#include "model/document/document.h"
#include "ui/tools/probes.h"

namespace knotspan {

class ProbeTable : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        number,
        object,
        paramU,
        paramV,
        x,
        y,
        z,
        normalX,
        normalY,
        normalZ,
        gauss,
        mean,
        largest,
        smallest,
        largestRadius,
        smallestRadius,
        columns
    };

    // Both outlive it. It is empty until it takes over what they say.
    ProbeTable(const Document& document, const Probes& probes, QObject* parent = nullptr);
    void takeOver();

    struct Row {
        int number = 0;
        ProbedPlace place;
    };
    [[nodiscard]] const Row& row(int at) const { return rows_[static_cast<size_t>(at)]; }
    // With a line of titles; numbers with all their digits, nothing where there is none.
    [[nodiscard]] QString tabSeparated(const std::vector<int>& rows) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] static std::optional<double> valueOf(const Row& row, int column);
    [[nodiscard]] static QString text(const Row& row, int column);
    [[nodiscard]] QString title(int column) const;

    const Document& document_;
    const Probes& probes_;
    std::vector<Row> rows_;
    std::string units_;
};

}  // namespace knotspan
