// OBJ files written by hand in the tests.
#pragma once

#include <string>

#include "model/scene/scene.h"

namespace knotspan::testing {

// 3 x 2 control points (u fastest) at (i, j, i * j), numbered from 1, before a surface of degrees 2 and 1.
[[nodiscard]] std::string sixVertices();
// The surface over them, with `body` between its parameters and its end.
[[nodiscard]] std::string sixPointSurface(const std::string& body = {});
// A trimming curve: a polygon with corners at the places, closed where the last is the first.
[[nodiscard]] std::string polygon(const std::string& places);

// The scene that the text is; a test failure where it is none.
[[nodiscard]] Scene sceneOf(const std::string& text);
[[nodiscard]] NurbsSurface onlySurfaceOf(const std::string& text);
// Why the text is refused; empty where it is a scene.
[[nodiscard]] std::string refusal(const std::string& text);

}  // namespace knotspan::testing
