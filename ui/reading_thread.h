// Reads one file beside the window.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>

#include <QThread>

#include "model/formats/format_list.h"

namespace knotspan {

class ReadingThread : public QThread {
    Q_OBJECT

public:
    explicit ReadingThread(std::filesystem::path path, QObject* parent = nullptr);
    // Cancels and waits, about a tenth of a second.
    ~ReadingThread() override;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    void cancel() { cancelled_ = true; }
    [[nodiscard]] bool isCancelled() const { return cancelled_; }

    // After finished(). Once.
    [[nodiscard]] Result<formats::Import> result() { return std::move(*result_); }

Q_SIGNALS:
    void progressed(const QString& stage, double done);

protected:
    void run() override;

private:
    std::filesystem::path path_;
    std::atomic<bool> cancelled_ = false;
    std::optional<Result<formats::Import>> result_;
};

}  // namespace knotspan
