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

}  // namespace
}  // namespace knotspan
