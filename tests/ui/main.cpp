// The window's tests run without a display and keep their settings to themselves.
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>

#include "tests/support.h"

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
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QString::fromStdString(path));
    QApplication application(argc, argv);
    QApplication::setOrganizationName("Knotspan");
    QApplication::setApplicationName("Knotspan tests");
    return RUN_ALL_TESTS();
}
