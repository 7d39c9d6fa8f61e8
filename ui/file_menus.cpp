#include "ui/file_menus.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMenu>

#include "model/samples/sample_list.h"
#include "ui/document_files.h"
#include "ui/recent_files.h"

namespace knotspan {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("knotspan::FileMenus", text);
}

void fillWithRecent(QMenu& menu, DocumentFiles& files)
{
    menu.clear();
    const QStringList known = recentFiles::all();
    for (const QString& file : known) {
        QAction* entry = menu.addAction(QFileInfo(file).fileName());
        entry->setStatusTip(file);
        entry->setToolTip(file);
        QObject::connect(entry, &QAction::triggered, &menu, [&files, file] { files.openRecent(file); });
    }
    menu.setToolTipsVisible(true);
    if (known.isEmpty()) {
        menu.addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    QObject::connect(menu.addAction(tr("Forget these files")), &QAction::triggered, &menu,
                     [] { recentFiles::clear(); });
}

}  // namespace

void addSamplesMenu(QMenu& menu, DocumentFiles& files)
{
    QMenu& list = *menu.addMenu(tr("New from sa&mple"));
    list.setToolTipsVisible(true);
    for (const Sample& sample : samples()) {
        QAction* entry = list.addAction(QString::fromStdString(sample.name));
        entry->setToolTip(QString::fromStdString(sample.description));
        entry->setStatusTip(entry->toolTip());
        QObject::connect(entry, &QAction::triggered, &list,
                         [&files, name = sample.name] { files.openSample(name); });
    }
}

void addRecentMenu(QMenu& menu, DocumentFiles& files)
{
    QMenu& list = *menu.addMenu(tr("Open &recent"));
    QObject::connect(&list, &QMenu::aboutToShow, &list, [&] { fillWithRecent(list, files); });
}

}  // namespace knotspan
