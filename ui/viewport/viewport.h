// The view of the model: owns the renderer and the frame that the window edits, draws when something changed
// and never else, and lets the hand turn the view and use the current tool.
#pragma once

#include <memory>
#include <set>

#include <QTimer>
#include <QWidget>

#include "ui/tools/tool.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/pace.h"
#include "ui/viewport/presenter.h"
#include "ui/viewport/shown_combs.h"
#include "ui/viewport/shown_deviation.h"
#include "ui/viewport/shown_friends.h"
#include "ui/viewport/shown_section.h"
#include "ui/viewport/view_cube.h"
#include "ui/viewport/view_panes.h"

class QLabel;
class QStackedLayout;

namespace knotspan {

class Input;
struct NavigationPreset;

class Viewport : public QWidget {
    Q_OBJECT

public:
    // Document and selection outlive the viewport.
    Viewport(Document& document, Selection& selection, QWidget* parent = nullptr);
    ~Viewport() override;

    // Null where none could be made; the viewport then shows the reason in its place.
    [[nodiscard]] Renderer* renderer() { return renderer_.get(); }
    // Makes a new renderer, after the old one failed.
    void restart();

    [[nodiscard]] const Frame& frame() const { return frame_; }
    // Draws soon. Size, selection and marks are the viewport's own and need not be set.
    void setFrame(const Frame& frame);
    void setCamera(const Camera& camera);

    [[nodiscard]] const ToolSettings& toolSettings() const { return toolSettings_; }
    // Counts from the next press on.
    void setToolSettings(const ToolSettings& settings);

    // One of tools(), by its name; others are passed over.
    void setTool(std::string_view name);
    [[nodiscard]] std::string_view tool() const;

    // Which buttons turn the view; one of navigationPresets().
    [[nodiscard]] const NavigationPreset& navigation() const { return *navigation_; }
    void setNavigation(const NavigationPreset& preset);

    // One, two or four views; frame() is that of the one that was clicked last.
    [[nodiscard]] PaneLayout paneLayout() const { return panes_.layout(); }
    void setPaneLayout(PaneLayout layout);
    [[nodiscard]] bool showsCube() const { return showsCube_; }
    void showCube(bool on);

    // A named view of everything, or of the selected objects. With no renderer the camera moves all the same.
    void look(std::string_view view);
    void fit();
    void fitSelection();

    // Draws what it has to show, from now on; it outlives the viewport.
    void setFriends(ShownFriends& friends);
    // What is measured where; lines at the places are in the picture.
    [[nodiscard]] Probes& probes() { return probes_; }
    [[nodiscard]] ShownCombs& combs() { return combs_; }
    [[nodiscard]] ShownSection& section() { return section_; }
    [[nodiscard]] ShownDeviation& deviation() { return deviation_; }
    // Turns the shading `deviation` on and off. Where nothing was chosen to be compared yet, the selected
    // surfaces are measured.
    void showDeviation(bool on);
    // Goes to a point of the model, so that about `units` around it fill the picture, and turns so far that
    // one looks against `outward`; a zero vector: not at all.
    void zoomTo(const Vec3& point, double units, const Vec3& outward);

    // Takes a running drag back, or stops turning the view; false where neither ran.
    bool cancelDrag();
    // Whether the hand is changing the model: what else would change it waits.
    [[nodiscard]] bool isDragging() const;

    // Draws at once what would be drawn soon.
    void drawNow();
    // Whether another picture comes without anybody doing anything.
    [[nodiscard]] bool isDrawPending() const { return drawPending_ || settling_.isActive(); }
    // Of the view that frame() is, and where its upper left corner is in the picture of all views.
    [[nodiscard]] PictureSize pictureSize() const;
    [[nodiscard]] Vec2 pictureCorner() const;
    // The object that gets the picture's events: a QWindow or a QWidget.
    [[nodiscard]] QObject* surface() const { return presenter_ ? presenter_->surface() : nullptr; }

    [[nodiscard]] QSize sizeHint() const override { return {960, 640}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {360, 300}; }

Q_SIGNALS:
    void frameChanged();
    // The next frame may take long: the driver compiles shaders for it.
    void preparing();
    void frameDrawn(const knotspan::FrameStats& stats);
    void rendererChanged();
    void toolSettingsChanged();
    void toolChanged();
    void navigationChanged();
    // What a tool has to say while the hand is busy; empty: nothing more.
    void hint(const QString& sentence);
    // What the colour under the pointer stands for; empty: nothing, or the shading shows no numbers.
    void rampRead(const QString& text);
    void failed(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    friend class Input;

    void requestDraw();
    void usePresenter(std::unique_ptr<Presenter> presenter);
    void showFailure(const Error& error);
    [[nodiscard]] PictureSize wholeSize() const;
    // Makes the view under a pixel of the whole picture the one to work in.
    void workAt(const Vec2& pixel);
    [[nodiscard]] bool worksAt(const Vec2& pixel) const;
    [[nodiscard]] CubePicture cubePicture() const;
    void hoverCube(const std::optional<CubePart>& part);
    void lookFrom(const CubePart& part);
    void lookAfresh();
    void addSelectionTo(Overlays& overlays) const;
    void addViewTo(Frame& frame, bool isCurrent) const;
    [[nodiscard]] Frame sharedFrame();
    [[nodiscard]] Result<void> drawOthers(const Frame& shared);
    [[nodiscard]] Result<void> draw();
    [[nodiscard]] Result<void> present();
    [[nodiscard]] bool mayLoosen() const;
    void keepPace(const Frame& drawn, double ms, bool isTrimmed);
    void settle();
    [[nodiscard]] Pick pick(const Vec2& position, double radius);
    void readRamp(const std::optional<Vec2>& position);

    Document& document_;
    Selection& selection_;
    ShownFriends* friends_ = nullptr;
    Frame frame_;  // of the current pane
    ViewPanes panes_;
    std::vector<std::optional<Frame>> drawnPanes_;  // what the picture still has of each
    bool showsCube_ = true;
    std::optional<CubePart> hoveredPart_;  // of the cube
    Probes probes_;
    ShownCombs combs_{document_, selection_};
    ShownSection section_{document_};
    ShownDeviation deviation_{document_};
    ToolSettings toolSettings_;
    const NavigationPreset* navigation_;
    Pace pace_;
    double loosened_ = 0;     // the next frame's tolerance, where it is looser than the frame's own
    bool sharpened_ = false;  // whether the next frame's borders are not smoothed, for speed
    QTimer settling_;         // runs while the last picture is looser than asked for
    bool drawPending_ = false;
    bool scenePending_ = true;
    bool viewPending_ = true;  // look at the whole model as soon as the picture has a size

    QStackedLayout* layout_ = nullptr;
    QWidget* failurePage_ = nullptr;
    QLabel* failureText_ = nullptr;
    std::unique_ptr<Input> input_;
    std::unique_ptr<Renderer> renderer_;  // outlives the presenter
    std::unique_ptr<Presenter> presenter_;
};

}  // namespace knotspan
