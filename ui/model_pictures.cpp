#include "ui/model_pictures.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QStandardPaths>

#include "ui/recent_files.h"

namespace knotspan::modelPictures {
namespace fs = std::filesystem;

namespace {

constexpr auto kState = "KnotspanFile";  // a colon would end the key where it is read back

QDir folder()
{
    return {QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures"};
}

QString nameFor(const QString& file)
{
    return QCryptographicHash::hash(file.toUtf8(), QCryptographicHash::Sha1).toHex() + ".png";
}

QString absoluteName(const fs::path& file)
{
    return QString::fromStdString(fs::absolute(file).string());
}

// Changes whenever the file does; empty where there is none.
QString stateOf(const QString& file)
{
    const QFileInfo info(file);
    return info.isFile() ? QString("%1 %2").arg(info.lastModified().toMSecsSinceEpoch()).arg(info.size())
                         : QString();
}

void forgetOthers(const QString& kept)
{
    QStringList known{kept};
    for (const QString& file : recentFiles::all())
        known << nameFor(file);
    const QDir pictures = folder();
    for (const QString& name : pictures.entryList({"*.png"}, QDir::Files))
        if (!known.contains(name))
            QDir(pictures).remove(name);
}

}  // namespace

bool isKept(const fs::path& file)
{
    const QString name = absoluteName(file);
    const QString state = stateOf(name);
    return !state.isEmpty() && QImageReader(folder().filePath(nameFor(name))).text(kState) == state;
}

QImage of(const fs::path& file)
{
    return isKept(file) ? QImage(folder().filePath(nameFor(absoluteName(file)))) : QImage();
}

void keep(const fs::path& file, const QImage& picture)
{
    const QString name = absoluteName(file);
    const QString state = stateOf(name);
    const QDir pictures = folder();
    if (state.isEmpty() || picture.isNull() || !pictures.mkpath("."))
        return;
    const QImage scaled = picture.scaled(kSize, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    QImage small = scaled.copy(
        QRect(QPoint((scaled.width() - kSize.width()) / 2, (scaled.height() - kSize.height()) / 2), kSize));
    small.setText(kState, state);
    // Beside and renamed: another window may read it.
    const fs::path target = pictures.filePath(nameFor(name)).toStdString();
    const fs::path beside = target.string() + ".new";
    std::error_code error;
    if (small.save(QString::fromStdString(beside.string()), "PNG"))
        fs::rename(beside, target, error);
    fs::remove(beside, error);
    forgetOthers(nameFor(name));
}

QImage ofSample(const std::string& name)
{
    return QImage(QString(":/samples/%1.png").arg(QString::fromStdString(name)));
}

}  // namespace knotspan::modelPictures
