#include <cstdio>
#include <iostream>
#include <iterator>
#include <memory>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/output.h"
#include "model/analysis/curvature.h"

namespace knotspan::app {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string file;
    size_t surface = 0;
    std::vector<std::string> at;
    bool json = false;
};

Json list(const Vec3& vector)
{
    return {vector.x, vector.y, vector.z};
}

// The point in model space.
SurfacePoint evaluateInModel(const SceneObject& object, double u, double v)
{
    SurfacePoint point = evaluate(object.surface, u, v);
    const glm::dmat3 linear(object.transform);
    return {transformed(point.position, object.transform),
            linear * point.du,
            linear * point.dv,
            linear * point.duu,
            linear * point.duv,
            linear * point.dvv};
}

// Null where the surface has none there.
Json normalOf(const SceneObject& object, double u, double v)
{
    const SurfaceNormal normal = evaluateNormal(object.surface, u, v);
    if (!normal.exists)
        return nullptr;
    const glm::dmat3 linear(object.transform);
    const double side = glm::determinant(linear) < 0 ? -1.0 : 1.0;
    return list(glm::normalize(glm::transpose(glm::inverse(linear)) * normal.direction) * side);
}

Json describe(const SceneObject& object, size_t surface, const Vec2& uv)
{
    const SurfacePoint point = evaluateInModel(object, uv.x, uv.y);
    Json result{{"surface", surface},
                {"u", uv.x},
                {"v", uv.y},
                {"point", list(point.position)},
                {"derivatives",
                 {{"du", list(point.du)},
                  {"dv", list(point.dv)},
                  {"duu", list(point.duu)},
                  {"duv", list(point.duv)},
                  {"dvv", list(point.dvv)}}},
                {"normal", normalOf(object, uv.x, uv.y)},
                {"curvatures", nullptr}};
    if (const auto bend = curvature(point))
        result["curvatures"] = {
            {"gauss", bend->gauss}, {"mean", bend->mean}, {"principal", {bend->largest, bend->smallest}}};
    return result;
}

std::string text(const Json& value)
{
    if (value.is_null())
        return "none here";
    if (value.is_array()) {
        std::string result;
        for (const Json& entry : value)
            result += (result.empty() ? "" : " ") + text(entry);
        return result;
    }
    char number[40];
    std::snprintf(number, sizeof number, "%.17g", value.get<double>());
    return number;
}

void printForPeople(const Json& point)
{
    std::cout << "surface " << point["surface"].get<size_t>() << " at " << text(point["u"]) << ' '
              << text(point["v"]) << '\n';
    std::cout << "  point   " << text(point["point"]) << '\n';
    for (const auto& [name, value] : point["derivatives"].items())
        std::cout << "  " << name << std::string(8 - name.size(), ' ') << text(value) << '\n';
    std::cout << "  normal  " << text(point["normal"]) << '\n';
    if (point["curvatures"].is_null()) {
        std::cout << "  curvatures  none here\n";
        return;
    }
    for (const auto& [name, value] : point["curvatures"].items())
        std::cout << "  " << name << std::string(11 - name.size(), ' ') << text(value) << '\n';
}

std::string domainText(const KnotVector& knots)
{
    return text(knots.domainStart()) + " to " + text(knots.domainEnd());
}

Result<void> checkInside(const NurbsSurface& surface, const Vec2& uv)
{
    const auto inside = [](const KnotVector& knots, double t) {
        return t >= knots.domainStart() && t <= knots.domainEnd();
    };
    if (inside(surface.knotsU(), uv.x) && inside(surface.knotsV(), uv.y))
        return {};
    return failure(text(uv.x) + "," + text(uv.y) + " lies outside the surface",
                   "Choose u from " + domainText(surface.knotsU()) + " and v from " +
                       domainText(surface.knotsV()));
}

int run(const Options& options)
{
    std::vector<Vec2> places;
    for (const std::string& at : options.at) {
        const auto uv = parseNumbers("--at", at, 2);
        places.emplace_back(uv[0], uv[1]);
    }
    const auto scene = readModel(options.file);
    if (!scene)
        return failed(scene.error());
    const size_t count = scene->objects().size();
    if (options.surface >= count)
        return failed(
            Error{"There is no surface " + std::to_string(options.surface), options.file,
                  count == 0 ? "The model is empty" : "Choose one from 0 to " + std::to_string(count - 1)});
    const auto& object =
        *std::next(scene->objects().begin(), static_cast<std::ptrdiff_t>(options.surface))->second;
    Json points = Json::array();
    for (const Vec2& uv : places) {
        if (const auto inside = checkInside(object.surface, uv); !inside)
            return failed(inside.error().at(options.file + ", surface " + std::to_string(options.surface)));
        points.push_back(describe(object, options.surface, uv));
    }
    if (options.json)
        std::cout << Json{{"points", points}}.dump(2) << '\n';
    else
        for (const Json& point : points)
            printForPeople(point);
    return kDone;
}

}  // namespace

void addEvaluateCommand(CLI::App& app, int& exitCode)
{
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("evaluate", "Evaluate a surface of a model at given parameters");
    addModel(*command, options->file);
    command->add_option("--surface", options->surface, "Which surface, counted from 0")
        ->required()
        ->check(within(0, 1e9))
        ->type_name("K");
    command->add_option("--at", options->at, "Where; may be given several times")
        ->required()
        ->allow_extra_args(false)
        ->type_name("U,V");
    addJson(*command, options->json);
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace knotspan::app
