#include "model/formats/obj_notes.h"

#include <map>
#include <optional>

namespace knotspan::formats {

namespace {

struct Words {
    const char* one;
    const char* many;
};

// In the order of Skipped.
constexpr Words kWords[] = {
    {"line or point of a mesh was", "lines and points of meshes were"},
    {"curve in space was", "curves in space were"},
    {"statement about special curves and points was", "statements about special curves and points were"},
    {"statement about connected edges was", "statements about connected edges were"},
    {"call of another file was", "calls of other files were"},
    {"patch of the format's old kind was", "patches of the format's old kind were"},
};

std::string counted(int count, const Words& words)
{
    return std::to_string(count) + " " + (count == 1 ? words.one : words.many);
}

}  // namespace

bool ObjNotes::skip(std::string_view keyword)
{
    using Kind = std::optional<Skipped>;
    static const std::map<std::string_view, Kind> kinds{
        {"l", Skipped::meshLine},
        {"p", Skipped::meshLine},
        {"curv", Skipped::spaceCurve},
        {"scrv", Skipped::special},
        {"sp", Skipped::special},
        {"con", Skipped::connection},
        {"call", Skipped::call},
        {"csh", Skipped::call},
        {"bsp", Skipped::oldPatch},
        {"bzp", Skipped::oldPatch},
        {"cdc", Skipped::oldPatch},
        {"cdp", Skipped::oldPatch},
        // How things are drawn, and what only other kinds of curves need.
        {"vt", {}},
        {"vn", {}},
        {"s", {}},
        {"mg", {}},
        {"mtllib", {}},
        {"usemtl", {}},
        {"usemat", {}},
        {"maplib", {}},
        {"usemap", {}},
        {"bevel", {}},
        {"c_interp", {}},
        {"d_interp", {}},
        {"lod", {}},
        {"ctech", {}},
        {"stech", {}},
        {"shadow_obj", {}},
        {"trace_obj", {}},
        {"res", {}},
        {"bmat", {}},
        {"step", {}},
    };
    const auto found = kinds.find(keyword);
    if (found == kinds.end())
        return false;
    if (found->second)
        ++skipped_[static_cast<size_t>(*found->second)];
    return true;
}

void ObjNotes::Tally::add(int line, const std::string& reason)
{
    if (count++ == 0)
        first = "line " + std::to_string(line) + ": " + reason;
}

void ObjNotes::leaveOut(int line, const std::string& reason)
{
    leftOut_.add(line, reason);
}

void ObjNotes::leaveUntrimmed(int line, const std::string& reason)
{
    untrimmed_.add(line, reason);
}

std::vector<std::string> ObjNotes::sentences() const
{
    std::vector<std::string> notes;
    const auto say = [&](const Tally& tally, const char* what) {
        if (tally.count > 0)
            notes.push_back(std::to_string(tally.count) + " of " + std::to_string(surfaces_) +
                            (tally.count == 1 ? " surfaces was " : " surfaces were ") + what +
                            "; the first reason is: " + tally.first + ".");
    };
    say(leftOut_, "left out");
    say(untrimmed_, "read without trim curves");
    for (size_t kind = 0; kind < skipped_.size(); ++kind)
        if (skipped_[kind] > 0)
            notes.push_back(counted(skipped_[kind], kWords[kind]) + " left out.");
    return notes;
}

tl::unexpected<Error> ObjNotes::refusal() const
{
    if (leftOut_.count > 0)
        return failure("None of the file's " + std::to_string(surfaces_) +
                           " surfaces can be read; the first reason is: " + leftOut_.first,
                       "Repair the model in the program that made it");
    return failure("The file holds neither free-form surfaces nor polygons", "Choose another file");
}

}  // namespace knotspan::formats
