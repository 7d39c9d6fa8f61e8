#include "app/compared_units.h"

#include "app/output.h"
#include "model/files/length_units.h"
#include "model/formats/format_list.h"

namespace knotspan::app {

namespace {

bool namesUnits(const std::string& file)
{
    const formats::Format* format = formats::find(file);
    return format != nullptr && format->namesUnits;
}

}  // namespace

ComparedUnits comparedUnits(const std::string& fileA, const Scene& a, const std::string& fileB,
                            const Scene& b)
{
    if (!namesUnits(fileA) || !namesUnits(fileB)) {
        const bool first = namesUnits(fileA);
        const ComparedUnits units{first || !namesUnits(fileB) ? a.units() : b.units(), 1};
        if (first != namesUnits(fileB))
            tell((first ? fileB : fileA) + ": The file names no unit of length: its numbers are taken as " +
                 units.name + ".");
        return units;
    }
    const double inA = formats::millimetresIn(a.units());
    const double inB = formats::millimetresIn(b.units());
    if (a.units() == b.units())
        return {a.units(), 1};
    if (!(inA > 0) || !(inB > 0)) {
        tell("Between " + a.units() + " and " + b.units() +
             " nothing is converted: one of them is no known unit.");
        return {a.units(), 1};
    }
    tell(fileB + ": Lengths were converted from " + b.units() + " to " + a.units() + ".");
    return {a.units(), inB / inA};
}

}  // namespace knotspan::app
