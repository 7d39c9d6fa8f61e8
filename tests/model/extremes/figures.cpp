#include "tests/model/extremes/figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

namespace knotspan::testing {

void FigureTable::beginRow(const std::string& name)
{
    rows_.push_back({name, std::vector<double>(columns_.size(), 0.0)});
}

void FigureTable::add(size_t column, double figure)
{
    double& worst = rows_.back().figures[column];
    worst = std::max(worst, std::isnan(figure) ? std::numeric_limits<double>::infinity() : figure);
}

void FigureTable::report() const
{
    std::string text = "| surface |";
    std::string line = "|---|";
    for (const std::string& column : columns_) {
        text += " " + column + " |";
        line += "---|";
    }
    text += "\n" + line + "\n";
    for (const Row& row : rows_) {
        text += "| " + row.name + " |";
        for (const double figure : row.figures) {
            char number[32];
            std::snprintf(number, sizeof number, " %.2g |", figure);
            text += number;
        }
        text += "\n";
    }
    std::fputs(text.c_str(), stdout);
    ::testing::Test::RecordProperty("figures", text);
}

}  // namespace knotspan::testing
