#include "ui/document_files.h"

#include <QFileInfo>
#include <QGuiApplication>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "ui/message_bar.h"
#include "ui/reading_line.h"
#include "ui/reading_thread.h"
#include "ui/recent_files.h"

namespace knotspan {
namespace fs = std::filesystem;

namespace {

// The hourglass, while a file is read or written.
struct Busy {
    Busy() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~Busy() { QGuiApplication::restoreOverrideCursor(); }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
};

std::vector<fs::path> pathsOf(const QStringList& names)
{
    std::vector<fs::path> paths;
    for (const QString& name : names)
        paths.emplace_back(name.toStdString());
    return paths;
}

}  // namespace

DocumentFiles::DocumentFiles(QWidget& window, Document& document, MessageBar& messages, ReadingLine& line,
                             Questions questions)
    : window_(window),
      document_(document),
      messages_(messages),
      line_(line),
      watch_(document),
      questions_(std::move(questions))
{
    QObject::connect(&line_, &ReadingLine::cancelled, &line_, [this] { cancelReading(); });
    QObject::connect(&watch_, &FileWatch::changed, &watch_,
                     [this](const QString& path) { offerReload(path); });
}

DocumentFiles::~DocumentFiles() = default;

bool DocumentFiles::mayDrop()
{
    if (!document_.isModified())
        return true;
    switch (questions_.saveChanges(&window_, document_.title())) {
    case SaveAnswer::save:
        return save();
    case SaveAnswer::discard:
        return true;
    case SaveAnswer::cancel:
        break;
    }
    return false;
}

void DocumentFiles::open(const std::vector<fs::path>& files)
{
    if (files.empty() || isRefusedWhileReading() || !mayDrop())
        return;
    messages_.dismiss();
    start({.files = files, .opens = true, .sceneBefore = document_.scene()});
}

void DocumentFiles::reload()
{
    if (document_.source().empty() || isRefusedWhileReading())
        return;
    messages_.dismiss();
    start({.files = {document_.source()}, .reloads = true});
}

void DocumentFiles::offerReload(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    messages_.offer(document_.isModified()
                        ? tr("%1 was changed by another program, and you have changed the model here. If you "
                             "reload, Undo brings your model back.")
                              .arg(name)
                        : tr("%1 was changed by another program.").arg(name),
                    tr("&Reload"), [this] { reload(); });
}

void DocumentFiles::openRecent(const QString& file)
{
    if (isRefusedWhileReading())
        return;
    if (QFileInfo::exists(file))
        return open({file.toStdString()});
    recentFiles::forget(file);
    messages_.say(tr("%1 is no longer in %2. It was taken off the list of recent files.")
                      .arg(QFileInfo(file).fileName(), QFileInfo(file).path()));
}

void DocumentFiles::startNew()
{
    if (isRefusedWhileReading() || !mayDrop())
        return;
    messages_.dismiss();
    document_.reset({}, {});
}

void DocumentFiles::openSample(const std::string& name)
{
    const Sample* sample = findSample(name);
    if (sample == nullptr || isRefusedWhileReading() || !mayDrop())
        return;
    messages_.dismiss();
    const Busy busy;
    document_.reset(sample->make(), tr("Sample: %1").arg(QString::fromStdString(name)));
}

void DocumentFiles::askAndOpen()
{
    if (isRefusedWhileReading())
        return;
    open(pathsOf(questions_.filesToOpen(&window_, tr("Open a model"), readFilters())));
}

void DocumentFiles::askAndAdd()
{
    if (isRefusedWhileReading())
        return;
    const auto files = pathsOf(questions_.filesToOpen(&window_, tr("Add to this model"), readFilters()));
    if (files.empty())
        return;
    messages_.dismiss();
    start({.files = files, .sceneBefore = document_.scene()});
}

bool DocumentFiles::save()
{
    if (document_.file().empty())
        return saveAs();
    if (watch_.isChanged() &&
        !questions_.overwrite(&window_, QString::fromStdString(document_.file().filename().string())))
        return false;
    messages_.dismissTrouble();
    const Busy busy;
    if (const Result<void> saved = document_.save(); !saved) {
        report(saved.error());
        return false;
    }
    messages_.dismissOffer();
    return true;
}

bool DocumentFiles::saveAs()
{
    const fs::path known = document_.file();
    QString proposal = QString::fromStdString(known.string());
    if (known.empty())
        proposal = QString::fromStdString(document_.source().parent_path().string()) +
                   (document_.source().empty() ? "" : "/") +
                   QFileInfo(document_.title().section(": ", -1)).completeBaseName() + ".knotspan";
    const QString name = questions_.fileToSave(&window_, tr("Save the model as"), proposal, writeFilters());
    if (name.isEmpty())
        return false;
    fs::path path = name.toStdString();
    if (!path.has_extension())
        path += ".knotspan";
    messages_.dismissTrouble();
    const Busy busy;
    if (const Result<void> saved = document_.saveAs(path); !saved) {
        report(saved.error());
        return false;
    }
    recentFiles::remember(path);
    messages_.dismiss();
    noteMeshesLeftOut(path);
    return true;
}

void DocumentFiles::noteMeshesLeftOut(const fs::path& path)
{
    const formats::Format* format = formats::find(path);
    if (document_.scene().meshes().empty() || format == nullptr || format->holdsMeshes)
        return;
    messages_.note(
        tr("%1 files hold surfaces only: the meshes are not in %2. Save as .knotspan to keep them.")
            .arg(QString::fromStdString(format->name), QString::fromStdString(path.filename().string())));
}

void DocumentFiles::report(const Error& error)
{
    messages_.say(QString::fromStdString(error.sentence()));
}

}  // namespace knotspan
