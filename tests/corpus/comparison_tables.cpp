// What became of files whose pictures were compared, for people.
#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

#include "model/formats/format_list.h"
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
    size_t silhouette = 0;
    size_t unlike = 0;
    size_t shown = 0;
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
        silhouette += one.silhouette;
        unlike += one.unlike;
        shown += one.shown;
        openings += one.gaps + one.leaks;
        wide += one.wide;
        otherFaces += one.otherFaces;
        worst = std::max(worst, one.worst);
    }
};

}  // namespace

std::string cadFormatOf(const ModelFile& file)
{
    const formats::Format* format = formats::find(file.path);
    const bool cad =
        format != nullptr && (format->name == "STEP" || format->name == "IGES" || format->name == "BREP");
    return cad ? format->name : std::string();
}

std::string headerOfComparisons()
{
    return "corpus\tfile\tagrees\tfaces\ttrimmed\tuntrimmed\trefused\tunmeshed\tworst\tview\tsilhouette\tunli"
           "ke\tgaps\tleaks\twid"
           "e\t"
           "other_faces\tshown\tslack_px\tunread";
}

std::string lineOf(const ComparedFile& one)
{
    std::ostringstream line;
    line << one.corpus << '\t' << one.file << '\t'
         << (!one.unread.empty() ? "unread" : (one.agrees() ? "yes" : "NO")) << '\t' << one.faces << '\t'
         << one.trimmed << '\t' << one.untrimmed << '\t' << one.refused << '\t' << one.unmeshed << '\t'
         << std::setprecision(3) << one.worst << '\t' << one.worstView << '\t' << one.silhouette << '\t'
         << one.unlike << '\t' << one.gaps << '\t' << one.leaks << '\t' << one.wide << '\t' << one.otherFaces
         << '\t' << one.shown << '\t' << one.slackPx << '\t' << one.unread;
    return line.str();
}

std::string tableOf(const std::vector<ComparedFile>& compared)
{
    std::map<std::string, Row> rows;
    for (const ComparedFile& one : compared) {
        rows[one.corpus + ", " + one.format].add(one);
        rows["all " + one.format].add(one);
    }
    std::ostringstream table;
    table << "| corpus | files | not read | agree | faces | trimmed | drawn whole | worst silhouette | "
             "silhouette's "
             "pixels | unlike | gaps, of pixels | two pixels wide | another face |\n"
             "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const auto& [name, row] : rows)
        table << "| " << name << " | " << row.files << " | " << row.unread << " | " << row.agree << " | "
              << row.faces << " | " << row.trimmed << " | " << row.untrimmed << " | " << std::setprecision(2)
              << 100 * row.worst << " % | " << row.silhouette << " | " << row.unlike << " | " << row.openings
              << " of " << row.shown << " | " << row.wide << " | " << row.otherFaces << " |\n";
    return table.str();
}

}  // namespace knotspan::corpus
