// Runs the tour on an X server of its own.
//
// KNOTSPAN_TOUR_PICTURES: the folder to keep the pictures in; KNOTSPAN_TOUR_DARK: in dark windows; Qt's own
// QT_SCALE_FACTOR: as on a screen of smaller pixels.
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>

#include "tests/support.h"
#include "tests/x_server.h"
#include "ui/appearance.h"

int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    const knotspan::testing::TemporaryFolder folder;
    const std::string path = folder.path().string();
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);  // as Qt wants its own
    QProcess server;
    const QByteArray display = knotspan::testing::startXServer(server, {2000, 1300});
    if (display.isEmpty()) {
        std::puts("skipped: no Xvfb here; install xvfb to walk through the window on a display");
        return EXIT_SUCCESS;
    }
    qputenv("DISPLAY", display);
    qputenv("QT_QPA_PLATFORM", "xcb");
    for (const char* name : {"XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
        qputenv(name, path.c_str());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QString::fromStdString(path));
    int result = EXIT_FAILURE;
    {
        QApplication application(argc, argv);
        QApplication::setOrganizationName("Knotspan");
        QApplication::setApplicationName("Knotspan tests");
        knotspan::setAppearance(qEnvironmentVariableIsSet("KNOTSPAN_TOUR_DARK")
                                    ? knotspan::Appearance::dark
                                    : knotspan::Appearance::light);
        result = RUN_ALL_TESTS();
    }
    server.kill();
    server.waitForFinished();
    return result;
}
