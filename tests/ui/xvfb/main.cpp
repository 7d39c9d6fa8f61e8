// Starts an X server that draws into memory, so that the window has real surfaces, and runs the tests in it.
#include <gtest/gtest.h>

#include <QApplication>
#include <QProcess>
#include <QSettings>

#include "tests/support.h"
#include "tests/x_server.h"

int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    const knotspan::testing::TemporaryFolder folder;
    const std::string path = folder.path().string();
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);  // as Qt wants its own
    QProcess server;
    const QByteArray display = knotspan::testing::startXServer(server);
    if (display.isEmpty()) {
        std::puts("skipped: no Xvfb here; install xvfb to test the window on a display");
        return EXIT_SUCCESS;
    }
    qputenv("DISPLAY", display);
    qputenv("QT_QPA_PLATFORM", "xcb");
    qputenv("XDG_RUNTIME_DIR", path.c_str());
    qputenv("XDG_CONFIG_HOME", path.c_str());
    qputenv("XDG_CACHE_HOME", path.c_str());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QString::fromStdString(path));
    int result = EXIT_FAILURE;
    {
        QApplication application(argc, argv);
        QApplication::setOrganizationName("Knotspan");
        QApplication::setApplicationName("Knotspan tests");
        result = RUN_ALL_TESTS();
    }
    server.kill();
    server.waitForFinished();
    return result;
}
