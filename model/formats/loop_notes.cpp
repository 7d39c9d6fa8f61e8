#include "model/formats/loop_notes.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "model/trimming/loop_crossings.h"
#include "model/trimming/trim_index.h"

namespace knotspan::formats {
namespace {

constexpr double kSpokenShare = 1e-4;
constexpr size_t kNamed = 3;

// In the order of the sentences.
enum class Kind { open, nothing, crossing, around, outside, twice, gaps, empty, beyond };

struct Some {
    std::vector<std::string> names;  // of the surfaces, each once
    double share = 0;
};
using Found = std::map<Kind, Some>;

void add(Found& found, Kind kind, const std::string& name, double share)
{
    Some& some = found[kind];
    if (some.names.empty() || some.names.back() != name)
        some.names.push_back(name);
    some.share = std::max(some.share, share);
}

void add(Found& found, const LoopFinding& finding, const std::string& name)
{
    const bool isSpoken = finding.share > kSpokenShare;
    switch (finding.trouble) {
    case LoopTrouble::open:
        return add(found, Kind::open, name, finding.share);
    case LoopTrouble::gaps:
        return isSpoken ? add(found, Kind::gaps, name, finding.share) : void();
    case LoopTrouble::beyond:
        return isSpoken ? add(found, Kind::beyond, name, finding.share) : void();
    case LoopTrouble::empty:
    case LoopTrouble::enclosesNothing:
        return add(found, Kind::empty, name, 0);
    case LoopTrouble::twice:
        return add(found, Kind::twice, name, 0);
    case LoopTrouble::holeAround:
        return add(found, Kind::around, name, 0);
    case LoopTrouble::holeOutside:
        return add(found, Kind::outside, name, 0);
    case LoopTrouble::wrongWay:
    case LoopTrouble::acrossSeam:
        return;
    }
}

// What to do where what is shown is not what was meant.
std::string nextStep(Kind kind)
{
    switch (kind) {
    case Kind::open:
    case Kind::crossing:
        return " Mend them in the program that made the file, or untrim and trim anew here.";
    case Kind::around:
    case Kind::outside:
    case Kind::twice:
        return " If that is not meant, mend it in the program that made the file, or use Fill holes or "
               "Untrim.";
    case Kind::nothing:
        return " Untrim it to see it whole, or delete it.";
    case Kind::gaps:
    case Kind::empty:
    case Kind::beyond:
        return {};
    }
    return {};
}

bool leavesNothing(const TrimRegion& region)
{
    const auto index = TrimIndex::create(region);
    if (!index || !region.isTrimmed())
        return false;
    for (std::uint32_t k = 0; k < index->ksquadCount(); ++k)
        if (index->classOf(k) != KsQuadTrim::outside)
            return false;
    return true;
}

std::string sentenceOf(Kind kind, const Some& some)
{
    const bool isOne = some.names.size() == 1;
    std::string who = (isOne ? "1 surface" : std::to_string(some.names.size()) + " surfaces");
    const std::string has = isOne ? " has " : " have ";
    const std::string is = isOne ? " is " : " are ";
    const auto what = [&]() -> std::string {
        switch (kind) {
        case Kind::open:
            return has + "trim loops that do not close (by up to " + spoken(some.share) + ") and" + is +
                   "shown whole";
        case Kind::nothing:
            return has + "trim loops that leave nothing of it, and" + is + "not shown";
        case Kind::crossing:
            return has + "trim loops that cross; what lies in two of them, or twice in one, is cut out, the "
                         "rest is shown";
        case Kind::around:
            return has + "a hole around the outline; shown is what lies between the two";
        case Kind::outside:
            return has + "a hole outside of the outline; shown is what it encloses, too";
        case Kind::twice:
            return has + "the same trim loop twice; the two cancel each other, and neither is shown";
        case Kind::gaps:
            return has + "trim loops with gaps of up to " + spoken(some.share) + ", closed by lines";
        case Kind::empty:
            return has + "trim loops that enclose nothing and change nothing";
        case Kind::beyond:
            return has + "trim loops that reach up to " + spoken(some.share) +
                   " beyond it, and end at its border";
        }
        return {};
    };
    std::string names;
    for (size_t k = 0; k < std::min(kNamed, some.names.size()); ++k)
        names += (k == 0 ? "" : ", ") + some.names[k];
    if (some.names.size() > kNamed)
        names += " and " + std::to_string(some.names.size() - kNamed) + " more";
    return who + what() + ": " + names + "." + nextStep(kind);
}

}  // namespace

std::vector<std::string> loopNotes(const Scene& scene)
{
    Found found;
    int number = 0;
    for (const auto& [id, object] : scene.objects()) {
        ++number;
        if (object->trimLoops.empty())
            continue;
        const std::string name = object->name.empty() ? "Surface " + std::to_string(number) : object->name;
        const TrimRegion region(object->trimLoops, object->surface);
        const bool mayBeGone =
            std::any_of(region.findings().begin(), region.findings().end(), [](const LoopFinding& finding) {
                return finding.trouble == LoopTrouble::enclosesNothing ||
                       finding.trouble == LoopTrouble::twice || finding.trouble == LoopTrouble::empty ||
                       (finding.trouble == LoopTrouble::beyond && finding.share > kSpokenShare);
            });
        if (mayBeGone && leavesNothing(region)) {
            add(found, Kind::nothing, name, 0);
            continue;
        }
        for (const LoopFinding& finding : region.findings())
            add(found, finding, name);
        if (!crossingsOf(region).empty())
            add(found, Kind::crossing, name, 0);
    }
    std::vector<std::string> sentences;
    for (const auto& [kind, some] : found)
        sentences.push_back(sentenceOf(kind, some));
    return sentences;
}

}  // namespace knotspan::formats
