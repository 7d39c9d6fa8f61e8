#include "ui/export_thread.h"

#include <new>

namespace knotspan {

ExportThread::ExportThread(Scene scene, std::filesystem::path path, const formats::MeshExportOptions& options,
                           QObject* parent)
    : QThread(parent),
      scene_(std::move(scene)),
      path_(std::move(path)),
      options_(options)
{
}

ExportThread::~ExportThread()
{
    wait();
}

void ExportThread::run()
{
    const tl::unexpected<Error> noMemory(
        Error{"The mesh needs more memory than there is", path_.string(), "Choose a larger deviation"});
    if (writes()) {
        try {
            written_ = formats::exportMesh(scene_, path_, options_);
        } catch (const std::bad_alloc&) {
            written_ = noMemory;
        }
    } else {
        try {
            counted_ = formats::meshCounts(scene_, options_);
        } catch (const std::bad_alloc&) {
            counted_ = noMemory;
        }
    }
}

}  // namespace knotspan
