#include "model/document/document.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "model/document/edit_command.h"
#include "model/files/length_units.h"
#include "model/formats/format_list.h"

namespace knotspan {
namespace fs = std::filesystem;

namespace {

QString fileTitle(const fs::path& path)
{
    return QString::fromStdString(path.filename().string());
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent)
{
    connect(&undoStack_, &QUndoStack::cleanChanged, this, &Document::fileChanged);
}

QString Document::title() const
{
    return title_.isEmpty() ? tr("Untitled") : title_;
}

QUndoStack& Document::undoStack()
{
    finishRunning();
    return undoStack_;
}

Scene Document::settledScene() const
{
    Scene settled = scene_;
    if (running_)
        Edit(running_->edit).applyTo(settled);
    return settled;
}

// Whether the running gesture has come back to where it began.
bool Document::isBackAtStart() const
{
    const Scene start = settledScene();
    return start.objects() == scene_.objects() && start.meshes() == scene_.meshes();  // pointers
}

Result<void> Document::open(const fs::path& path)
{
    Result<Scene> scene = formats::read(path);
    if (!scene)
        return tl::unexpected(scene.error());
    open(path, std::move(*scene));
    return {};
}

void Document::open(const fs::path& path, Scene content)
{
    const formats::Format* format = formats::find(path);
    const bool isOwn = format != nullptr && format->isOwn;
    replace(std::move(content), isOwn ? fs::absolute(path) : fs::path(), fileTitle(path),
            format != nullptr && !isOwn, fs::absolute(path));
}

void Document::reload(const Scene& content)
{
    endPreview();
    apply(editBetween(settledScene(), content), tr("Reload"));
    undoStack_.setClean();
    ++sourceRevision_;
    Q_EMIT fileChanged();
}

Result<void> Document::add(const fs::path& path)
{
    const Result<Scene> added = formats::read(path);
    if (!added)
        return tl::unexpected(added.error());
    return add(path, *added);
}

Result<void> Document::add(const fs::path& path, const Scene& content)
{
    double scale = 1;
    // Numbers without a unit are taken as the open model's, as when models are compared.
    const formats::Format* format = formats::find(path);
    const bool namesUnits = format == nullptr || format->namesUnits;
    if (namesUnits && content.units() != scene_.units()) {
        scale = formats::millimetresIn(content.units()) / formats::millimetresIn(scene_.units());
        if (!(scale > 0 && std::isfinite(scale)))
            return tl::unexpected(Error{"The file is in \"" + content.units() + "\", the open model in \"" +
                                            scene_.units() + "\", which cannot be converted",
                                        path.string(), "Open it by itself"});
    }
    Scene numbered = scene_;  // hands out the ids
    Edit edit;
    for (const auto& [unused, object] : content.objects()) {
        auto placed = std::make_shared<SceneObject>(*object);
        placed->transform = glm::scale(Mat4(1.0), Vec3(scale)) * placed->transform;
        const ObjectId id = numbered.add(*placed);
        edit.set(id, std::move(placed));
    }
    for (const auto& [unused, mesh] : content.meshes()) {
        auto placed = std::make_shared<MeshObject>(*mesh);
        placed->transform = glm::scale(Mat4(1.0), Vec3(scale)) * placed->transform;
        const ObjectId id = numbered.addMesh(*placed);
        edit.setMesh(id, std::move(placed));
    }
    apply(edit, tr("Add %1").arg(fileTitle(path)));
    return {};
}

void Document::reset(Scene scene, const QString& title)
{
    replace(std::move(scene), {}, title, false, {});
}

void Document::recover(Scene scene, const fs::path& file, const QString& title, bool isImported)
{
    replace(std::move(scene), file, title, isImported, file);
    undoStack_.resetClean();  // which tells fileChanged()
}

void Document::replace(Scene scene, const fs::path& file, const QString& title, bool isImported,
                       const fs::path& source)
{
    running_.reset();
    undoStack_.clear();
    scene_ = std::move(scene);
    file_ = file;
    title_ = title;
    isImported_ = isImported;
    source_ = source;
    ++sourceRevision_;
    Q_EMIT documentReplaced();
    Q_EMIT sceneChanged();
    Q_EMIT fileChanged();
}

Result<void> Document::save()
{
    if (file_.empty())
        return failure("This model has no file of its own yet", "Choose a name with Save as");
    return saveAs(file_);
}

Result<void> Document::saveAs(const fs::path& path)
{
    if (!isPreviewing())
        finishRunning();
    if (Result<void> written = formats::write(settledScene(), path); !written)
        return written;
    file_ = fs::absolute(path);
    source_ = file_;
    ++sourceRevision_;
    title_ = fileTitle(path);
    const formats::Format* format = formats::find(path);
    if (scene_.meshes().empty() || format == nullptr || format->holdsMeshes)
        undoStack_.setClean();
    Q_EMIT fileChanged();
    return {};
}

void Document::apply(const Edit& edit, const QString& text, int gesture)
{
    if (edit.isEmpty())
        return;
    if (!running_ || running_->gesture != gesture)
        finishRunning();
    Edit applied = edit;
    const bool wasModified = isModified();
    if (running_) {
        applied.applyTo(scene_);
        running_->edit.absorb(applied);
        Q_EMIT sceneChanged();
        return;
    }
    swapIn(applied);
    if (gesture == 0)
        undoStack_.push(new EditCommand(*this, std::move(applied), text));
    else
        running_ = Running{gesture, std::move(applied), text, false};
    if (wasModified != isModified())
        Q_EMIT fileChanged();
}

int Document::preview(const Edit& edit, const QString& text)
{
    finishRunning();
    if (edit.isEmpty())
        return 0;
    Edit applied = edit;
    applied.applyTo(scene_);
    const int gesture = newGesture();
    running_ = Running{gesture, std::move(applied), text, true};
    Q_EMIT sceneChanged();
    return gesture;
}

void Document::endPreview()
{
    if (isPreviewing())
        cancelGesture(running_->gesture);
}

void Document::finishGesture(int gesture)
{
    if (!running_ || running_->gesture != gesture)
        return;
    running_->isPreview = false;
    finishRunning();
}

void Document::finishRunning()
{
    endPreview();
    if (!running_)
        return;
    if (isBackAtStart()) {  // no step, and what could be redone still can
        running_.reset();
        Q_EMIT fileChanged();
        return;
    }
    Running finished = std::move(*running_);
    running_.reset();
    undoStack_.push(new EditCommand(*this, std::move(finished.edit), finished.text));
}

void Document::cancelGesture(int gesture)
{
    if (!running_ || running_->gesture != gesture)
        return;
    Edit inverse = std::move(running_->edit);
    running_.reset();
    swapIn(inverse);
    Q_EMIT fileChanged();
}

void Document::swapIn(Edit& edit)
{
    edit.applyTo(scene_);
    Q_EMIT sceneChanged();
}

}  // namespace knotspan
