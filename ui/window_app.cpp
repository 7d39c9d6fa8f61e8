#include "ui/window_app.h"

#include <cstdlib>
#include <iostream>

#include <QApplication>
#include <QDir>
#include <QIcon>
#include <QTemporaryDir>

#include "ui/appearance.h"
#include "ui/document_files.h"
#include "ui/main_window.h"
#include "ui/recovery.h"

namespace knotspan {

namespace {

// Qt ends the whole program where it finds no display; we say it ourselves.
bool hasDisplay()
{
    for (const char* name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"})
        if (!qEnvironmentVariableIsEmpty(name))
            return true;
    return false;
}

// Qt complains about a session without one, a container's say: it gets one for as long as the window runs.
class RuntimeFolder {
public:
    RuntimeFolder()
    {
        if (!qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR") || !folder_.isValid())
            return;
        qputenv("XDG_RUNTIME_DIR", folder_.path().toLocal8Bit());
    }

private:
    QTemporaryDir folder_{QDir::tempPath() + "/knotspan-XXXXXX"};
};

QIcon icon()
{
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128})
        icon.addFile(QString(":/icons/knotspan-%1.png").arg(size));
    return icon;
}

}  // namespace

int runWindow(int& argc, char** argv, const std::vector<std::filesystem::path>& files)
{
    if (!hasDisplay()) {
        std::cerr
            << "knotspan: There is no display to open a window on. Use `knotspan render FILE -o OUT.png` "
               "to make a picture without one.\n";
        return EXIT_FAILURE;
    }
    const RuntimeFolder runtimeFolder;
    QApplication application(argc, argv);
    QApplication::setApplicationName("Knotspan");
    QApplication::setOrganizationName("Knotspan");
    QGuiApplication::setDesktopFileName("knotspan");
    QApplication::setWindowIcon(icon());

    restoreAppearance();
    MainWindow window;
    window.keepForRecovery(recoveryFolder(), autosaveInterval());
    if (files.empty())
        window.showStartPage();
    else
        window.files().open(files);
    window.show();
    return QApplication::exec();
}

}  // namespace knotspan
