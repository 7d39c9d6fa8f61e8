#include "ui/command_text.h"

#include <QStringList>

#include "ui/actions.h"

namespace knotspan {

QString plainTextOf(const QAction& command)
{
    const QString text = command.text();
    QString plain;
    for (int k = 0; k < text.size(); ++k) {
        if (text[k] == '&' && ++k == text.size())
            break;
        plain += text[k];
    }
    if (plain.endsWith(QChar(0x2026)))
        plain.chop(1);
    return plain;
}

QString menuTitleOf(const QAction& command)
{
    const QString menu = command.objectName().section('.', 0, 0);
    for (const MenuInfo& info : menuList())
        if (menu == info.name)
            return translatedAction(info.title).remove('&');
    return menu;
}

QString keysTextOf(const QAction& command)
{
    QStringList keys;
    for (const QKeySequence& key : command.shortcuts())
        keys << key.toString(QKeySequence::NativeText);
    return keys.join(", ");
}

}  // namespace knotspan
