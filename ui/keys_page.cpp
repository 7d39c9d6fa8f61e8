#include "ui/keys_page.h"

#include <functional>
#include <utility>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/command_search.h"
#include "ui/command_text.h"
#include "ui/viewport/described.h"

namespace knotspan {

namespace {

enum Column { kAction, kMenu, kKeys };

// Tells of each key at once: the base waits a second for more of them.
class Recorder : public QKeySequenceEdit {
public:
    Recorder(QWidget* parent, std::function<void()> heard)
        : QKeySequenceEdit(parent),
          heard_(std::move(heard))
    {
    }

protected:
    void keyPressEvent(QKeyEvent* event) override
    {
        QKeySequenceEdit::keyPressEvent(event);
        heard_();
    }

private:
    std::function<void()> heard_;
};

QString shown(const QKeySequence& key)
{
    return key.toString(QKeySequence::NativeText);
}

}  // namespace

KeysPage::KeysPage(CommandKeys& keys, QWidget* parent) : QWidget(parent), keys_(keys)
{
    filter_ = new QLineEdit(this);
    describe(filter_, "keys-filter", tr("Words of an action, or a key"),
             tr("Show only actions with these words, or with this key"));
    filter_->setPlaceholderText(tr("Search actions and keys"));
    filter_->setClearButtonEnabled(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(filter_);
    column->addWidget(makeList(), 1);
    column->addLayout(makeRecorder());
    column->addLayout(makeChoice());
    connect(filter_, &QLineEdit::textChanged, this, &KeysPage::filter);
    connect(&keys_, &CommandKeys::changed, this, &KeysPage::showKeys);
    connect(list_, &QTreeWidget::currentItemChanged, this, &KeysPage::forget);
    showKeys();
    list_->setCurrentItem(list_->topLevelItem(0));
}

QWidget* KeysPage::makeList()
{
    list_ = new QTreeWidget(this);
    describe(list_, "keys-list", tr("Actions and their keys"), tr("Choose the action that gets a new key"));
    list_->setHeaderLabels({tr("Action"), tr("Menu"), tr("Keys")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAllColumnsShowFocus(true);
    for (const QAction* command : keys_.commands()) {
        auto* item = new QTreeWidgetItem(list_, {plainTextOf(*command), menuTitleOf(*command)});
        for (const int column : {kAction, kMenu, kKeys})
            item->setToolTip(column, command->statusTip());
    }
    list_->header()->setSectionResizeMode(kAction, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(kMenu, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(kKeys, QHeaderView::ResizeToContents);
    list_->header()->setStretchLastSection(false);
    return list_;
}

QPushButton* KeysPage::makeButton(const char* id, const QString& text, const QString& tip)
{
    auto* button = new QPushButton(text, this);
    describe(button, id, text, tip);
    button->setAutoDefault(false);  // Enter may be the key that is recorded
    return button;
}

QLayout* KeysPage::makeRecorder()
{
    recorder_ = new Recorder(this, [this] { hearKey(); });
    describe(recorder_, "new-key", tr("New key"), tr("Click here and press the new key"));
    keepOld_ = new QCheckBox(tr("Keep &old keys"), this);
    describe(keepOld_, "keep-old-keys", tr("Keep old keys"), tr("Keep the keys that the action has already"));
    use_ = makeButton("use-key", tr("&Use"), tr("Give the action this key"));
    none_ = makeButton("no-key", tr("&No key"), tr("Take all its keys from the action"));
    reset_ = makeButton("reset-key", tr("&Reset"), tr("Give the action the keys that it came with"));
    resetAll_ =
        makeButton("reset-all-keys", tr("Reset &all"), tr("Give every action the keys that it came with"));
    auto* label = new QLabel(tr("New &key:"), this);
    label->setBuddy(recorder_);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(recorder_, 1);
    for (QWidget* widget : std::initializer_list<QWidget*>{keepOld_, use_, none_, reset_, resetAll_})
        row->addWidget(widget);
    connect(recorder_, &QKeySequenceEdit::keySequenceChanged, this, &KeysPage::hearKey);
    connect(keepOld_, &QCheckBox::toggled, this, &KeysPage::hearKey);
    connect(use_, &QPushButton::clicked, this, &KeysPage::grant);
    connect(none_, &QPushButton::clicked, this, [this] {
        if (QAction* command = chosen())
            keys_.assign(*command, {});
    });
    connect(reset_, &QPushButton::clicked, this, &KeysPage::wishDefaults);
    connect(resetAll_, &QPushButton::clicked, &keys_, &CommandKeys::resetAll);
    return row;
}

QLayout* KeysPage::makeChoice()
{
    trouble_ = new QLabel(this);
    describe(trouble_, "key-conflict", tr("Who has the key"), tr("Who has the key already"));
    trouble_->setWordWrap(true);
    take_ = makeButton("take-key", tr("&Take it from there"),
                       tr("Give the key to the chosen action; the other one loses it"));
    cancel_ = makeButton("leave-key", tr("&Cancel"), tr("Leave all keys as they are"));
    auto* row = new QHBoxLayout;
    row->addWidget(trouble_, 1);
    row->addWidget(take_);
    row->addWidget(cancel_);
    connect(take_, &QPushButton::clicked, this, &KeysPage::grant);
    connect(cancel_, &QPushButton::clicked, this, &KeysPage::forget);
    return row;
}

void KeysPage::filter()
{
    for (int k = 0; k < list_->topLevelItemCount(); ++k) {
        const QAction& command = *keys_.commands()[k];
        const CommandWords words{command.objectName(), plainTextOf(command), menuTitleOf(command),
                                 command.statusTip() + ' ' + keysTextOf(command)};
        list_->topLevelItem(k)->setHidden(!farOff(words, filter_->text()));
    }
}

void KeysPage::showKeys()
{
    for (int k = 0; k < list_->topLevelItemCount(); ++k) {
        const QAction& command = *keys_.commands()[k];
        QTreeWidgetItem& item = *list_->topLevelItem(k);
        item.setText(kKeys, keysTextOf(command));
        QFont font = list_->font();
        font.setBold(keys_.isChanged(command));
        item.setFont(kKeys, font);
    }
    filter();
    forget();
}

QAction* KeysPage::chosen() const
{
    return keys_.commands().value(list_->indexOfTopLevelItem(list_->currentItem()), nullptr);
}

void KeysPage::hearKey()
{
    QAction* command = chosen();
    wish_.reset();
    if (command != nullptr && !recorder_->keySequence().isEmpty()) {
        KeyList keys = keepOld_->isChecked() ? command->shortcuts() : KeyList();
        if (!keys.contains(recorder_->keySequence()))
            keys << recorder_->keySequence();
        wish_ = Wish{command, keys};
    }
    showWish();
}

void KeysPage::wishDefaults()
{
    QAction* command = chosen();
    if (command == nullptr)
        return;
    wish_ = Wish{command, keys_.defaultKeys(*command)};
    if (keys_.conflicts(*wish_->command, wish_->keys).empty())
        grant();
    else
        showWish();
}

void KeysPage::showWish()
{
    const std::vector<KeyConflict> conflicts =
        wish_ ? keys_.conflicts(*wish_->command, wish_->keys) : std::vector<KeyConflict>();
    QStringList sentences;
    bool takeable = true;
    for (const KeyConflict& conflict : conflicts) {
        const QString name = plainTextOf(*conflict.by);
        takeable = takeable && keys_.commands().contains(conflict.by);
        if (!keys_.commands().contains(conflict.by))
            sentences << tr("%1 opens the menu \"%2\".").arg(shown(conflict.had), name);
        else if (conflict.had == conflict.wanted)
            sentences << tr("%1 is the key of \"%2\".").arg(shown(conflict.had), name);
        else
            sentences << tr("%1 and %2, the key of \"%3\", begin alike.")
                             .arg(shown(conflict.wanted), shown(conflict.had), name);
    }
    trouble_->setText(sentences.join(' '));
    take_->setVisible(!conflicts.empty() && takeable);
    cancel_->setVisible(!conflicts.empty());
    use_->setEnabled(wish_ && conflicts.empty());
    const QAction* command = chosen();
    none_->setEnabled(command != nullptr && !command->shortcuts().isEmpty());
    reset_->setEnabled(command != nullptr && keys_.isChanged(*command));
    resetAll_->setEnabled(keys_.isAnyChanged());
    recorder_->setEnabled(command != nullptr);
}

void KeysPage::grant()
{
    if (!wish_)
        return;
    const Wish wish = *wish_;
    forget();
    keys_.assign(*wish.command, wish.keys);
}

void KeysPage::forget()
{
    recorder_->clear();
    wish_.reset();
    showWish();
}

}  // namespace knotspan
