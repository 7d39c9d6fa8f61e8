#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>

#include "model/files/text_file.h"
#include "model/files/text_statements.h"
#include "model/formats/obj_elements.h"
#include "model/formats/obj_format.h"
#include "model/formats/obj_notes.h"
#include "model/mesh_files/mesh_building.h"

namespace knotspan::formats {

namespace {

// So that no file exhausts memory: points of each kind, and uses of them, are counted; a surface takes about
// a kilobyte.
constexpr size_t kMostPoints = 10'000'000;
constexpr size_t kFewPoints = 1'000'000;
constexpr size_t kMostSurfaces = 1'000'000;

// Reads statement by statement; throws Error, which sceneFromObj() catches.
class ObjReader {
public:
    explicit ObjReader(std::string_view text) : statements_(text) {}

    [[nodiscard]] Result<Import> read() &&
    {
        for (auto keyword = statements_.next(); !keyword.empty(); keyword = statements_.next())
            obey(keyword);
        if (element_)
            TextStatements::refuseAt(element_->line, "What begins here has no end statement");
        addMesh();
        if (import_.scene.objects().empty() && import_.scene.meshes().empty())
            return notes_.refusal();
        import_.notes = notes_.sentences();
        return std::move(import_);
    }

private:
    enum class ElementKind { surface, trimCurve, spaceCurve };
    using Handler = void (ObjReader::*)();

    void obey(std::string_view keyword)
    {
        static const std::map<std::string_view, Handler> handlers{
            {"v", &ObjReader::vertex},         {"vp", &ObjReader::parameterPoint},
            {"cstype", &ObjReader::basisKind}, {"deg", &ObjReader::degree},
            {"surf", &ObjReader::surface},     {"curv2", &ObjReader::trimCurve},
            {"curv", &ObjReader::spaceCurve},  {"parm", &ObjReader::parameters},
            {"trim", &ObjReader::outerLoop},   {"hole", &ObjReader::hole},
            {"end", &ObjReader::end},          {"o", &ObjReader::name},
            {"g", &ObjReader::groupName},      {"f", &ObjReader::polygon},
            {"fo", &ObjReader::polygon},
        };
        if (const auto handler = handlers.find(keyword); handler != handlers.end())
            (this->*handler->second)();
        else if (!notes_.skip(keyword))
            statements_.refuse(quoted(keyword) + " is no statement of OBJ files");
    }

    void use(size_t& count, size_t more, const char* what)
    {
        count += more;
        if (count > kMostPoints)
            throw Error{"The file has more than " + std::to_string(kMostPoints) + " " + what,
                        "line " + std::to_string(statements_.line()), "Split the model into several files"};
    }

    // Models use a curve once or twice; a small file that uses a long one again and again would take minutes.
    void useAgain(size_t points)
    {
        constexpr size_t kOften = 4;
        trimUses_ += points;
        if (trimUses_ > kFewPoints + kOften * parameterPointCount_)
            throw Error{"The file uses its trimming curves too often",
                        "line " + std::to_string(statements_.line()), "Split the model into several files"};
    }

    // Behind a vertex there may be its weight, its colour, or both.
    void vertex()
    {
        const double x = statements_.number("The coordinate x");
        const double y = statements_.number("The coordinate y");
        const double z = statements_.number("The coordinate z");
        std::array<double, 4> more{};
        size_t count = 0;
        for (auto word = statements_.word(); !word.empty(); word = statements_.word()) {
            if (count == more.size())
                statements_.refuse("A vertex has more numbers than coordinates, weight and colour");
            more[count++] = statements_.numberOf(word, "The weight or colour");
        }
        if (count == 2)
            statements_.refuse("A vertex has five numbers");
        use(vertexCount_, 1, "vertices");
        vertices_.push_back({{x, y, z}, count == 1 || count == 4 ? more[0] : 1.0});
    }

    void parameterPoint()
    {
        TrimPoint point{{statements_.number("The parameter u"), 0}, 1};
        if (const auto v = statements_.word(); !v.empty())
            point.position.y = statements_.numberOf(v, "The parameter v");
        if (const auto weight = statements_.word(); !weight.empty())
            point.weight = statements_.numberOf(weight, "The weight");
        use(parameterPointCount_, 1, "parameter points");
        parameterPoints_.push_back(point);
    }

