#include "ui/recovery.h"

#include <algorithm>

#include <QDateTime>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>

#include "model/formats/recovery_entry.h"
#include "ui/document_files.h"
#include "ui/message_bar.h"
#include "ui/recovery_bar.h"

namespace knotspan {

namespace {

QString timeOf(std::int64_t seconds)
{
    const QDateTime time = QDateTime::fromSecsSinceEpoch(seconds);
    const QLocale locale;
    return time.date() == QDate::currentDate() ? locale.toString(time.time(), QLocale::ShortFormat)
                                               : locale.toString(time, QLocale::ShortFormat);
}

}  // namespace

Recovery::Recovery(Document& document, DocumentFiles& files, MessageBar& messages, RecoveryBar& bar,
                   const std::filesystem::path& folder, std::chrono::milliseconds interval)
    : document_(document),
      files_(files),
      messages_(messages),
      bar_(bar),
      autosave_(document, folder, interval)
{
    QObject::connect(&autosave_, &Autosave::failed, &messages_, [this](const QString& sentence) {
        messages_.note(
            tr("No copy of the unsaved changes could be kept for a crash: %1 Save the model from time to "
               "time; Knotspan goes on trying.")
                .arg(sentence));
    });
    QObject::connect(&bar_, &RecoveryBar::recover, &autosave_, [this] { recover(); });
    QObject::connect(&bar_, &RecoveryBar::later, &autosave_, [this] { next(); });
    QObject::connect(&bar_, &RecoveryBar::discard, &autosave_, [this] {
        offered_.front()->remove();
        next();
    });
    for (auto& entry : formats::RecoveryEntry::leftBehind(folder))
        offered_.push_back(std::move(entry));
    offer();
}

Recovery::~Recovery() = default;

void Recovery::offer()
{
    if (offered_.empty())
        return bar_.withdraw();
    const auto note = offered_.front()->note();
    if (note)
        bar_.offer(tr("Knotspan ended unexpectedly. Recover %1 as it was at %2?")
                       .arg(QString::fromStdString(note->title), timeOf(note->seconds)),
                   true);
    else
        bar_.offer(tr("Knotspan ended unexpectedly, and what it kept of the model cannot be read: %1")
                       .arg(QString::fromStdString(note.error().sentence())),
                   false);
}

void Recovery::next()
{
    offered_.pop_front();  // its lock goes: another start finds it, where it was not discarded
    offer();
}

void Recovery::recover()
{
    if (!files_.mayDrop())
        return;
    const auto entry = offered_.front();
    const auto note = entry->note();
    auto scene = entry->read();
    if (!note || !scene) {
        const Error& error = note ? scene.error() : note.error();
        messages_.say(tr("The model cannot be recovered: %1 What was kept stays until you discard it.")
                          .arg(QString::fromStdString(error.sentence())));
        return;
    }
    messages_.dismiss();
    document_.recover(std::move(*scene), note->file, QString::fromStdString(note->title), note->isImported);
    autosave_.adopt(entry);
    next();
}

std::filesystem::path recoveryFolder()
{
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    return std::filesystem::path(data.toStdString()) / "recovery";
}

std::chrono::milliseconds autosaveInterval()
{
    using std::chrono::seconds;
    const auto usual = static_cast<int>(std::chrono::duration_cast<seconds>(Autosave::kInterval).count());
    return seconds(std::clamp(QSettings().value("autosaveSeconds", usual).toInt(), 1, 24 * 60 * 60));
}

}  // namespace knotspan
