#include "app/look_options.h"

#include <glm/geometric.hpp>

#include "app/drawing_options.h"

namespace knotspan::app {

namespace {

std::string nameOf(Shading shading)
{
    for (const ShadingInfo& info : shadings())
        if (info.id == shading)
            return info.name;
    return {};
}

// An option that nobody would read is a mistake.
void isFor(const std::string& option, bool given, Shading shading, const std::vector<Shading>& readers)
{
    if (!given || std::find(readers.begin(), readers.end(), shading) != readers.end())
        return;
    std::vector<std::string> names;
    for (const Shading reader : readers)
        names.push_back(nameOf(reader));
    throw CLI::ValidationError(option, "is for --shading " + joined(names, " or "));
}

NumberRange parseRange(const std::string& text)
{
    const auto numbers = parseNumbers("--range", text, 2);
    if (!(numbers[0] < numbers[1]))
        throw CLI::ValidationError("--range", "'" + text + "' should be the lower number, then the higher");
    return {numbers[0], numbers[1]};
}

}  // namespace

void addLookOptions(CLI::App& command, LookTexts& texts)
{
    const Look usual;
    command
        .add_option("--stripes", texts.stripes,
                    "Of zebra, reflection, isophotes: stripes over half a turn (default " +
                        std::to_string(usual.stripes) + ")")
        ->check(wholeWithin(1, kMostStripes))
        ->type_name("N");
    command.add_option("--stripe-angle", texts.stripeAngle, "And how far they are turned in the picture")
        ->check(within(-360, 360))
        ->type_name("DEG");
    addText(command, "--matcap", texts.matcap, "Of matcap: which material: " + listed(matcaps()), "NAME");
    addText(command, "--curvature", texts.curvature, "Of curvature: which one: " + listed(curvatureKinds()),
            "KIND");
    addText(command, "--range", texts.range,
            "Of curvature, deviation: from where to where colours go (default: by the model)", "LOW,HIGH");
    addText(command, "--checker", texts.checker, "Of checker: squares of one " + listed(checkers()), "BY");
    auto* squares =
        command.add_option("--squares", texts.squares, "And how many along each parameter (default 16)")
            ->check(wholeWithin(1, kMostCheckerCells))
            ->type_name("N");
    command.add_option("--square-length", texts.squareLength, "Or how long each is (default: by the model)")
        ->check(within(1e-9, 1e9))
        ->excludes(squares)
        ->type_name("D");
    addText(command, "--pull", texts.pull, "Of draft: where the mould is pulled (default z)", "X,Y,Z");
    command.add_option("--draft", texts.draft, "And the angle that has the full colour (default 5)")
        ->check(within(0.001, 90))
        ->type_name("DEG");
}

Look parseLook(const LookTexts& texts, Shading shading)
{
    const std::vector<Shading> striped{Shading::zebra, Shading::reflection, Shading::isophotes};
    isFor("--stripes", texts.stripes.has_value(), shading, striped);
    isFor("--stripe-angle", texts.stripeAngle.has_value(), shading, striped);
    isFor("--matcap", !texts.matcap.empty(), shading, {Shading::matcap});
    isFor("--curvature", !texts.curvature.empty(), shading, {Shading::curvature});
    isFor("--range", !texts.range.empty(), shading, {Shading::curvature, Shading::deviation});
    isFor("--pull", !texts.pull.empty(), shading, {Shading::draft});
    isFor("--draft", texts.draft.has_value(), shading, {Shading::draft});
    isFor("--checker", !texts.checker.empty(), shading, {Shading::checker});
    isFor("--squares", texts.squares.has_value(), shading, {Shading::checker});
    isFor("--square-length", texts.squareLength.has_value(), shading, {Shading::checker});
    Look look;
    if (!texts.checker.empty())
        look.checker = parseName("--checker", texts.checker, namesOf(checkers()), findChecker);
    if ((look.checker == CheckerBy::length ? texts.squares.has_value() : texts.squareLength.has_value()))
        throw CLI::ValidationError(texts.squares ? "--squares" : "--square-length",
                                   texts.squares ? "is for --checker parameter" : "is for --checker length");
    look.checkerCells = texts.squares.value_or(look.checkerCells);
    look.checkerLength = texts.squareLength;
    look.stripes = texts.stripes.value_or(look.stripes);
    look.stripesTurnedDegrees = texts.stripeAngle.value_or(look.stripesTurnedDegrees);
    if (!texts.matcap.empty())
        look.matcap = parseName("--matcap", texts.matcap, namesOf(matcaps()), findMatcap);
    if (!texts.curvature.empty())
        look.curvature =
            parseName("--curvature", texts.curvature, namesOf(curvatureKinds()), findCurvatureKind);
    if (!texts.range.empty())
        (shading == Shading::deviation ? look.deviationRange : look.curvatureRange) = parseRange(texts.range);
    if (!texts.pull.empty())
        look.pull = parseVec3("--pull", texts.pull);
    if (!(glm::length(look.pull) > 0))
        throw CLI::ValidationError("--pull", "is no direction");
    look.draftDegrees = texts.draft.value_or(look.draftDegrees);
    return look;
}

}  // namespace knotspan::app
