// An X server that draws into memory, so that windows have real surfaces where there is no display.
#pragma once

#include <QByteArray>
#include <QProcess>
#include <QSize>

namespace knotspan::testing {

// The name of the display; empty where there is no server. It goes with `server` and with this process.
[[nodiscard]] QByteArray startXServer(QProcess& server, const QSize& screen = {1024, 768});

}  // namespace knotspan::testing
