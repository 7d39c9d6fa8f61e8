#include "ui/reading_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace knotspan {

namespace {

constexpr int kMoment = 300;  // milliseconds
constexpr int kSteps = 1000;

}  // namespace

ReadingLine::ReadingLine(QWidget* parent) : QFrame(parent)
{
    setObjectName("reading-line");
    setFrameShape(QFrame::StyledPanel);
    text_ = new QLabel(this);
    text_->setTextFormat(Qt::PlainText);
    bar_ = new QProgressBar(this);
    bar_->setTextVisible(false);
    bar_->setMaximumWidth(200);
    bar_->setAccessibleName(tr("How much of the file is read"));
    cancel_ = new QPushButton(tr("Cancel"), this);
    cancel_->setObjectName("cancel-reading");
    cancel_->setToolTip(tr("Stop reading; the model stays as it is"));
    connect(cancel_, &QPushButton::clicked, this, &ReadingLine::cancelled);
    auto* row = new QHBoxLayout(this);
    row->addWidget(text_, 1);
    row->addWidget(bar_);
    row->addWidget(cancel_);
    moment_.setSingleShot(true);
    moment_.setInterval(kMoment);
    connect(&moment_, &QTimer::timeout, this, [this] { setVisible(true); });
    hide();
}

void ReadingLine::begin(const QString& file)
{
    file_ = file;
    tell(tr("Starting"), -1);
    moment_.start();
}

void ReadingLine::tell(const QString& stage, double done)
{
    if (file_.isEmpty())
        return;
    text_->setText(tr("%1: %2").arg(file_, stage));
    setAccessibleName(text_->text());
    bar_->setRange(0, done < 0 ? 0 : kSteps);  // without a range it only shows that something happens
    if (done >= 0)
        bar_->setValue(static_cast<int>(done * kSteps));
}

void ReadingLine::end()
{
    moment_.stop();
    file_.clear();
    text_->clear();
    hide();
}

QString ReadingLine::text() const
{
    return text_->text();
}

}  // namespace knotspan
