#include "ui/questions.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

#include "model/formats/format_list.h"

namespace knotspan {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("knotspan::Questions", text);
}

SaveAnswer saveChanges(QWidget* parent, const QString& title)
{
    QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                    tr("\"%1\" has changes that are not saved.").arg(title),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(tr("They are lost if you do not save them."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return SaveAnswer::save;
    case QMessageBox::Discard:
        return SaveAnswer::discard;
    default:
        return SaveAnswer::cancel;
    }
}

bool overwrite(QWidget* parent, const QString& file)
{
    QMessageBox box(QMessageBox::Warning, tr("Changed by another program"),
                    tr("\"%1\" was changed by another program since it was read here.").arg(file),
                    QMessageBox::Cancel, parent);
    box.setInformativeText(tr("What the other program wrote is lost if you save over it."));
    const QAbstractButton* save = box.addButton(tr("Save &over it"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == save;
}

QStringList filesToOpen(QWidget* parent, const QString& caption, const QStringList& filters)
{
    return QFileDialog::getOpenFileNames(parent, caption, {}, filters.join(";;"));
}

QString fileToSave(QWidget* parent, const QString& caption, const QString& proposal,
                   const QStringList& filters)
{
    return QFileDialog::getSaveFileName(parent, caption, proposal, filters.join(";;"));
}

QStringList patterns(const formats::Format& format)
{
    QStringList all;
    for (const std::string& extension : format.extensions)
        all << "*." + QString::fromStdString(extension);
    return all;
}

QString filter(const QString& name, const QStringList& all)
{
    return QString("%1 (%2)").arg(name, all.join(' '));
}

}  // namespace

Questions askTheUser()
{
    return {saveChanges, overwrite, filesToOpen, fileToSave};
}

QStringList readFilters()
{
    QStringList everything;
    QStringList each;
    for (const formats::Format& format : formats::all()) {
        if (format.read == nullptr)
            continue;
        everything << patterns(format);
        each << filter(QString::fromStdString(format.name), patterns(format));
    }
    return QStringList(filter(tr("All models"), everything)) + each + QStringList(tr("All files (*)"));
}

QStringList writeFilters()
{
    QStringList each;
    for (const formats::Format& format : formats::all())
        if (format.write != nullptr)
            each << filter(QString::fromStdString(format.name), patterns(format));
    return each;
}

}  // namespace knotspan
