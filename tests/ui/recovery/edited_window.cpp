#include "tests/ui/recovery/edited_window.h"

#include <cmath>

#include <QApplication>
#include <QTimer>

#include "model/scene/control_point_editing.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"

namespace knotspan::testing {

namespace {

constexpr double kStep = 1.0 / 3;

Edit moveTo(const Scene& scene, int step)
{
    const auto& [id, object] = *scene.objects().begin();
    Edit edit;
    edit.set(id, withControlPointAt(*object, {0, 0}, Vec3(step * kStep, 2, 3)).value());
    return edit;
}

}  // namespace

int editForEver(const std::filesystem::path& file, const std::filesystem::path& folder, int steps)
{
    Answers answers;
    MainWindow window(answering(answers));
    window.keepForRecovery(folder, std::chrono::milliseconds(1));
    window.files().open({file});
    window.show();
    QTimer hand;
    QObject::connect(&hand, &QTimer::timeout, &window, [&, step = 0]() mutable {
        if (step < steps)
            window.document().apply(moveTo(window.document().scene(), ++step), "move");
    });
    hand.start(2);
    return QApplication::exec();
}

Scene editedScene(const Scene& opened, int steps)
{
    Scene scene = opened;
    moveTo(opened, steps).applyTo(scene);
    return scene;
}

int stepsIn(const Scene& edited)
{
    const Vec3 point = controlPointInModel(*edited.objects().begin()->second, {0, 0});
    return static_cast<int>(std::lround(point.x / kStep));
}

}  // namespace knotspan::testing
