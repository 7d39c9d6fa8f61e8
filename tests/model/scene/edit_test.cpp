#include "model/scene/edit.h"

#include <gtest/gtest.h>

#include "tests/model/scene/simple_object.h"

namespace knotspan {
namespace {

using testing::sharedObject;
using testing::simpleObject;

TEST(Edit, AppliedTwiceRestoresTheScene)
{
    Scene scene;
    const ObjectId changed = scene.add(simpleObject("changed"));
    const ObjectId removed = scene.add(simpleObject("removed"));
    const Scene before = scene;
    const SharedObject original = scene.find(changed);

    Edit edit;
    EXPECT_TRUE(edit.isEmpty());
    edit.set(changed, sharedObject("new"));
    edit.set(removed, nullptr);
    edit.set(ObjectId{7}, sharedObject("added"));
    EXPECT_FALSE(edit.isEmpty());

    edit.applyTo(scene);
    const Scene after = scene;
    EXPECT_EQ(scene.find(changed)->name, "new");
    EXPECT_EQ(scene.find(removed), nullptr);
    EXPECT_EQ(scene.find(ObjectId{7})->name, "added");

    edit.applyTo(scene);
    EXPECT_TRUE(scene == before);
    EXPECT_EQ(scene.find(changed), original) << "the very same object, so that nothing is uploaded twice";

    edit.applyTo(scene);
    EXPECT_TRUE(scene == after);
}

TEST(Edit, KeepsTheLastWordForAnId)
{
    Scene scene;
    Edit edit;
    edit.set(ObjectId{0}, sharedObject("first"));
    edit.set(ObjectId{0}, sharedObject("second"));
    edit.applyTo(scene);
    EXPECT_EQ(scene.find(ObjectId{0})->name, "second");
}

TEST(Edit, ThatAbsorbedALaterOneUndoesAndRedoesBoth)
{
    Scene scene;
    const ObjectId a = scene.add(simpleObject("a0"));
    const ObjectId b = scene.add(simpleObject("b0"));
    const Scene before = scene;

    Edit first;
    first.set(a, sharedObject("a1"));
    first.applyTo(scene);
    Edit second;
    second.set(a, sharedObject("a2"));
    second.set(b, sharedObject("b2"));
    second.applyTo(scene);
    const Scene after = scene;

    first.absorb(second);
    first.applyTo(scene);
    EXPECT_TRUE(scene == before);
    first.applyTo(scene);
    EXPECT_TRUE(scene == after);
}

}  // namespace
}  // namespace knotspan
