#include "model/cad/occt_names.h"

#include <map>
#include <set>

#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace knotspan::formats {
namespace {

// A product or a body at one place of the model; bodies are numbered apart from products.
struct Part {
    std::string name;
    int number = 0;  // 0: none
};

struct FoundFace {
    TopoDS_Face face;
    std::string ownName;
    Part product;
    Part body;
};

class Walk {
public:
    explicit Walk(const std::function<ShapeName(const TopoDS_Shape&)>& nameOf) : nameOf_(nameOf) {}

    void visit(const TopoDS_Shape& shape, Part product, Part body)
    {
        const ShapeName name = nameOf_(shape);
        if (!name.product.empty())
            product = {name.product, ++products_};
        if (shape.ShapeType() == TopAbs_FACE) {
            found_.push_back({TopoDS::Face(shape), name.item, std::move(product), std::move(body)});
            return;
        }
        if (!name.item.empty())
            body = {name.item, ++bodies_};
        for (TopoDS_Iterator it(shape); it.More(); it.Next())
            if (it.Value().ShapeType() <= TopAbs_FACE)
                visit(it.Value(), product, body);
    }

    [[nodiscard]] std::vector<FoundFace>& found() { return found_; }

private:
    const std::function<ShapeName(const TopoDS_Shape&)>& nameOf_;
    std::vector<FoundFace> found_;
    int products_ = 0;
    int bodies_ = 0;
};

bool isAssembly(const std::vector<FoundFace>& faces)
{
    std::set<int> products;
    for (const FoundFace& face : faces)
        products.insert(face.product.number);
    return products.size() > 1;
}

// The faces of each part, and where parts that are called the same stand.
struct Parts {
    std::map<std::pair<std::string, int>, int> faces;
    std::map<std::string, std::map<int, size_t>> places;  // a part's number -> which of its name it is

    void count(const Part& part)
    {
        ++faces[{part.name, part.number}];
        auto& named = places[part.name];
        named.emplace(part.number, named.size() + 1);
    }

    [[nodiscard]] bool isOneOfSeveral(const Part& part) const { return places.at(part.name).size() > 1; }

    [[nodiscard]] std::string title(const Part& part) const
    {
        return isOneOfSeveral(part) ? part.name + ' ' + std::to_string(places.at(part.name).at(part.number))
                                    : part.name;
    }
};

}  // namespace

std::vector<NamedFace> namedFaces(const TopoDS_Shape& shape,
                                  const std::function<ShapeName(const TopoDS_Shape&)>& nameOf)
{
    Walk walk(nameOf);
    walk.visit(shape, {}, {});
    const bool assembly = isAssembly(walk.found());
    const auto partOf = [&](const FoundFace& face) -> const Part& {
        const bool byProduct = face.body.name.empty() || (assembly && !face.product.name.empty());
        return byProduct ? face.product : face.body;
    };
    Parts parts;
    for (const FoundFace& face : walk.found())
        parts.count(partOf(face));
    std::map<std::pair<std::string, int>, int> passed;
    std::vector<NamedFace> named;
    for (FoundFace& face : walk.found()) {
        const Part& part = partOf(face);
        const auto key = std::make_pair(part.name, part.number);
        const int number = ++passed[key];
        std::string name = face.ownName;
        if (!part.name.empty() && name.empty())
            name = parts.faces[key] == 1 ? parts.title(part)
                                         : parts.title(part) + ": Face " + std::to_string(number);
        else if (assembly && !part.name.empty() && parts.isOneOfSeveral(part))
            name = parts.title(part) + ": " + name;
        named.push_back({std::move(face.face), std::move(name)});
    }
    return named;
}

}  // namespace knotspan::formats
