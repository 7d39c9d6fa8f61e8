// Makes a mesh of a snapshot beside the window: to count its triangles, or to write it.
#pragma once

#include <filesystem>
#include <optional>

#include <QThread>

#include "model/formats/mesh_export.h"

namespace knotspan {

class ExportThread : public QThread {
    Q_OBJECT

public:
    // An empty path: nothing is written.
    ExportThread(Scene scene, std::filesystem::path path, const formats::MeshExportOptions& options,
                 QObject* parent = nullptr);
    // Waits: what is half written would be lost.
    ~ExportThread() override;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] bool writes() const { return !path_.empty(); }
    // After finished(): one of the two.
    [[nodiscard]] const Result<formats::MeshCounts>& counted() const { return *counted_; }
    [[nodiscard]] const Result<formats::MeshExportReport>& written() const { return *written_; }

protected:
    void run() override;

private:
    Scene scene_;
    std::filesystem::path path_;
    formats::MeshExportOptions options_;
    std::optional<Result<formats::MeshCounts>> counted_;
    std::optional<Result<formats::MeshExportReport>> written_;
};

}  // namespace knotspan
