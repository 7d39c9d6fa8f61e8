#include "ui/keys_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/actions.h"
#include "ui/keys_page.h"
#include "ui/viewport/described.h"
#include "ui/viewport/navigation_presets.h"
#include "ui/viewport/viewport.h"

namespace knotspan {

KeysDialog::KeysDialog(CommandKeys& keys, Viewport& viewport, QWidget* parent)
    : QDialog(parent),
      viewport_(viewport)
{
    setWindowTitle(tr("Keys and mouse"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* pages = new QHBoxLayout;
    pages->addWidget(new KeysPage(keys, this), 3);
    pages->addWidget(makeMousePage(), 2);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(pages, 1);
    layout->addWidget(buttons);
    resize(1120, 640);
    connect(&viewport_, &Viewport::navigationChanged, this, &KeysDialog::showMouse);
    showMouse();
}

QWidget* KeysDialog::makeMousePage()
{
    auto* page = new QWidget(this);
    navigation_ = new QComboBox(page);
    describe(navigation_, "navigation", tr("The mouse turns the view as in"),
             tr("Which buttons turn, pan and zoom the view: this program's own, or those of another"));
    for (const NavigationPreset& preset : navigationPresets())
        navigation_->addItem(translatedAction(preset.title).remove('&'));
    connect(navigation_, &QComboBox::activated, this, [this](int chosen) {
        viewport_.setNavigation(navigationPresets()[static_cast<size_t>(chosen)]);
    });
    auto* label = new QLabel(tr("&Mouse:"), page);
    label->setBuddy(navigation_);
    mouse_ = new QTextBrowser(page);
    describe(mouse_, "mouse-list", tr("What the mouse does"), tr("What the mouse does over the picture"));
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(navigation_, 1);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(mouse_, 1);
    return page;
}

void KeysDialog::showMouse()
{
    const NavigationPreset& preset = viewport_.navigation();
    for (size_t k = 0; k < navigationPresets().size(); ++k)
        if (&navigationPresets()[k] == &preset)
            navigation_->setCurrentIndex(static_cast<int>(k));
    QString html = "<table cellpadding='3'>";
    for (const MouseInfo& mouse : mouseList(preset))
        html += QString("<tr><td><b>%1</b></td><td>%2</td></tr>")
                    .arg(mouse.gesture.toHtmlEscaped(), mouse.meaning.toHtmlEscaped());
    mouse_->setHtml(html + "</table>");
}

}  // namespace knotspan
