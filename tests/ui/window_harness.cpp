#include "tests/ui/window_harness.h"
#include "ui/document_files.h"

#include <algorithm>
#include <cstdlib>

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWindow>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/formats/format_list.h"
#include "model/samples/sample_list.h"
#include "model/scene/control_point_editing.h"

namespace knotspan::testing {

Questions answering(Answers& answers)
{
    Questions questions;
    questions.saveChanges = [&answers](QWidget*, const QString&) {
        ++answers.askedToSave;
        return answers.saveChanges;
    };
    questions.overwrite = [&answers](QWidget*, const QString&) {
        ++answers.askedToOverwrite;
        return answers.overwrite;
    };
    questions.filesToOpen = [&answers](QWidget*, const QString&, const QStringList&) {
        return answers.filesToOpen;
    };
    questions.fileToSave = [&answers](QWidget*, const QString&, const QString&, const QStringList&) {
        return answers.fileToSave;
    };
    return questions;
}

bool settle(MainWindow& window)
{
    QElapsedTimer clock;
    clock.start();
    do {
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        if (!window.viewport().isDrawPending() && clock.elapsed() > 40)
            return true;
    } while (clock.elapsed() < 240'000);
    return false;
}

std::unique_ptr<MainWindow> shownWindow(Answers& answers, const std::string& sample)
{
    auto window = std::make_unique<MainWindow>(answering(answers));
    window->files().openSample(sample);
    window->resize(820, 460);
    window->show();
    settle(*window);
    return window;
}

StatsPanel& statsOf(MainWindow& window)
{
    return *window.findChild<StatsPanel*>();
}

std::filesystem::path sampleFile(const TemporaryFolder& folder, const std::string& name)
{
    const std::filesystem::path path = folder / (name + ".knotspan");
    EXPECT_TRUE(formats::write(findSample(name)->make(), path).has_value());
    return path;
}

QImage picture(MainWindow& window)
{
    const Result<Picture> captured = window.viewport().renderer()->capture();
    if (!captured)
        return {};
    const QImage image(captured->rgba.data(), captured->width, captured->height, captured->width * 4,
                       QImage::Format_RGBA8888);
    return image.convertToFormat(QImage::Format_RGB32);
}

int differingPixels(const QImage& a, const QImage& b, int tolerance)
{
    if (a.size() != b.size())
        return std::max(a.width() * a.height(), b.width() * b.height());
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            const int difference = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                             std::abs(qBlue(p) - qBlue(q))});
            count += difference > tolerance ? 1 : 0;
        }
    return count;
}

void Hand::send(QEvent::Type type, Qt::MouseButton button)
{
    const double ratio = window_.viewport().devicePixelRatioF();
    const QPointF at(at_.x / ratio, at_.y / ratio);
    QMouseEvent event(type, at, at, at, button, down_, keys_);
    QCoreApplication::sendEvent(window_.viewport().surface(), &event);
}

void Hand::press(Vec2 at, Qt::MouseButton button, Qt::KeyboardModifiers keys)
{
    at_ = at;
    down_ = button;
    keys_ = keys;
    send(QEvent::MouseButtonPress, button);
}

void Hand::move(Vec2 to)
{
    at_ = to;
    send(QEvent::MouseMove, Qt::NoButton);
}

void Hand::release()
{
    const Qt::MouseButton button = down_;
    down_ = Qt::NoButton;
    send(QEvent::MouseButtonRelease, button);
    keys_ = {};
}

void Hand::click(Vec2 at, Qt::KeyboardModifiers keys)
{
    press(at, Qt::LeftButton, keys);
    release();
}

void Hand::drag(Vec2 from, Vec2 to, Qt::MouseButton button, Qt::KeyboardModifiers keys)
{
    press(from, button, keys);
    for (const double part : {0.25, 0.5, 1.0})
        move(from + (to - from) * part);
    release();
}

void Hand::wheel(Vec2 at, int notches)
{
    const double ratio = window_.viewport().devicePixelRatioF();
    const QPointF position(at.x / ratio, at.y / ratio);
    QWheelEvent event(position, position, {}, QPoint(0, 120 * notches), Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(window_.viewport().surface(), &event);
}

bool Hand::key(int key, const QString& text, Qt::KeyboardModifiers keys)
{
    QObject* picture = window_.viewport().surface();
    QKeyEvent asked(QEvent::ShortcutOverride, key, keys, text);
    asked.ignore();
    QCoreApplication::sendEvent(picture, &asked);
    QKeyEvent down(QEvent::KeyPress, key, keys, text);
    QCoreApplication::sendEvent(picture, &down);
    QKeyEvent up(QEvent::KeyRelease, key, keys, text);
    QCoreApplication::sendEvent(picture, &up);
    return asked.isAccepted();
}

void Hand::hover(Vec2 at, Qt::KeyboardModifiers keys)
{
    at_ = at;
    down_ = Qt::NoButton;
    keys_ = keys;
    send(QEvent::MouseMove, Qt::NoButton);
    keys_ = {};
}

std::optional<VisiblePoint> visiblePoint(MainWindow& window, ObjectId object)
{
    constexpr double kMargin = 40;
    constexpr double kApart = 5;
    const SharedObject shape = window.document().scene().find(object);
    const PictureSize size = window.viewport().pictureSize();
    std::vector<VisiblePoint> shown;
    for (int i = 0; i < shape->surface.countU(); ++i)
        for (int j = 0; j < shape->surface.countV(); ++j)
            if (const auto pixel = window.viewport().frame().camera.toPixel(
                    controlPointInModel(*shape, {i, j}), size.width, size.height))
                shown.push_back({object, {i, j}, *pixel});
    for (const VisiblePoint& point : shown) {
        const bool inside = point.pixel.x > kMargin && point.pixel.x < size.width - kMargin &&
                            point.pixel.y > kMargin && point.pixel.y < size.height - kMargin;
        const bool alone = std::all_of(shown.begin(), shown.end(), [&](const VisiblePoint& other) {
            return other.index == point.index || glm::length(other.pixel - point.pixel) > kApart;
        });
        if (inside && alone)
            return point;
    }
    return std::nullopt;
}

Vec3 positionOf(MainWindow& window, const VisiblePoint& point)
{
    return controlPointInModel(*window.document().scene().find(point.object), point.index);
}

}  // namespace knotspan::testing
