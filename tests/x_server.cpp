#include "tests/x_server.h"

#include <csignal>

#include <sys/prctl.h>

#include <QStandardPaths>

namespace knotspan::testing {

QByteArray startXServer(QProcess& server, const QSize& screen)
{
    const QString program = QStandardPaths::findExecutable("Xvfb");
    if (program.isEmpty())
        return {};
    // It chooses a free display itself and prints its number.
    server.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });  // goes when the test crashes
    server.start(program, {"-displayfd", "1", "-screen", "0",
                           QString("%1x%2x24").arg(screen.width()).arg(screen.height()), "-nolisten", "tcp"});
    QByteArray number;
    while (!number.contains('\n')) {
        if (!server.waitForReadyRead(20'000))
            return {};
        number += server.readAllStandardOutput();
    }
    return ":" + number.trimmed();
}

}  // namespace knotspan::testing
