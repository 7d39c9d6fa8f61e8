// Two models as meshes of triangles, as fine as comparing them asks for.
#pragma once

#include "model/core/result.h"
#include "model/scene/scene.h"

namespace knotspan {

// What is visible of a model: its surfaces within `bound`, and its meshes.
struct ComparedModel {
    TriangleMesh mesh;
    double bound =
        0;  // no point of a surface is further from the mesh, none of its triangles further from it
    size_t uncut = 0;  // trimmed faces that count whole, because nobody can follow their loops
};

// In units of the first.
struct ComparedModels {
    ComparedModel a;
    ComparedModel b;

    // What the surfaces may be off the meshes, and rounding.
    [[nodiscard]] double bound() const;
    // How closely a distance between them is worth being known.
    [[nodiscard]] double tolerance() const;
    [[nodiscard]] std::vector<std::string> notes() const;  // sentences for the user

private:
    [[nodiscard]] Box box() const;
};

// Whose distances are asked for: the smaller they are the finer the meshes.
enum class ComparedWays { both, fromA };

// `scale`: so many units of `a` are one of `b`. Refuses a model with nothing in it.
[[nodiscard]] Result<ComparedModels> comparedModels(const Scene& a, const Scene& b, double scale = 1,
                                                    ComparedWays ways = ComparedWays::both);

}  // namespace knotspan
