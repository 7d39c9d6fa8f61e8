#include "model/document/autosave.h"

#include <QDateTime>

#include "model/document/snapshot_thread.h"

namespace knotspan {

Autosave::Autosave(Document& document, std::filesystem::path folder, std::chrono::milliseconds interval,
                   QObject* parent)
    : QObject(parent),
      document_(document),
      folder_(std::move(folder))
{
    connect(&timer_, &QTimer::timeout, this, &Autosave::keep);
    connect(&document_, &Document::fileChanged, this, &Autosave::forgetWhatIsSaved);
    timer_.start(interval);
}

Autosave::~Autosave()
{
    if (document_.history().isClean())
        endInPeace();
}

bool Autosave::isKept(const Scene& scene) const
{
    return kept_ && scene.objects() == kept_->objects() && scene.meshes() == kept_->meshes() &&  // pointers
           scene.units() == kept_->units();
}

void Autosave::keep()
{
    if (thread_ || document_.history().isClean())
        return;
    Scene scene = document_.settledScene();
    if (isKept(scene))
        return;
    formats::RecoveryNote note{document_.title().toStdString(), document_.file(), document_.isImported(),
                               QDateTime::currentSecsSinceEpoch()};
    thread_ =
        std::make_unique<SnapshotThread>(entry_, folder_, std::move(scene), std::move(note), generation_);
    connect(thread_.get(), &QThread::finished, this, &Autosave::take);
    thread_->start();
}

void Autosave::take()
{
    if (!thread_ || !thread_->isFinished())
        return;
    const std::unique_ptr<SnapshotThread> done = std::move(thread_);
    if (!entry_)
        entry_ = done->entry();
    if (done->generation() != generation_) {
        if (done->entry() && done->entry() == entry_)
            entry_->forget();
        else if (done->entry())
            done->entry()->remove();
        return;
    }
    if (done->result()) {
        kept_ = done->scene();
        hasFailed_ = false;
        Q_EMIT kept();
        return;
    }
    if (entry_ && !entry_->isThere())
        entry_.reset();  // somebody cleared it away: the next try makes another
    if (!std::exchange(hasFailed_, true)) {
        Q_EMIT failed(QString::fromStdString(done->result().error().sentence()));
    }
}

void Autosave::forgetWhatIsSaved()
{
    if (!document_.history().isClean())
        return;
    ++generation_;
    kept_.reset();
    if (entry_)
        entry_->forget();
}

void Autosave::adopt(std::shared_ptr<formats::RecoveryEntry> entry)
{
    ++generation_;
    if (entry_) {
        entry_->forget();
        if (!thread_)
            entry_->remove();
    }
    entry_ = std::move(entry);
    kept_ = document_.settledScene();
}

void Autosave::endInPeace()
{
    timer_.stop();
    ++generation_;
    if (entry_)
        entry_->forget();  // so that a thread at work writes no more than it must
    if (thread_) {
        thread_->wait();
        take();
    }
    if (entry_)
        entry_->remove();
    entry_.reset();
}

}  // namespace knotspan
