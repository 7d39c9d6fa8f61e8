// The worst figures of an evaluation on each extreme surface: asserted, recorded and printed as a table.
#pragma once

#include <string>
#include <vector>

namespace knotspan::testing {

// One row of figures, by column; `add` keeps the largest. A figure that is no number counts as infinite.
class FigureTable {
public:
    explicit FigureTable(std::vector<std::string> columns) : columns_(std::move(columns)) {}

    void beginRow(const std::string& name);
    void add(size_t column, double figure);
    [[nodiscard]] double worst(size_t column) const { return rows_.back().figures[column]; }

    // Prints the table (Markdown) and records it with the running test, as `figures`.
    void report() const;

private:
    struct Row {
        std::string name;
        std::vector<double> figures;
    };
    std::vector<std::string> columns_;
    std::vector<Row> rows_;
};

}  // namespace knotspan::testing
