#include "ui/recovery_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>

namespace knotspan {

RecoveryBar::RecoveryBar(QWidget* parent) : QFrame(parent)
{
    setObjectName("recovery-bar");
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    setForegroundRole(QPalette::ToolTipText);
    auto* row = new QHBoxLayout(this);
    auto* icon = new QLabel(this);
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
    icon->setPixmap(style()->standardIcon(QStyle::SP_MessageBoxQuestion).pixmap(size, size));
    text_ = new QLabel(this);
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setForegroundRole(QPalette::ToolTipText);
    row->addWidget(icon);
    row->addWidget(text_, 1);
    recover_ =
        addButton("recover", tr("Recover"), tr("Open it in place of this model; its file stays as it is"));
    connect(recover_, &QPushButton::clicked, this, &RecoveryBar::recover);
    connect(addButton("discard-recovery", tr("Discard"), tr("Delete what was kept of it")),
            &QPushButton::clicked, this, &RecoveryBar::discard);
    connect(addButton("recover-later", tr("Later"), tr("Ask again at the next start")), &QPushButton::clicked,
            this, &RecoveryBar::later);
    hide();
}

QPushButton* RecoveryBar::addButton(const char* name, const QString& text, const QString& tip)
{
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    layout()->addWidget(button);
    return button;
}

void RecoveryBar::offer(const QString& sentence, bool readable)
{
    text_->setText(sentence);
    setAccessibleName(sentence);
    recover_->setVisible(readable);
    setVisible(true);
}

void RecoveryBar::withdraw()
{
    text_->clear();
    hide();
}

QString RecoveryBar::sentence() const
{
    return text_->text();
}

}  // namespace knotspan
