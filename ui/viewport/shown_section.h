// A plane through the model and the curves in which it cuts the visible surfaces, for the picture: found
// again only where surface or plane changed, and a part in each picture where there are many.
#pragma once

#include <map>

#include "model/document/document.h"
#include "model/mesh/plane_section.h"
#include "renderer/frame.h"

namespace knotspan {

struct SectionSettings {
    bool shown = false;
    int axis = 2;       // 0, 1, 2: x, y, z, that the plane is perpendicular to
    double offset = 0;  // where on it; model units

    [[nodiscard]] bool operator==(const SectionSettings&) const = default;
};

class ShownSection : public QObject {
    Q_OBJECT

public:
    // It outlives the section.
    explicit ShownSection(const Document& document, QObject* parent = nullptr);

    [[nodiscard]] const SectionSettings& settings() const { return settings_; }
    // A plane that is newly shown, or along another axis, and misses the model, or only touches it, goes to
    // its middle.
    void setSettings(const SectionSettings& settings);

    // What the next picture has to show. Where that takes longer than a hand waits, it is not all:
    // isComplete() is false then, and the next call goes on.
    [[nodiscard]] const std::vector<SharedSpaceLines>& lines();
    [[nodiscard]] bool isComplete() const { return complete_; }
    // Of what lines() gave last.
    [[nodiscard]] double length() const { return length_; }
    [[nodiscard]] size_t curves() const { return curves_; }

Q_SIGNALS:
    void changed();

private:
    struct Cut {
        SharedObject object;
        std::optional<SectionSurface> surface;  // none: it could not be made ready
        std::optional<SectionSettings> at;
        SharedSpaceLines lines;
        double length = 0;
        size_t curves = 0;
    };
    [[nodiscard]] bool meets(const SceneObject& object) const;
    void follow(Cut& cut, const SharedObject& object) const;
    void outline();

    const Document& document_;
    SectionSettings settings_;
    std::map<ObjectId, Cut> cuts_;
    Box outlined_;  // the model's, when the plane's outline was made
    std::optional<SectionSettings> outlinedAt_;
    SharedSpaceLines outline_;
    bool complete_ = true;
    double length_ = 0;
    size_t curves_ = 0;
    std::vector<SharedSpaceLines> lines_;
};

}  // namespace knotspan
