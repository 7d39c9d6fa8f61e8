#include "ui/viewport/viewport.h"

#include <algorithm>

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>

#include "renderer/scene/framed_points.h"
#include "ui/viewport/input.h"
#include "ui/viewport/navigation_presets.h"

namespace knotspan {

Viewport::Viewport(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      navigation_(&navigationPresets().front()),
      input_(std::make_unique<Input>(*this))
{
    setAccessibleName(tr("Viewport"));
    setFocusPolicy(Qt::StrongFocus);
    layout_ = new QStackedLayout(this);
    layout_->setContentsMargins(0, 0, 0, 0);

    failurePage_ = new QWidget(this);
    failureText_ = new QLabel(failurePage_);
    failureText_->setWordWrap(true);
    failureText_->setAlignment(Qt::AlignCenter);
    failureText_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* retry = new QPushButton(tr("Try again"), failurePage_);
    retry->setToolTip(tr("Look for a graphics device once more"));
    connect(retry, &QPushButton::clicked, this, &Viewport::restart);
    auto* page = new QVBoxLayout(failurePage_);
    page->addStretch();
    page->addWidget(failureText_);
    page->addWidget(retry, 0, Qt::AlignHCenter);
    page->addStretch();
    layout_->addWidget(failurePage_);

    connect(&document_, &Document::documentReplaced, this, [this] {
        cancelDrag();
        selection_.clear();
        probes_.clear();
        viewPending_ = true;
        frame_.cullingCamera.reset();  // it stood before another model
        panes_.forgetCameras();
        if (frame_.shading == Shading::deviation)
            frame_.shading = Shading::shaded;  // nothing is chosen to be compared any more
        Q_EMIT frameChanged();
    });
    connect(&document_, &Document::sceneChanged, this, [this] {
        selection_.keepOnly(document_.scene());
        probes_.keepOnly(document_.scene());
        scenePending_ = true;
        requestDraw();
    });
    connect(&selection_, &Selection::changed, this, &Viewport::requestDraw);
    connect(&probes_, &Probes::changed, this, &Viewport::requestDraw);
    connect(&combs_, &ShownCombs::changed, this, &Viewport::requestDraw);
    connect(&section_, &ShownSection::changed, this, &Viewport::requestDraw);
    connect(&deviation_, &ShownDeviation::changed, this, &Viewport::requestDraw);
    settling_.setSingleShot(true);
    connect(&settling_, &QTimer::timeout, this, &Viewport::settle);
    frame_.camera.up = {0, 0, 1};
    frame_.culling = defaultCulling();
    restart();
}

Viewport::~Viewport()
{
    document_.disconnect(this);
    selection_.disconnect(this);
    probes_.disconnect(this);
    combs_.disconnect(this);
    section_.disconnect(this);
    deviation_.disconnect(this);
    usePresenter(nullptr);
}

void Viewport::restart()
{
    usePresenter(nullptr);
    renderer_.reset();
    drawnPanes_.clear();
    scenePending_ = true;
    Result<std::unique_ptr<Renderer>> made = Renderer::create();
    if (!made) {
        showFailure(made.error());
    } else {
        renderer_ = std::move(*made);
        if (!renderer_->whyUnavailable(frame_.path).empty())
            frame_.path = renderer_->bestPath();
        usePresenter(makePresenter(*renderer_));
    }
    Q_EMIT rendererChanged();
    Q_EMIT frameChanged();
    requestDraw();
}

void Viewport::showFailure(const Error& error)
{
    failureText_->setText(QString::fromStdString(error.sentence()));
    layout_->setCurrentWidget(failurePage_);
}

void Viewport::usePresenter(std::unique_ptr<Presenter> presenter)
{
    if (presenter_) {
        cancelDrag();
        presenter_->surface()->removeEventFilter(this);
        layout_->removeWidget(presenter_->widget());
    }
    presenter_ = std::move(presenter);
    if (!presenter_)
        return;
    presenter_->surface()->installEventFilter(this);
    presenter_->widget()->setAccessibleName(tr("Picture of the model"));
    layout_->addWidget(presenter_->widget());
    layout_->setCurrentWidget(presenter_->widget());
    setFocusProxy(presenter_->widget());
}

void Viewport::setFrame(const Frame& frame)
{
    frame_ = frame;
    Q_EMIT frameChanged();
    requestDraw();
}

void Viewport::setToolSettings(const ToolSettings& settings)
{
    toolSettings_ = settings;
    Q_EMIT toolSettingsChanged();
}

void Viewport::setTool(std::string_view name)
{
    for (const ToolInfo& info : tools())
        if (info.name == name && name != tool()) {
            input_->setTool(info);
            requestDraw();
            Q_EMIT toolChanged();
        }
}

std::string_view Viewport::tool() const
{
    return input_->tool().name;
}

void Viewport::setNavigation(const NavigationPreset& preset)
{
    cancelDrag();
    navigation_ = &preset;
    Q_EMIT navigationChanged();
}

void Viewport::setCamera(const Camera& camera)
{
    viewPending_ = false;
    frame_.camera = camera;
    Q_EMIT frameChanged();
    requestDraw();
}

void Viewport::look(std::string_view view)
{
    const Camera& camera = frame_.camera;
    if (const auto named = namedView(view, framedPoints(document_.scene()), pictureSize().aspect(),
                                     camera.orthographic, camera.verticalFovDegrees))
        setCamera(*named);
}

void Viewport::fit()
{
    setCamera(fitted(frame_.camera, framedPoints(document_.scene()), pictureSize().aspect()));
}

void Viewport::fitSelection()
{
    Scene selected;
    for (const ObjectId id : selection_.objects())
        if (const SharedObject object = document_.scene().find(id))
            selected.exchange(id, object);
    for (const ObjectId id : selection_.meshes())
        if (const auto mesh = document_.scene().meshes().find(id); mesh != document_.scene().meshes().end())
            selected.exchangeMesh(id, mesh->second);
    const bool nothing = selected.objects().empty() && selected.meshes().empty();
    const Scene& shown = nothing ? document_.scene() : selected;
    setCamera(fitted(frame_.camera, framedPoints(shown), pictureSize().aspect()));
}

void Viewport::lookFrom(const CubePart& part)
{
    setCamera(lookedFrom(part, frame_.camera));
}

void Viewport::setFriends(ShownFriends& friends)
{
    friends_ = &friends;
    connect(&friends, &ShownFriends::changed, this, &Viewport::requestDraw);
    requestDraw();
}

void Viewport::showDeviation(bool on)
{
    if (on && deviation_.settings() == DeviationSettings{})
        deviation_.setSettings({selection_.objects(), {}});
    Frame frame = frame_;
    frame.shading = on ? Shading::deviation : Shading::shaded;
    setFrame(frame);
}

void Viewport::zoomTo(const Vec3& point, double units, const Vec3& outward)
{
    setCamera(closeTo(frame_.camera, point, units, outward));
}

bool Viewport::cancelDrag()
{
    return presenter_ && input_->cancel();
}

bool Viewport::isDragging() const
{
    return input_->isDragging();
}

bool Viewport::eventFilter(QObject* watched, QEvent* event)
{
    if (!presenter_ || watched != presenter_->surface())
        return QWidget::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::Expose:
    case QEvent::Resize:
    case QEvent::Show:
        requestDraw();
        return false;
    default:
        return input_->handle(*event);
    }
}

Pick Viewport::pick(const Vec2& position, double radius)
{
    if (drawPending_)
        drawNow();
    Result<Pick> picked = renderer_->pick(position.x, position.y, radius);
    if (picked) {
        if (const auto object = picked->object()) {
            const SharedObject found = document_.scene().find(*object);
            if (!found || found->locked)
                picked->place.reset();
        }
        return *picked;
    }
    Q_EMIT failed(QString::fromStdString(picked.error().sentence()));
    return {};
}

}  // namespace knotspan
