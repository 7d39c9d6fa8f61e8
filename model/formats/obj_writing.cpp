#include <algorithm>
#include <cmath>

#include "model/files/text_file.h"
#include "model/formats/obj_format.h"

namespace knotspan::formats {

namespace {

// Lines that end before they are long; a backslash continues them.
class Line {
public:
    Line(std::string& text, const char* keyword) : text_(text), start_(text.size()) { text_ += keyword; }
    ~Line() { text_ += '\n'; }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    Line& add(double number)
    {
        space();
        append(text_, number);
        return *this;
    }
    Line& add(size_t index)
    {
        space();
        text_ += std::to_string(index);
        return *this;
    }

private:
    void space()
    {
        constexpr size_t kLongest = 100;
        if (text_.size() - start_ > kLongest) {
            text_ += " \\\n";
            start_ = text_.size();
        }
        text_ += ' ';
    }

    std::string& text_;
    size_t start_;
};

// Weights that are all one are what they are without `rat`.
template <class Points>
bool needsWeights(const Points& points)
{
    return std::any_of(points.begin(), points.end(), [](const auto& point) { return point.weight != 1.0; });
}

// One object after the other as text; points and curves are counted through the whole file.
class ObjWriter {
public:
    [[nodiscard]] Result<std::string> textOf(const SceneObject& object, size_t number)
    {
        text_.clear();
        writeName(object.name.empty() ? "Surface " + std::to_string(number) : object.name);
        std::vector<size_t> curves;
        for (const TrimLoop& loop : object.trimLoops)
            for (const TrimCurve& curve : loop.curves)
                curves.push_back(writeCurve(curve));
        if (!writeVertices(object))
            return failure("The control points of \"" + object.name + "\" are too far away to be written",
                           "Move it nearer or make it smaller");
        writeSurface(object.surface);
        writeLoops(object.trimLoops, curves);
        text_ += "end\n";
        return text_;
    }

private:
    void writeName(std::string name)
    {
        std::replace_if(
            name.begin(), name.end(), [](char c) { return (c >= '\0' && c < ' ') || c == '\x7f'; }, ' ');
        // A backslash at its end would join the lines.
        text_ += "o " + name + (name.back() == '\\' ? " \n" : "\n");
    }

    void writeBasis(bool rational) { text_ += rational ? "cstype rat bspline\n" : "cstype bspline\n"; }

    void writeKnots(const char* keyword, const KnotVector& knots)
    {
        Line line(text_, keyword);
        for (const double knot : knots.values())
            line.add(knot);
    }

    // The curve's number.
    size_t writeCurve(const TrimCurve& curve)
    {
        const bool rational = needsWeights(curve.points());
        for (const TrimPoint& point : curve.points()) {
            Line line(text_, "vp");
            line.add(point.position.x).add(point.position.y);
            if (rational)
                line.add(point.weight);
        }
        writeBasis(rational);
        Line(text_, "deg").add(static_cast<size_t>(curve.knots().degree()));
        {
            Line line(text_, "curv2");
            for (size_t k = 0; k < curve.points().size(); ++k)
                line.add(++parameterPoints_);
        }
        writeKnots("parm u", curve.knots());
        text_ += "end\n";
        return ++curves_;
    }

    // Row by row, u fastest. False where a coordinate is not finite in model space.
    [[nodiscard]] bool writeVertices(const SceneObject& object)
    {
        const NurbsSurface& surface = object.surface;
        const bool rational = needsWeights(surface.controlPoints());
        const bool inPlace = object.transform == Mat4(1.0);  // to the bit
        bool finite = true;
        for (int j = 0; j < surface.countV(); ++j) {
            for (int i = 0; i < surface.countU(); ++i) {
                const ControlPoint& point = surface.controlPoint(i, j);
                const Vec3 at = inPlace ? point.position : transformed(point.position, object.transform);
                finite = finite && std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z);
                Line line(text_, "v");
                line.add(at.x).add(at.y).add(at.z);
                if (rational)
                    line.add(point.weight);
            }
        }
        return finite;
    }

    void writeSurface(const NurbsSurface& surface)
    {
        const KnotVector& u = surface.knotsU();
        const KnotVector& v = surface.knotsV();
        writeBasis(needsWeights(surface.controlPoints()));
        Line(text_, "deg").add(static_cast<size_t>(u.degree())).add(static_cast<size_t>(v.degree()));
        {
            Line line(text_, "surf");
            line.add(u.domainStart()).add(u.domainEnd()).add(v.domainStart()).add(v.domainEnd());
            for (size_t k = 0; k < surface.controlPoints().size(); ++k)
                line.add(++vertices_);
        }
        writeKnots("parm u", u);
        writeKnots("parm v", v);
    }

    void writeLoops(const std::vector<TrimLoop>& loops, const std::vector<size_t>& curves)
    {
        size_t next = 0;
        for (const TrimLoop& loop : loops) {
            if (loop.curves.empty())
                continue;
            Line line(text_, loop.outer ? "trim" : "hole");
            for (const TrimCurve& curve : loop.curves)
                line.add(curve.knots().domainStart()).add(curve.knots().domainEnd()).add(curves[next++]);
        }
    }

    std::string text_;
    size_t vertices_ = 0;
    size_t parameterPoints_ = 0;
    size_t curves_ = 0;
};

}  // namespace

Result<void> writeObj(const Scene& scene, std::ostream& out)
{
    out << "# Free-form surfaces, written by Knotspan." << kObjUnits << nameIn(scene.units()) << ".\n";
    ObjWriter writer;
    size_t number = 0;
    for (const auto& [id, object] : scene.objects()) {
        const auto text = writer.textOf(*object, ++number);
        if (!text)
            return tl::unexpected(text.error());
        out << *text;
    }
    return {};
}

}  // namespace knotspan::formats
