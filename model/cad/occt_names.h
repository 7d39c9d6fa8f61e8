// What the faces of a file are called: by their own names where they have one, else by the part they belong
// to.
//
// A face without a name is "PART: Face 3", or "PART" where the part has no other. In an assembly a part is
// called as its product; where there is but one product, by its bodies' names, if they have any, since the
// product is the whole file. Parts that stand there several times are "Bolt 1", "Bolt 2", and faces' own
// names then follow those: "Bolt 2: Head".
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

namespace knotspan::formats {

// What the file calls a shape itself; empty: nothing.
struct ShapeName {
    std::string product;
    std::string item;  // a solid's, shell's, group's or face's
};

struct NamedFace {
    TopoDS_Face face;
    std::string name;  // empty where nobody has one
};

// All faces, in order.
[[nodiscard]] std::vector<NamedFace> namedFaces(const TopoDS_Shape& shape,
                                                const std::function<ShapeName(const TopoDS_Shape&)>& nameOf);

}  // namespace knotspan::formats
