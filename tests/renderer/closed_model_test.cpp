#include "renderer/measurement/closed_model.h"

#include <gtest/gtest.h>

#include "model/samples/sample_list.h"

namespace knotspan {
namespace {

bool isClosedSample(const std::string& name)
{
    return isClosedModel(findSample(name)->make());
}

TEST(ClosedModel, HasNoOpenBorderByPolesSeamsAndNeighbours)
{
    for (const char* name : {"sphere", "torus", "knot"})
        EXPECT_TRUE(isClosedSample(name)) << name;
    for (const char* name : {"single-100", "nine-16", "hull"})
        EXPECT_FALSE(isClosedSample(name)) << name;
    EXPECT_FALSE(isClosedModel(Scene()));
}

TEST(ClosedModel, LosesThatWithOneOfItsSurfaces)
{
    Scene scene = findSample("knot")->make();
    const ObjectId first = scene.objects().begin()->first;
    SceneObject hidden = *scene.find(first);
    hidden.visible = false;
    scene.exchange(first, std::make_shared<const SceneObject>(hidden));
    EXPECT_FALSE(isClosedModel(scene));
}

TEST(ClosedModel, IsNoneWithATrimmedSurface)
{
    Scene scene = findSample("sphere")->make();
    const ObjectId id = scene.objects().begin()->first;
    SceneObject trimmed = *scene.find(id);
    std::vector<TrimPoint> points;
    for (const Vec2 at : {Vec2(1, 1), Vec2(1, 2), Vec2(2, 2), Vec2(1, 1)})
        points.push_back({at, 1});
    trimmed.trimLoops = {{false, {TrimCurve::create(KnotVector::clampedUniform(1, 3), points).value()}}};
    scene.exchange(id, std::make_shared<const SceneObject>(trimmed));
    EXPECT_FALSE(isClosedModel(scene));
}

}  // namespace
}  // namespace knotspan
