#include <cmath>
#include <cstring>

#include "model/files/base64.h"
#include "model/formats/knotspan_json.h"
#include "model/geometry/loop_direction.h"

namespace knotspan::formats {

namespace {

using nlohmann::json;

// Says which value is meant while one reader calls another: `objects[3], surface, knots_u`. Throws Error;
// sceneFromJson() is the border that catches it.
class Place {
public:
    Place(const json& value, std::string name) : value_(value), name_(std::move(name)) {}

    [[nodiscard]] const json& value() const { return value_; }

    [[noreturn]] void refuse(const std::string& why) const
    {
        throw Error{name_.empty() ? why : name_ + ": " + why, {}, {}};
    }

    [[nodiscard]] Place member(const char* key) const
    {
        if (!value_.is_object())
            refuse(std::string("is not an object with members, but ") + value_.type_name());
        const auto found = value_.find(key);
        if (found == value_.end())
            refuse(std::string("\"") + key + "\" is missing");
        return {*found, name_.empty() ? key : name_ + ", " + key};
    }
    [[nodiscard]] bool has(const char* key) const { return value_.is_object() && value_.contains(key); }

    [[nodiscard]] size_t size() const
    {
        if (!value_.is_array())
            refuse(std::string("is not a list, but ") + value_.type_name());
        return value_.size();
    }
    [[nodiscard]] Place element(size_t index) const
    {
        return {value_[index], name_ + "[" + std::to_string(index) + "]"};
    }

    [[nodiscard]] double number() const
    {
        if (!value_.is_number())
            refuse(std::string("is not a number, but ") + value_.type_name());
        return value_.get<double>();
    }
    [[nodiscard]] std::string text() const
    {
        if (!value_.is_string())
            refuse(std::string("is not a text, but ") + value_.type_name());
        return value_.get<std::string>();
    }
    [[nodiscard]] bool yesOrNo() const
    {
        if (!value_.is_boolean())
            refuse(std::string("is not true or false, but ") + value_.type_name());
        return value_.get<bool>();
    }

    // A list of so many numbers, without naming each unless it is wrong: models are mostly these.
    template <size_t N>
    [[nodiscard]] std::array<double, N> numbers() const
    {
        if (size() != N)
            refuse("has " + std::to_string(size()) + " numbers, not " + std::to_string(N));
        std::array<double, N> result;
        for (size_t i = 0; i < N; ++i)
            result[i] = value_[i].is_number() ? value_[i].template get<double>() : element(i).number();
        return result;
    }

