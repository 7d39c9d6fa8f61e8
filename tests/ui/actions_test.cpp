#include "ui/actions.h"

#include <set>

#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "ui/keys_dialog.h"
#include "ui/questions.h"

namespace knotspan {
namespace {

TEST(Actions, NoTwoHaveTheSameKey)
{
    std::set<QString> seen;
    for (const ActionInfo& action : actionList())
        for (const QKeySequence& key : action.shortcuts)
            EXPECT_TRUE(seen.insert(key.toString()).second) << key.toString().toStdString();
}

TEST(Actions, EachHasATipAndANameOfItsOwn)
{
    std::set<std::string> ids;
    for (const ActionInfo& action : actionList()) {
        EXPECT_TRUE(ids.insert(action.id).second) << action.id;
        EXPECT_FALSE(std::string(action.tip).empty()) << action.id;
        EXPECT_NE(std::string(action.tip).back(), '.') << action.id;
    }
}

TEST(KeysDialog, ListsEveryKeyAndTheMouse)
{
    const QString content = KeysDialog::content();
    for (const ActionInfo& action : actionList()) {
        if (action.shortcuts.empty())
            continue;
        EXPECT_TRUE(content.contains(QString(action.tip).toHtmlEscaped())) << action.id;
        for (const QKeySequence& key : action.shortcuts)
            EXPECT_TRUE(content.contains(key.toString(QKeySequence::NativeText))) << action.id;
    }
    for (const MouseInfo& mouse : mouseList())
        EXPECT_TRUE(content.contains(QString(mouse.gesture).toHtmlEscaped())) << mouse.gesture;
}

TEST(Questions, OffersEveryFormat)
{
    const QString reading = readFilters().join('\n');
    const QString writing = writeFilters().join('\n');
    for (const formats::Format& format : formats::all())
        for (const std::string& extension : format.extensions) {
            const QString pattern = "*." + QString::fromStdString(extension);
            EXPECT_EQ(reading.contains(pattern), format.read != nullptr) << extension;
            EXPECT_EQ(writing.contains(pattern), format.write != nullptr) << extension;
        }
}

}  // namespace
}  // namespace knotspan
