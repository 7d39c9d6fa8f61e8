// Models from other programs' files: saving does not write over what we may have understood in part.
#include <gtest/gtest.h>

#include "model/document/document.h"
#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "tests/support.h"

namespace knotspan {
namespace {

TEST(ForeignFiles, AreNotSavedOver)
{
    const testing::TemporaryFolder folder;
    for (const std::string name : {"a.step", "a.igs", "a.brep", "a.obj"}) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(formats::write(findSample("nine-16")->make(), folder / name));
        const std::string before = testing::readFile(folder / name);
        Document document;
        ASSERT_TRUE(document.open(folder / name));
        EXPECT_TRUE(document.isImported());
        EXPECT_TRUE(document.file().empty());
        EXPECT_EQ(document.title().toStdString(), name);
        const auto saved = document.save();
        ASSERT_FALSE(saved);
        EXPECT_EQ(saved.error().sentence(),
                  "This model has no file of its own yet. Choose a name with Save as.");
        EXPECT_EQ(testing::readFile(folder / name), before);
    }
}

TEST(ForeignFiles, ModelsGetAFileOfTheirOwnBySaveAs)
{
    const testing::TemporaryFolder folder;
    ASSERT_TRUE(formats::write(findSample("nine-16")->make(), folder / "a.step"));
    Document document;
    ASSERT_TRUE(document.open(folder / "a.step"));
    ASSERT_TRUE(document.saveAs(folder / "a.knotspan"));
    EXPECT_EQ(document.file(), folder / "a.knotspan");
    EXPECT_TRUE(document.save());
    Document again;
    ASSERT_TRUE(again.open(folder / "a.knotspan"));
    EXPECT_FALSE(again.isImported());
    EXPECT_EQ(again.file(), folder / "a.knotspan");
}

}  // namespace
}  // namespace knotspan
