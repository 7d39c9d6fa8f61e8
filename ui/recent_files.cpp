#include "ui/recent_files.h"

#include <QSettings>

namespace knotspan::recentFiles {

namespace {

constexpr auto kKey = "recentFiles";
constexpr int kMost = 10;

}  // namespace

QStringList all()
{
    return QSettings().value(kKey).toStringList();
}

void remember(const std::filesystem::path& path)
{
    const QString name = QString::fromStdString(std::filesystem::absolute(path).string());
    QStringList files = all();
    files.removeAll(name);
    files.prepend(name);
    QSettings().setValue(kKey, files.mid(0, kMost));
}

void forget(const QString& path)
{
    QStringList files = all();
    files.removeAll(path);
    QSettings().setValue(kKey, files);
}

void clear()
{
    QSettings().remove(kKey);
}

}  // namespace knotspan::recentFiles
