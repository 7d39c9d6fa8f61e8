#include "ui/file_watch.h"

#include <QFileInfo>

namespace knotspan {

FileWatch::FileWatch(Document& document, std::chrono::milliseconds quiet, QObject* parent)
    : QObject(parent),
      document_(document)
{
    quiet_.setSingleShot(true);
    quiet_.setInterval(quiet);
    const auto wait = [this] { quiet_.start(); };
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, wait);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, wait);
    connect(&quiet_, &QTimer::timeout, this, &FileWatch::look);
    connect(&document_, &Document::fileChanged, this, &FileWatch::follow);
    follow();
}

FileWatch::Stamp FileWatch::stampOf(const QString& path)
{
    const QFileInfo info(path);
    return info.exists() ? Stamp{info.size(), info.lastModified()} : Stamp{};
}

void FileWatch::follow()
{
    if (std::exchange(revision_, document_.sourceRevision()) == document_.sourceRevision())
        return;
    const QString path = QString::fromStdString(document_.source().string());
    if (path != path_) {
        if (const QStringList watched = watcher_.files() + watcher_.directories(); !watched.isEmpty())
            watcher_.removePaths(watched);
        path_ = path;
        if (!path_.isEmpty())  // the folder, because most programs put a new file in the old one's place
            watcher_.addPaths({path_, QFileInfo(path_).absolutePath()});
    }
    own_ = stampOf(path_);
    known_ = own_;
}

bool FileWatch::isChanged() const
{
    const Stamp now = stampOf(path_);
    return !path_.isEmpty() && now.bytes >= 0 && now != own_;
}

void FileWatch::look()
{
    if (path_.isEmpty())
        return;
    const Stamp now = stampOf(path_);
    if (now.bytes >= 0 && !watcher_.files().contains(path_))
        watcher_.addPath(path_);
    if (now == known_)
        return;
    known_ = now;
    if (now.bytes > 0)  // gone, or about to be written
        Q_EMIT changed(path_);
}

}  // namespace knotspan