    void basisKind()
    {
        std::string_view kind = statements_.needed("The kind of curve");
        basis_.rational = kind == "rat";
        if (basis_.rational)
            kind = statements_.needed("The kind of curve");
        if (kind != "bspline" && kind != "bezier")
            throw Error{"Curves and surfaces of the kind " + quoted(kind) +
                            " are not read, only bspline and bezier",
                        "line " + std::to_string(statements_.line()), "Export them as B-splines"};
        basis_.bezier = kind == "bezier";
        hasKind_ = true;
    }

    int degreeIn(std::string_view word) const
    {
        const auto value = integerIn(word);
        if (!value)
            statements_.refuse("The degree is no whole number, but " + quoted(word));
        return static_cast<int>(std::clamp<std::int64_t>(*value, 0, kMaxDegree + 1));
    }

    void degree()
    {
        basis_.degreeU = degreeIn(statements_.needed("The degree"));
        const auto v = statements_.word();
        basis_.degreeV = v.empty() ? 0 : degreeIn(v);
    }

    void begin(ElementKind kind)
    {
        if (element_)
            TextStatements::refuseAt(element_->line, "What begins here has no end statement");
        if (!hasKind_)
            statements_.refuse("The kind of curve (cstype) is not stated before");
        kind_ = kind;
        element_.emplace();
        element_->line = statements_.line();
        element_->basis = basis_;
    }

    // The rest of the statement; textures and normals behind a slash do not matter.
    void points(size_t existing)
    {
        for (auto word = statements_.word(); !word.empty(); word = statements_.word()) {
            const auto index = integerIn(word.substr(0, word.find('/')));
            if (!index)
                statements_.refuse("The number of a control point is none, but " + quoted(word));
            use(pointUses_, 1, "control points");
            element_->points.push_back(
                static_cast<std::uint32_t>(counted(*index, existing, "control point")));
        }
    }

    // From 0 on; below zero it counts from the last one backwards.
    [[nodiscard]] size_t counted(std::int64_t index, size_t existing, const char* what) const
    {
        const auto count = static_cast<std::int64_t>(existing);
        if (index == 0 || index > count || index < -count)
            statements_.refuse("There is no " + std::string(what) + " " + std::to_string(index) +
                               ": up to here there are " + std::to_string(existing));
        return static_cast<size_t>(index > 0 ? index - 1 : count + index);
    }

    // With any textures and normals behind slashes.
    void polygon()
    {
        if (polygons_.size() == kMostMeshTriangles)
            throw Error{"The file has more than " + std::to_string(kMostMeshTriangles) + " polygons",
                        "line " + std::to_string(statements_.line()), "Split the mesh into several files"};
        if (polygons_.empty())
            meshName_ = name_;
        for (auto word = statements_.word(); !word.empty(); word = statements_.word()) {
            const auto index = integerIn(word.substr(0, word.find('/')));
            if (!index)
                statements_.refuse("The number of a vertex is none, but " + quoted(word));
            corners_.push_back(static_cast<std::uint32_t>(counted(*index, vertices_.size(), "vertex")));
        }
        const size_t start = polygons_.empty() ? 0 : polygons_.back();
        if (corners_.size() - start < 3)
            statements_.refuse("A polygon has fewer than three corners");
        polygons_.push_back(corners_.size());
    }

    // Of all polygons, whatever groups they are in: parts of one body stay together.
    void addMesh()
    {
        if (polygons_.empty())
            return;
        MeshBuilding building;
        for (const ControlPoint& vertex : vertices_)
            building.vertex(vertex.position);
        const std::span<const std::uint32_t> corners(corners_);
        size_t start = 0;
        for (const size_t end : polygons_) {
            building.polygon(corners.subspan(start, end - start));
            start = end;
        }
        if (!building.isEmpty())
            import_.scene.addMesh(meshObject(meshName_.empty() ? "Mesh" : meshName_, building.take()));
    }

    void surface()
    {
        begin(ElementKind::surface);
        element_->startU = statements_.number("The start of u");
        element_->endU = statements_.number("The end of u");
        element_->startV = statements_.number("The start of v");
        element_->endV = statements_.number("The end of v");
        points(vertices_.size());
    }

    void trimCurve()
    {
        begin(ElementKind::trimCurve);
        points(parameterPoints_.size());
    }

