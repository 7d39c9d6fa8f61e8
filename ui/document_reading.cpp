// The half of DocumentFiles that reads: one file after the other, at once or beside the window.

#include <QGuiApplication>

#include "model/formats/format_list.h"
#include "ui/document_files.h"
#include "ui/message_bar.h"
#include "ui/reading_line.h"
#include "ui/reading_thread.h"
#include "ui/recent_files.h"

namespace knotspan {
namespace fs = std::filesystem;

namespace {

QString nameOf(const fs::path& path)
{
    return QString::fromStdString(path.filename().string());
}

}  // namespace

bool DocumentFiles::isRefusedWhileReading()
{
    if (!isReading())
        return false;
    messages_.say(tr("%1 is still being read. Wait until it is there, or cancel it, and try again.")
                      .arg(nameOf(thread_->path())));
    return true;
}

void DocumentFiles::start(Job job)
{
    job_ = std::move(job);
    goOn();
}

void DocumentFiles::goOn()
{
    while (job_ && job_->next < job_->files.size()) {
        const fs::path path = job_->files[job_->next++];
        if (formats::isReadApart(path))
            return readApart(path);
        QGuiApplication::setOverrideCursor(Qt::WaitCursor);
        auto import = formats::readWithNotes(path);
        QGuiApplication::restoreOverrideCursor();
        take(path, std::move(import));
    }
    if (job_)
        finish();
}

void DocumentFiles::readApart(const fs::path& path)
{
    thread_ = std::make_unique<ReadingThread>(path);
    QObject::connect(thread_.get(), &ReadingThread::progressed, &line_, &ReadingLine::tell);
    QObject::connect(thread_.get(), &QThread::finished, &line_, [this] { takeFromThread(); });
    line_.begin(nameOf(path));
    thread_->start();
}

void DocumentFiles::takeFromThread()
{
    // One that was dropped may have been about to say that it is done.
    if (!thread_ || !thread_->isFinished())
        return;
    const std::unique_ptr<ReadingThread> done = std::move(thread_);
    line_.end();
    take(done->path(), done->result());
    goOn();
}

void DocumentFiles::cancelReading()
{
    if (!isReading())
        return;
    const QString name = nameOf(thread_->path());
    dropReading();
    messages_.note(tr("Reading %1 was cancelled. The model is as it was.").arg(name));
}

void DocumentFiles::dropReading()
{
    if (!isReading())
        return;
    job_.reset();
    thread_.reset();
    line_.end();
}

void DocumentFiles::take(const fs::path& path, Result<formats::Import> import)
{
    const bool isFirst = job_->opens && job_->next == 1;
    if (isFirst && !takeFirst(path, import)) {
        job_.reset();
        return;
    }
    if (!import) {
        job_->wrong << QString::fromStdString(import.error().sentence());
        return;
    }
    if (job_->reloads)
        document_.reload(import->scene);
    else if (!isFirst)
        if (const Result<void> added = document_.add(path, import->scene); !added) {
            job_->wrong << QString::fromStdString(added.error().sentence());
            return;
        }
    const formats::Format* format = formats::find(path);
    if (!isFirst && !job_->reloads && format != nullptr && !format->namesUnits)
        job_->notes << tr("%1: The file names no unit of length: its numbers are taken as %2.")
                           .arg(nameOf(path), QString::fromStdString(document_.scene().units()));
    for (const std::string& note : import->notes)
        job_->notes << tr("%1: %2").arg(nameOf(path), QString::fromStdString(note));
}

bool DocumentFiles::takeFirst(const fs::path& path, Result<formats::Import>& import)
{
    if (!import) {
        recentFiles::forget(QString::fromStdString(path.string()));
        report(import.error());
        return false;
    }
    // What was done to the model while the file was read.
    if (!(document_.scene() == job_->sceneBefore) && !mayDrop())
        return false;
    document_.open(path, std::move(import->scene));
    recentFiles::remember(path);
    return true;
}

void DocumentFiles::finish()
{
    const Job job = std::move(*job_);
    job_.reset();
    const QStringList lines = job.wrong + job.notes;  // at the end: a file that works would clear the message
    if (!job.wrong.isEmpty())
        messages_.say(lines.join('\n'));
    else if (!lines.isEmpty())
        messages_.note(lines.join('\n'));
}

}  // namespace knotspan
