#include "ui/keys_dialog.h"

#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/actions.h"

namespace knotspan {

namespace {

QString translated(const char* text)
{
    return translatedAction(text).toHtmlEscaped();
}

QString row(const QString& left, const QString& right)
{
    return QString("<tr><td style='padding-right:18px'><b>%1</b></td><td>%2</td></tr>").arg(left, right);
}

QString keysOf(const ActionInfo& action)
{
    QStringList keys;
    for (const QKeySequence& key : action.shortcuts)
        keys << key.toString(QKeySequence::NativeText).toHtmlEscaped();
    return keys.join(", ");
}

}  // namespace

KeysDialog::KeysDialog(QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Keys and mouse"));
    auto* text = new QTextBrowser(this);
    text->setHtml(content());
    text->setFrameShape(QFrame::NoFrame);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addWidget(buttons);
    resize(700, 660);
}

QString KeysDialog::content()
{
    QString html = "<h3>" + tr("Mouse") + "</h3><table>";
    for (const MouseInfo& mouse : mouseList())
        html += row(translated(mouse.gesture), translated(mouse.meaning));
    html += "</table><h3>" + tr("Keys") + "</h3><table>";
    for (const ActionInfo& action : actionList())
        if (!action.shortcuts.empty())
            html += row(keysOf(action), translated(action.tip));
    return html + "</table>";
}

}  // namespace knotspan
