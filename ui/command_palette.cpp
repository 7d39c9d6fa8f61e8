#include "ui/command_palette.h"

#include <algorithm>

#include <QAccessible>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QSettings>
#include <QVBoxLayout>

#include "ui/command_delegate.h"
#include "ui/command_model.h"
#include "ui/command_search.h"
#include "ui/command_text.h"
#include "ui/viewport/described.h"

namespace knotspan {

namespace {

constexpr auto kRecentKey = "recentCommands";
constexpr int kMostRecent = 8;
constexpr QSize kSize{620, 440};

void rememberUse(const QString& name)
{
    QSettings settings;
    QStringList recent = settings.value(kRecentKey).toStringList();
    recent.removeAll(name);
    recent.prepend(name);
    settings.setValue(kRecentKey, recent.mid(0, kMostRecent));
}

}  // namespace

CommandPalette::CommandPalette(const QList<QAction*>& commands, QWidget* parent)
    : QDialog(parent, Qt::Dialog | Qt::FramelessWindowHint),
      commands_(commands),
      filter_(new QLineEdit(this)),
      list_(new QListView(this)),
      model_(new CommandModel(this))
{
    setObjectName("command-palette");
    setWindowTitle(tr("Find an action"));
    describe(filter_, "command-filter", tr("Words of the action's name"),
             tr("Words in any order; the arrow keys choose, Enter runs, Escape closes"));
    filter_->setPlaceholderText(tr("What do you want to do?"));
    filter_->setClearButtonEnabled(true);
    filter_->installEventFilter(this);
    describe(list_, "command-list", tr("Actions that match"), tr("Click an action to run it"));
    list_->setModel(model_);
    list_->setItemDelegate(new CommandDelegate(list_));
    list_->setUniformItemSizes(true);
    list_->setFocusPolicy(Qt::NoFocus);  // the keys stay with the words
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(filter_);
    column->addWidget(list_);
    setFocusProxy(filter_);
    connect(filter_, &QLineEdit::textChanged, this, &CommandPalette::find);
    connect(list_, &QListView::clicked, this, &CommandPalette::run);
}

void CommandPalette::showEvent(QShowEvent* event)
{
    filter_->clear();
    find();
    filter_->setFocus();
    const QRect over = parentWidget()->geometry();
    resize(kSize.boundedTo(over.size()));
    move(over.center().x() - width() / 2, over.top() + (over.height() - height()) / 4);
    QDialog::showEvent(event);
}

void CommandPalette::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::ActivationChange && isVisible() && !isActiveWindow())
        hide();
    QDialog::changeEvent(event);
}

void CommandPalette::find()
{
    std::vector<CommandWords> words;
    for (const QAction* command : std::as_const(commands_))
        words.push_back(
            {command->objectName(), plainTextOf(*command), menuTitleOf(*command), command->statusTip()});
    QList<QAction*> found;
    const QStringList recent = QSettings().value(kRecentKey).toStringList();
    for (const size_t k : commandsFor(words, filter_->text(), recent))
        found << commands_[static_cast<qsizetype>(k)];
    model_->setCommands(found);
    list_->setCurrentIndex(model_->index(0));
    list_->scrollToTop();
    tellCurrent();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    switch (key) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        go(key);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        run(list_->currentIndex());
        return true;
    default:
        return false;
    }
}

// A step goes round, a page stops at the ends.
void CommandPalette::go(int key)
{
    const int count = model_->rowCount();
    if (count == 0)
        return;
    const int page = std::max(1, list_->viewport()->height() / list_->sizeHintForRow(0));
    int row = list_->currentIndex().row();
    if (key == Qt::Key_Up || key == Qt::Key_Down)
        row = (row + (key == Qt::Key_Down ? 1 : count - 1)) % count;
    else
        row = std::clamp(row + (key == Qt::Key_PageDown ? page : -page), 0, count - 1);
    list_->setCurrentIndex(model_->index(row));
    tellCurrent();
}

// Screen readers follow the focus, which is not in the list.
void CommandPalette::tellCurrent()
{
    if (!QAccessible::isActive() || !list_->currentIndex().isValid())
        return;
    QAccessibleEvent event(list_, QAccessible::Focus);
    event.setChild(list_->currentIndex().row());
    QAccessible::updateAccessibility(&event);
}

void CommandPalette::run(const QModelIndex& index)
{
    QAction* command = model_->command(index.row());
    if (command == nullptr || !command->isEnabled())
        return;
    rememberUse(command->objectName());
    hide();  // before what it brings up
    command->trigger();
}

}  // namespace knotspan
