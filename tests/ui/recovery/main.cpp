// The program that is killed is this one, too: with arguments it is a window in which somebody works.
#include <cstring>

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>

#include "tests/support.h"
#include "tests/ui/recovery/edited_window.h"

int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    const knotspan::testing::TemporaryFolder folder;
    const std::string path = folder.path().string();
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);  // as Qt wants its own
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("XDG_RUNTIME_DIR", path.c_str());
    qputenv("XDG_CONFIG_HOME", path.c_str());
    qputenv("XDG_CACHE_HOME", path.c_str());
    for (const char* name : {"VK_ICD_FILENAMES", "VK_DRIVER_FILES"})
        qputenv(name, "/nowhere/none.json");  // nobody looks at the pictures
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QString::fromStdString(path));
    QApplication application(argc, argv);
    QApplication::setOrganizationName("Knotspan");
    QApplication::setApplicationName("Knotspan tests");
    if (argc == 5 && std::strcmp(argv[1], "edit") == 0)
        return knotspan::testing::editForEver(argv[2], argv[3], std::atoi(argv[4]));
    return RUN_ALL_TESTS();
}
