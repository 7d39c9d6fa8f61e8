#include "tests/corpus/summary.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <map>

namespace knotspan::corpus {
namespace {

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

struct Row {
    std::vector<double> seconds;
    int outcomes[5]{};
    int leaked = 0;
    long faces = 0;
    long exact = 0;
    long approximated = 0;
    long refused = 0;
    long untrimmed = 0;
    double relativeError = 0;
    double peakMb = 0;

    void add(const Record& record)
    {
        seconds.push_back(record.computing);
        ++outcomes[static_cast<size_t>(record.outcome)];
        leaked += record.leaked;
        faces += record.faces;
        exact += record.exact;
        approximated += record.approximated;
        refused += record.refused;
        untrimmed += record.untrimmed;
        relativeError = std::max(relativeError, record.relativeError);
        peakMb = std::max(peakMb, record.peakMb);
    }

    [[nodiscard]] std::string line(const std::string& name)
    {
        std::sort(seconds.begin(), seconds.end());
        double sum = 0;
        for (const double one : seconds)
            sum += one;
        return formatted("| %s | %zu | %d | %d | %d / %d / %d / %d | %ld | %ld | %ld (%.1e) | %ld | %ld | "
                         "%.0f | %.2f | %.1f | %.0f |\n",
                         name.c_str(), seconds.size(), outcomes[0], outcomes[1], outcomes[2], outcomes[3],
                         outcomes[4], leaked, faces, exact, approximated, relativeError, refused, untrimmed,
                         sum, seconds[seconds.size() / 2], seconds.back(), peakMb);
    }
};

}  // namespace

std::string tableOf(const std::vector<Record>& records)
{
    std::map<std::string, Row> rows;
    Row all;
    for (const Record& record : records) {
        rows[record.corpus].add(record);
        all.add(record);
    }
    std::string table =
        "| corpus | files | read | refused | crashed / hung / strange / leaked | faces | exact | "
        "approximated (largest "
        "error by size) | left out | without trim curves | s of computing | median | longest | peak MB |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (auto& [name, row] : rows)
        table += row.line(name);
    if (rows.size() > 1)
        table += all.line("all");
    return table;
}

std::string reasonsOf(const std::vector<Record>& records)
{
    std::map<std::string, int> files;
    std::map<std::string, int> faces;
    for (const Record& record : records) {
        if (record.outcome != Outcome::read)
            ++files[record.sentence];
        for (const auto& [reason, count] : record.refusals)
            faces[reason] += count;
    }
    std::string text;
    for (const auto& [reason, count] : files)
        text += formatted("- %d files: ", count) + reason + "\n";
    for (const auto& [reason, count] : faces)
        text += formatted("- %d faces: ", count) + reason + "\n";
    return text;
}

std::string wrongsOf(const std::vector<Record>& records)
{
    std::string lines;
    for (const Record& record : records)
        if ((record.outcome != Outcome::read && record.outcome != Outcome::refused) || record.leaked != 0)
            lines += lineOf(record) + "\n";
    return lines;
}

}  // namespace knotspan::corpus
