#include "model/files/length_units.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace knotspan::formats {

std::string unitCalled(const std::string& name)
{
    static const std::map<std::string, std::string> kNames{
        {"MICROMETRE", "um"}, {"MICROMETER", "um"}, {"UM", "um"},         {"MILLIMETRE", "mm"},
        {"MILLIMETER", "mm"}, {"MM", "mm"},         {"CENTIMETRE", "cm"}, {"CENTIMETER", "cm"},
        {"CM", "cm"},         {"METRE", "m"},       {"METER", "m"},       {"M", "m"},
        {"KILOMETRE", "km"},  {"KILOMETER", "km"},  {"KM", "km"},         {"INCH", "in"},
        {"INCHES", "in"},     {"IN", "in"},         {"FOOT", "ft"},       {"FEET", "ft"},
        {"FT", "ft"},         {"MILE", "mi"},       {"MI", "mi"},         {"MIL", "mil"},
        {"MICROINCH", "uin"}, {"UIN", "uin"}};
    std::string upper = name;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const auto known = kNames.find(upper);
    return known == kNames.end() ? name : known->second;
}

double millimetresIn(const std::string& unit)
{
    static const std::map<std::string, double> kUnits{
        {"um", 0.001}, {"mm", 1},     {"cm", 10},      {"m", 1000},     {"km", 1e6},
        {"in", 25.4},  {"ft", 304.8}, {"mi", 1609344}, {"mil", 0.0254}, {"uin", 25.4e-6}};
    const auto known = kUnits.find(unit);
    return known == kUnits.end() ? 0 : known->second;
}

std::string conversionToMillimetres(const std::string& unit)
{
    if (unit == "mm")
        return {};
    if (unit.empty())
        return "The file names no unit of length: its numbers are taken as millimetres.";
    return "Lengths were converted from the file's unit (" + unit + ") to mm.";
}

}  // namespace knotspan::formats
