#include "ui/reading_thread.h"

namespace knotspan {

ReadingThread::ReadingThread(std::filesystem::path path, QObject* parent)
    : QThread(parent),
      path_(std::move(path))
{
}

ReadingThread::~ReadingThread()
{
    cancel();
    wait();
}

void ReadingThread::run()
{
    const auto tell = [this](const std::string& stage, double done) {
        Q_EMIT progressed(QString::fromStdString(stage), done);
    };
    result_ = formats::readWithNotes(path_, {tell, &cancelled_});
}

}  // namespace knotspan