    // The value of a result, or its error, said of this place.
    template <class T>
    [[nodiscard]] T valid(Result<T> result) const
    {
        if (!result)
            refuse(result.error().what);
        return *std::move(result);
    }

private:
    const json& value_;
    std::string name_;
};

KnotVector knotsOf(const Place& degree, const Place& knots)
{
    const double asked = degree.number();
    if (!(asked >= kMinDegree && asked <= kMaxDegree) || asked != std::floor(asked))
        degree.refuse("is no whole number from " + std::to_string(kMinDegree) + " to " +
                      std::to_string(kMaxDegree));
    std::vector<double> values(knots.size());
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = knots.element(i).number();
    return knots.valid(KnotVector::create(static_cast<int>(asked), std::move(values)));
}

NurbsSurface surfaceOf(const Place& place)
{
    KnotVector knotsU = knotsOf(place.member("degree_u"), place.member("knots_u"));
    KnotVector knotsV = knotsOf(place.member("degree_v"), place.member("knots_v"));
    const Place list = place.member("control_points");
    std::vector<ControlPoint> points(list.size());
    for (size_t i = 0; i < points.size(); ++i) {
        const auto [x, y, z, w] = list.element(i).numbers<4>();
        points[i] = {{x, y, z}, w};
    }
    return list.valid(NurbsSurface::create(std::move(knotsU), std::move(knotsV), std::move(points)));
}

TrimCurve trimCurveOf(const Place& place)
{
    KnotVector knots = knotsOf(place.member("degree"), place.member("knots"));
    const Place list = place.member("control_points");
    std::vector<TrimPoint> points(list.size());
    for (size_t i = 0; i < points.size(); ++i) {
        const auto [u, v, w] = list.element(i).numbers<3>();
        points[i] = {{u, v}, w};
    }
    return list.valid(TrimCurve::create(std::move(knots), std::move(points)));
}

std::vector<TrimLoop> trimLoopsOf(const Place& place)
{
    std::vector<TrimLoop> loops;
    for (size_t i = 0; i < place.size(); ++i) {
        TrimLoop loop{place.element(i).member("outer").yesOrNo(), {}};
        const Place curves = place.element(i).member("curves");
        for (size_t k = 0; k < curves.size(); ++k)
            loop.curves.push_back(trimCurveOf(curves.element(k)));
        loops.push_back(oriented(std::move(loop)));
    }
    return loops;
}

Colour colourOf(const Place& place)
{
    const auto [red, green, blue] = place.numbers<3>();
    for (const double part : {red, green, blue})
        if (!(part >= 0 && part <= 1))
            place.refuse("has a part outside 0 to 1");
    return {red, green, blue};
}

// Row by row, as it is written on paper.
Mat4 transformOf(const Place& place)
{
    const auto numbers = place.numbers<16>();
    Mat4 result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result[column][row] = numbers[static_cast<size_t>(4 * row + column)];
    if (numbers[12] != 0 || numbers[13] != 0 || numbers[14] != 0 || numbers[15] != 1)
        place.refuse("does not end with the row 0, 0, 0, 1");
    const double volume = glm::determinant(result);
    if (!std::isfinite(volume) || volume == 0)
        place.refuse("flattens the object: it cannot be undone");
    return result;
}

// Files from before there was a choice have none.
Sides sidesOf(const Place& object)
{
    if (!object.has("sides"))
        return Sides::automatic;
    const Place place = object.member("sides");
    const auto sides = findSides(place.text());
    if (!sides)
        place.refuse("is not automatic, both, front or back");
    return *sides;
}

SceneObject objectOf(const Place& place)
{
    return {place.member("name").text(),
            colourOf(place.member("colour")),
            transformOf(place.member("transform")),
            place.member("visible").yesOrNo(),
            surfaceOf(place.member("surface")),
            trimLoopsOf(place.member("trim_loops")),
            sidesOf(place),
            place.has("locked") && place.member("locked").yesOrNo()};
}

// Little-endian numbers in base64; as bytes, because those are of no alignment.
template <class T>
std::vector<T> elementsOf(const Place& place)
{
    const auto bytes = bytesOfBase64(place.text());
    if (!bytes)
        place.refuse("is no base64");
    if (bytes->empty() || bytes->size() % sizeof(T) != 0)
        place.refuse("does not hold a whole number of them");
    std::vector<T> elements(bytes->size() / sizeof(T));
    std::memcpy(elements.data(), bytes->data(), bytes->size());
    return elements;
}

TriangleMesh meshOf(const Place& object)
{
    const Place vertices = object.member("vertices");
    const Place triangles = object.member("triangles");
    TriangleMesh mesh{elementsOf<Vec3>(vertices), elementsOf<Triangle>(triangles)};
    for (const Vec3& vertex : mesh.vertices)
        if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z))
            vertices.refuse("holds a number that is not finite");
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            if (vertex >= mesh.vertices.size())
                triangles.refuse("names a vertex that is not there");
    return mesh;
}

MeshObject meshObjectOf(const Place& place)
{
    MeshObject object = meshObject(place.member("name").text(), meshOf(place));
    object.colour = colourOf(place.member("colour"));
    object.transform = transformOf(place.member("transform"));
    object.visible = place.member("visible").yesOrNo();
    return object;
}

Scene sceneOf(const Place& file)
{
    if (!file.value().is_object() || !file.has("format") || file.value()["format"] != "knotspan")
        throw Error{"This is no Knotspan model: \"format\": \"knotspan\" is missing",
                    {},
                    "Choose a file that Knotspan has written"};
    if (const double version = file.member("version").number(); version != 1)
        throw Error{"The file is of version " + file.value()["version"].dump() +
                        ", but this Knotspan reads version 1",
                    {},
                    version > 1 ? "Use a newer Knotspan" : "Choose another file"};
    Scene scene;
    scene.setUnits(file.member("units").text());
    const Place objects = file.member("objects");
    for (size_t i = 0; i < objects.size(); ++i)
        scene.add(objectOf(objects.element(i)));
    if (file.has("meshes")) {  // files without any, and those from before there were any, have none
        const Place meshes = file.member("meshes");
        for (size_t i = 0; i < meshes.size(); ++i)
            scene.addMesh(meshObjectOf(meshes.element(i)));
    }
    return scene;
}

}  // namespace

Result<Scene> sceneFromJson(const json& value)
{
    try {
        return sceneOf(Place(value, {}));
    } catch (const Error& error) {
        return tl::unexpected(error);
    }
}

}  // namespace knotspan::formats
