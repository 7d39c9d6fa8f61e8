// What became of files whose pictures were compared, for people.
#include <algorithm>
#include <cctype>
#include <iomanip>
#include <map>
#include <sstream>

#include "tests/corpus/compared_pictures.h"

namespace knotspan::corpus {
namespace {

struct Row {
    int files = 0;
    int unread = 0;
    int agree = 0;
    int faces = 0;
    int trimmed = 0;
    int untrimmed = 0;
    size_t openings = 0;
    size_t wide = 0;
    size_t otherFaces = 0;
    double worst = 0;

    void add(const ComparedFile& one)
    {
        ++files;
        unread += one.unread.empty() ? 0 : 1;
        if (!one.unread.empty())
            return;
        agree += one.agrees() ? 1 : 0;
        faces += one.faces;
        trimmed += one.trimmed;
        untrimmed += one.untrimmed;
        openings += one.gaps + one.leaks;
        wide += one.wide;
        otherFaces += one.otherFaces;
        worst = std::max(worst, one.worst);
    }
};

}  // namespace

bool isStep(const ModelFile& file)
{
    std::string extension = file.path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".step" || extension == ".stp" || extension == ".p21";
}

std::string headerOfComparisons()
{
    return "corpus\tfile\tagrees\tfaces\ttrimmed\tuntrimmed\trefused\tunmeshed\tworst\tview\tgaps\tleaks\twid"
           "e\t"
           "other_faces\tshown\tslack_px\tunread";
}

std::string lineOf(const ComparedFile& one)
{
    std::ostringstream line;
    line << one.corpus << '\t' << one.file << '\t'
         << (!one.unread.empty() ? "unread" : (one.agrees() ? "yes" : "NO")) << '\t' << one.faces << '\t'
         << one.trimmed << '\t' << one.untrimmed << '\t' << one.refused << '\t' << one.unmeshed << '\t'
         << std::setprecision(3) << one.worst << '\t' << one.worstView << '\t' << one.gaps << '\t'
         << one.leaks << '\t' << one.wide << '\t' << one.otherFaces << '\t' << one.shown << '\t'
         << one.slackPx << '\t' << one.unread;
    return line.str();
}

std::string tableOf(const std::vector<ComparedFile>& compared)
{
    std::map<std::string, Row> rows;
    for (const ComparedFile& one : compared) {
        rows[one.corpus].add(one);
        rows["all"].add(one);
    }
    std::ostringstream table;
    table << "| corpus | STEP files | not read | agree | faces | trimmed | drawn whole | worst silhouette | "
             "gaps | two pixels wide | another face |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const auto& [name, row] : rows)
        table << "| " << name << " | " << row.files << " | " << row.unread << " | " << row.agree << " | "
              << row.faces << " | " << row.trimmed << " | " << row.untrimmed << " | " << std::setprecision(2)
              << 100 * row.worst << " % | " << row.openings << " | " << row.wide << " | " << row.otherFaces
              << " |\n";
    return table.str();
}

}  // namespace knotspan::corpus
