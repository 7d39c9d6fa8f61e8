#include "ui/start_page.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include "model/samples/sample_list.h"
#include "ui/document_files.h"
#include "ui/model_pictures.h"
#include "ui/recent_files.h"
#include "ui/viewport/described.h"

namespace knotspan {

namespace {

constexpr QSize kShown{192, 120};

QLabel* titled(const QString& text, double scale, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    font.setBold(true);
    label->setFont(font);
    return label;
}

// In place of a picture that there is not: the style's sign for a file, on as much room.
QPixmap plainPicture(const QWidget& widget)
{
    QPixmap picture(modelPictures::kSize);
    picture.fill(widget.palette().color(QPalette::AlternateBase));
    QPainter painter(&picture);
    constexpr int kSign = 64;
    widget.style()
        ->standardIcon(QStyle::SP_FileIcon)
        .paint(&painter, QRect(QPoint((picture.width() - kSign) / 2, (picture.height() - kSign) / 2),
                               QSize(kSign, kSign)));
    return picture;
}

void addEntry(QListWidget& list, const QImage& image, const QString& name, const QString& tip,
              const QString& what)
{
    const QPixmap picture = image.isNull() ? plainPicture(list) : QPixmap::fromImage(image);
    QIcon icon;
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected})
        icon.addPixmap(picture, mode);
    auto* entry = new QListWidgetItem(icon, name, &list);
    entry->setToolTip(tip);
    entry->setData(Qt::AccessibleDescriptionRole, tip);
    entry->setData(Qt::UserRole, what);
}

}  // namespace

StartPage::StartPage(DocumentFiles& files, QWidget* parent) : QWidget(parent), files_(files)
{
    setObjectName("start-page");
    setAccessibleName(tr("Start page"));
    makeLayout();
    fillWithSamples();
    connect(open_, &QPushButton::clicked, this, [this] { files_.askAndOpen(); });
    connect(new_, &QPushButton::clicked, this, [this] { files_.startNew(); });
    // Some styles activate by the click that is told of as well.
    const auto choosing = [this](QListWidget* list, const auto& chosen) {
        const auto once = [this, chosen](const QListWidgetItem* entry) {
            const QString what = entry->data(Qt::UserRole).toString();
            if (isVisible() && !files_.isReading())
                chosen(what);
        };
        connect(list, &QListWidget::itemActivated, this, once);
        connect(list, &QListWidget::itemClicked, this, once);
    };
    choosing(samples_, [this](const QString& name) { files_.openSample(name.toStdString()); });
    choosing(recent_, [this](const QString& file) {
        files_.openRecent(file);
        // Not within the entry's own signal: it may be gone from the list then.
        QMetaObject::invokeMethod(
            this, [this] { fillWithRecent(); }, Qt::QueuedConnection);
    });
}

QListWidget* StartPage::makeList(const char* id, const QString& name, const QString& tip)
{
    auto* list = new QListWidget(this);
    describe(list, id, name, tip);
    list->setViewMode(QListView::IconMode);
    list->setMovement(QListView::Static);
    list->setResizeMode(QListView::Adjust);
    list->setIconSize(kShown);
    list->setSpacing(8);
    list->setUniformItemSizes(true);
    list->setTextElideMode(Qt::ElideMiddle);
    list->setGridSize({kShown.width() + 24, kShown.height() + 2 * list->fontMetrics().lineSpacing() + 16});
    list->setFrameShape(QFrame::NoFrame);
    list->viewport()->setAutoFillBackground(false);
    list->setMinimumHeight(list->gridSize().height() + 16);
    return list;
}

void StartPage::makeLayout()
{
    open_ = new QPushButton(tr("&Open…"), this);
    describe(open_, "start-open", tr("Open"), tr("Open a model"));
    new_ = new QPushButton(tr("&New"), this);
    describe(new_, "start-new", tr("New"), tr("Begin with an empty model"));
    auto* about =
        new QLabel(tr("Shape free-form surfaces and see the exact NURBS. Open a model, drop one here, "
                      "or begin with a sample."),
                   this);
    about->setWordWrap(true);
    recent_ = makeList("start-recent", tr("Recent files"), tr("Open a file that was open before"));
    samples_ = makeList("start-samples", tr("Samples"), tr("Begin with a model that comes with the program"));
    recentTitle_ = titled(tr("Recent files"), 1.2, this);

    auto* buttons = new QHBoxLayout;
    buttons->addWidget(open_);
    buttons->addWidget(new_);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(24, 18, 24, 12);
    column->addWidget(titled(tr("Knotspan"), 2, this));
    column->addWidget(about);
    column->addLayout(buttons);
    column->addSpacing(10);
    column->addWidget(recentTitle_);
    column->addWidget(recent_, 1);
    column->addWidget(titled(tr("Samples"), 1.2, this));
    column->addWidget(samples_, 1);
    setTabOrder(open_, new_);
    setTabOrder(new_, recent_);
    setTabOrder(recent_, samples_);
}

void StartPage::fillWithSamples()
{
    for (const Sample& sample : samples())
        addEntry(*samples_, modelPictures::ofSample(sample.name), QString::fromStdString(sample.name),
                 QString::fromStdString(sample.description), QString::fromStdString(sample.name));
    samples_->setCurrentRow(0);
}

void StartPage::fillWithRecent()
{
    recent_->clear();
    for (const QString& file : recentFiles::all())
        addEntry(*recent_, modelPictures::of(file.toStdString()), QFileInfo(file).fileName(), file, file);
    recent_->setCurrentRow(0);
    recent_->setVisible(recent_->count() > 0);
    recentTitle_->setVisible(recent_->count() > 0);
}

void StartPage::showEvent(QShowEvent* event)
{
    fillWithRecent();
    QWidget::showEvent(event);
    (recent_->count() > 0 ? recent_ : samples_)->setFocus();
}

}  // namespace knotspan