    void spaceCurve()
    {
        begin(ElementKind::spaceCurve);
        notes_.skip("curv");
    }

    [[nodiscard]] ObjElement& body()
    {
        if (!element_)
            statements_.refuse("This statement belongs between surf or curv2 and end");
        return *element_;
    }

    void parameters()
    {
        ObjElement& element = body();
        const auto direction = statements_.needed("The direction u or v");
        if (direction != "u" && direction != "v")
            statements_.refuse("The direction is neither u nor v, but " + quoted(direction));
        auto& values = direction == "u" ? element.parametersU : element.parametersV;
        if (!values.empty())
            statements_.refuse("The parameters along " + std::string(direction) + " stand twice");
        for (auto word = statements_.word(); !word.empty(); word = statements_.word()) {
            use(parameterCount_, 1, "parameters");
            values.push_back(statements_.numberOf(word, "The parameter"));
        }
    }

    void outerLoop() { loop(true); }
    void hole() { loop(false); }
    void loop(bool outer)
    {
        ObjElement& element = body();
        ObjLoop loop{outer, {}};
        for (auto word = statements_.word(); !word.empty(); word = statements_.word()) {
            ObjTrim trim;
            trim.start = statements_.numberOf(word, "The start of the trimming curve");
            trim.end = statements_.number("The end of the trimming curve");
            const auto number = statements_.needed("The number of the trimming curve");
            const auto index = integerIn(number);
            if (!index)
                statements_.refuse("The number of the trimming curve is none, but " + quoted(number));
            trim.curve = counted(*index, curves_.size(), "trimming curve");
            const Result<TrimCurve>& curve = curves_[trim.curve];
            useAgain(curve ? curve->points().size() : 1);
            loop.trims.push_back(trim);
        }
        if (loop.trims.empty())
            statements_.refuse("The loop has no trimming curves");
        element.loops.push_back(std::move(loop));
    }

    void end()
    {
        (void)body();
        if (kind_ == ElementKind::surface)
            addSurface();
        if (kind_ == ElementKind::trimCurve)
            curves_.push_back(trimCurveOf(*element_, parameterPoints_));
        element_.reset();
    }

    void addSurface()
    {
        notes_.countSurface();
        auto made = surfaceOf(*element_, vertices_);
        if (!made)
            return notes_.leaveOut(element_->line, made.error().what);
        auto loops = trimLoopsOf(element_->loops, curves_, *made);
        if (!loops)
            notes_.leaveUntrimmed(element_->line, loops.error().what);
        if (import_.scene.objects().size() == kMostSurfaces)
            throw Error{"The file has more than " + std::to_string(kMostSurfaces) + " surfaces",
                        "line " + std::to_string(element_->line), "Split the model into several files"};
        std::string name = name_.empty() ? "Surface " + std::to_string(notes_.surfaces()) : name_;
        import_.scene.add({std::move(name), Colour{}, Mat4(1.0), true, *std::move(made),
                           loops ? *std::move(loops) : std::vector<TrimLoop>{}});
    }

    void name() { name_ = nameIn(statements_.rest()); }
    void groupName()
    {
        const auto text = statements_.rest();
        if (!text.empty() && text != "default")
            name_ = nameIn(text);
    }

    TextStatements statements_;
    Import import_;
    ObjNotes notes_;
    ObjBasis basis_;
    bool hasKind_ = false;
    std::string name_;
    std::vector<ControlPoint> vertices_;
    std::vector<std::uint32_t> corners_;  // of all polygons
    std::vector<size_t> polygons_;        // the ends of their corners
    std::string meshName_;
    std::vector<TrimPoint> parameterPoints_;
    std::vector<Result<TrimCurve>> curves_;
    size_t vertexCount_ = 0;
    size_t parameterPointCount_ = 0;
    size_t parameterCount_ = 0;
    size_t pointUses_ = 0;
    size_t trimUses_ = 0;
    ElementKind kind_ = ElementKind::surface;
    std::optional<ObjElement> element_;
};

}  // namespace

Result<Import> sceneFromObj(std::string_view text)
{
    try {
        return ObjReader(text).read();
    } catch (const Error& error) {
        return tl::unexpected(error);
    }
}

}  // namespace knotspan::formats
