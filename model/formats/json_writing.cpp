#include <bit>
#include <span>

#include "model/files/base64.h"
#include "model/formats/knotspan_json.h"

namespace knotspan::formats {

namespace {

using Json = nlohmann::ordered_json;  // members in the order of the format's description

Json jsonOf(const NurbsSurface& surface)
{
    Json points = Json::array();
    for (const ControlPoint& point : surface.controlPoints())
        points.push_back({point.position.x, point.position.y, point.position.z, point.weight});
    return {{"degree_u", surface.degreeU()},
            {"degree_v", surface.degreeV()},
            {"knots_u", surface.knotsU().values()},
            {"knots_v", surface.knotsV().values()},
            {"control_points", std::move(points)}};
}

Json jsonOf(const TrimCurve& curve)
{
    Json points = Json::array();
    for (const TrimPoint& point : curve.points())
        points.push_back({point.position.x, point.position.y, point.weight});
    return {{"degree", curve.knots().degree()},
            {"knots", curve.knots().values()},
            {"control_points", std::move(points)}};
}

Json jsonOf(const std::vector<TrimLoop>& loops)
{
    Json result = Json::array();
    for (const TrimLoop& loop : loops) {
        Json curves = Json::array();
        for (const TrimCurve& curve : loop.curves)
            curves.push_back(jsonOf(curve));
        result.push_back({{"outer", loop.outer}, {"curves", std::move(curves)}});
    }
    return result;
}

Json jsonOf(const Mat4& transform)
{
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            rows.push_back(transform[column][row]);
    return rows;
}

Json jsonOf(const Colour& colour)
{
    return {colour.red, colour.green, colour.blue};
}

// As text a million triangles would take minutes to read.
template <class T>
std::string bytesOf(const std::vector<T>& elements)
{
    static_assert(std::endian::native == std::endian::little);
    return base64Of(std::as_bytes(std::span(elements)));
}

std::string dumped(const Json& json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string textOf(const SceneObject& object)
{
    Json json{{"name", object.name},
              {"colour", jsonOf(object.colour)},
              {"transform", jsonOf(object.transform)},
              {"visible", object.visible},
              {"surface", jsonOf(object.surface)},
              {"trim_loops", jsonOf(object.trimLoops)}};
    if (object.sides != Sides::automatic)
        json["sides"] = sidesName(object.sides);
    if (object.locked)
        json["locked"] = true;
    return dumped(json);
}

std::string textOf(const MeshObject& object)
{
    return dumped({{"name", object.name},
                   {"colour", jsonOf(object.colour)},
                   {"transform", jsonOf(object.transform)},
                   {"visible", object.visible},
                   {"vertices", bytesOf(object.mesh->vertices)},
                   {"triangles", bytesOf(object.mesh->triangles)}});
}

std::string textOf(const std::string& value)
{
    return dumped(Json(value));
}

}  // namespace knotspan::formats
