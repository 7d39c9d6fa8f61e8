#include "ui/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace knotspan {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent)
{
    setObjectName("message-bar");
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    setForegroundRole(QPalette::ToolTipText);

    icon_ = new QLabel(this);
    text_ = new QLabel(this);
    text_->setWordWrap(true);
    text_->setForegroundRole(QPalette::ToolTipText);
    text_->setTextFormat(Qt::PlainText);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    button_ = new QPushButton(this);
    button_->setObjectName("message-action");
    connect(button_, &QPushButton::clicked, this, [this] {
        const auto run = std::move(run_);
        dismiss();
        run();
    });
    auto* close = new QToolButton(this);
    close->setAutoRaise(true);
    close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    close->setToolTip(tr("Close this message"));
    close->setAccessibleName(close->toolTip());
    connect(close, &QToolButton::clicked, this, &MessageBar::dismiss);

    auto* row = new QHBoxLayout(this);
    row->addWidget(icon_);
    row->addWidget(text_, 1);
    row->addWidget(button_, 0, Qt::AlignTop);
    row->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void MessageBar::say(const QString& sentence)
{
    isTrouble_ = true;
    showSentence(sentence, QStyle::SP_MessageBoxWarning);
}

void MessageBar::note(const QString& sentence)
{
    isTrouble_ = false;
    showSentence(sentence, QStyle::SP_MessageBoxInformation);
}

void MessageBar::offer(const QString& sentence, const QString& button, std::function<void()> run)
{
    note(sentence);
    run_ = std::move(run);
    button_->setText(button);
    button_->show();
}

void MessageBar::showSentence(const QString& sentence, QStyle::StandardPixmap icon)
{
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
    icon_->setPixmap(style()->standardIcon(icon).pixmap(size, size));
    text_->setText(sentence);
    setAccessibleName(sentence);
    run_ = nullptr;
    button_->hide();
    setVisible(true);
}

void MessageBar::dismissTrouble()
{
    if (isTrouble_)
        dismiss();
}

void MessageBar::dismissOffer()
{
    if (run_)
        dismiss();
}

void MessageBar::dismiss()
{
    text_->clear();
    run_ = nullptr;
    hide();
}

QString MessageBar::message() const
{
    return text_->text();
}

}  // namespace knotspan
