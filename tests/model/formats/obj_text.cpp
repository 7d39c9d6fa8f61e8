#include "obj_text.h"

#include <sstream>

#include <gtest/gtest.h>

#include "model/formats/obj_format.h"

namespace knotspan::testing {

std::string sixVertices()
{
    std::ostringstream text;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i)
            text << "v " << i << ' ' << j << ' ' << i * j << '\n';
    return text.str();
}

std::string sixPointSurface(const std::string& body)
{
    return "cstype bspline\ndeg 2 1\nsurf 0 1 0 1 1 2 3 4 5 6\n"
           "parm u 0 0 0 1 1 1\nparm v 0 0 1 1\n" +
           body + "end\n";
}

std::string polygon(const std::string& places)
{
    std::istringstream in(places);
    std::ostringstream points;
    std::ostringstream knots;
    int count = 0;
    for (double u = 0, v = 0; in >> u >> v; ++count) {
        points << "vp " << u << ' ' << v << '\n';
        knots << ' ' << count;
    }
    points << "cstype bspline\ndeg 1\ncurv2";
    for (int k = -count; k < 0; ++k)
        points << ' ' << k;
    points << "\nparm u 0" << knots.str() << ' ' << count - 1 << "\nend\n";
    return points.str();
}

Scene sceneOf(const std::string& text)
{
    auto import = formats::sceneFromObj(text);
    if (!import) {
        ADD_FAILURE() << import.error().sentence();
        return {};
    }
    return std::move(import->scene);
}

NurbsSurface onlySurfaceOf(const std::string& text)
{
    const Scene scene = sceneOf(text);
    EXPECT_EQ(scene.objects().size(), 1u);
    return scene.objects().at(ObjectId{0})->surface;
}

std::string refusal(const std::string& text)
{
    const auto import = formats::sceneFromObj(text);
    return import ? "" : import.error().sentence();
}

}  // namespace knotspan::testing
