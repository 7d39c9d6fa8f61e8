#include "tests/tour/tour.h"

#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QPixmap>
#include <QScreen>
#include <QTest>

#include "model/samples/sample_list.h"

namespace knotspan::testing {

Tour::Tour() : window_(std::make_unique<MainWindow>(answering(answers_))), hand_(*window_)
{
    window_->resize(1240, 780);
    window_->move(0, 0);
    window_->show();
    settle(*window_);
}

Tour::~Tour()
{
    window_->close();
}

void Tour::show(const std::string& sample)
{
    for (const char* shown :
         {"view.combs", "view.section", "view.freezeCulling", "view.nets", "view.friends"})
        if (window_->action(shown)->isChecked())
            act(shown);
    for (const char* dock : {"friends-dock", "tool-dock", "history-dock", "measures-dock"})
        find<QDockWidget>(dock)->hide();
    act("view.onePane");
    shade("shaded");
    viewport().setTool("select");
    window_->document().reset(findSample(sample)->make(), QString::fromStdString(sample));
    window_->selection().clear();
    QTest::qWait(100);  // the window system takes its time to make room where panels went
    act("view.iso");
    settle(*window_);
}

void Tour::showPanel(const char* dock)
{
    auto* panel = find<QDockWidget>(dock);
    panel->show();
    panel->raise();
    settle(*window_);
    QTest::qWait(100);
    act("view.iso");  // the picture has another size
    settle(*window_);
}

void Tour::shade(const char* shading)
{
    auto* box = find<QComboBox>("shading");
    const int index = box->findText(shading);
    ASSERT_GE(index, 0) << shading;
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);  // as by hand
    settle(*window_);
}

Vec2 Tour::at(double across, double down)
{
    const PictureSize size = viewport().pictureSize();
    return {across * size.width, down * size.height};
}

void Tour::wait(const std::function<bool()>& done)
{
    ASSERT_TRUE(QTest::qWaitFor(done, 400'000));  // the benchmark, while others use the machine
}

// A server shows what was drawn a moment later: until two looks are alike.
QImage Tour::screenshot()
{
    constexpr int kBetweenMs = 150;
    constexpr int kLooks = 40;
    QImage last;
    for (int look = 0; look < kLooks; ++look) {
        settle(*window_);
        QTest::qWait(kBetweenMs);
        QImage now = window_->screen()
                         ->grabWindow(0, window_->x(), window_->y(), window_->width(), window_->height())
                         .toImage()
                         .convertToFormat(QImage::Format_RGB32);
        if (!last.isNull() && differingPixels(last, now) < 50)  // a cursor may blink
            return now;
        last = std::move(now);
    }
    ADD_FAILURE() << "the window does not come to rest";
    return last;
}

}  // namespace knotspan::testing
