// How far some objects are from others, for the picture and for the text beside it. Measured on a thread of
// its own; until that is done what was known before is shown.
#pragma once

#include <memory>
#include <set>

#include <QThread>

#include "model/document/document.h"
#include "model/mesh/deviation_map.h"

namespace knotspan {

// What is compared with what. An empty set: everything visible that the other one does not name; surfaces
// only where both are empty, measured from the meshes.
struct DeviationSettings {
    std::set<ObjectId> measured;
    std::set<ObjectId> reference;  // objects and meshes

    [[nodiscard]] bool operator==(const DeviationSettings&) const = default;
};

class DeviationThread : public QThread {
    Q_OBJECT

public:
    DeviationThread(Scene measured, Scene reference, QObject* parent = nullptr);
    // Waits for the step that it is in.
    ~DeviationThread() override;

    // Once it is finished.
    [[nodiscard]] const Result<DeviationMap>& found() const { return found_; }

protected:
    void run() override;

private:
    Scene measured_;
    Scene reference_;
    Result<DeviationMap> found_ = failure("Nothing is measured yet");
};

class ShownDeviation : public QObject {
    Q_OBJECT

public:
    // It outlives this.
    explicit ShownDeviation(const Document& document, QObject* parent = nullptr);
    ~ShownDeviation() override;

    [[nodiscard]] const DeviationSettings& settings() const { return settings_; }
    void setSettings(const DeviationSettings& settings);

    // For a picture that shows it: begins to measure what is not known yet. Null: nothing is known.
    [[nodiscard]] SharedSurfaceNumbers follow();
    // For one that does not: nothing is measured any more.
    void rest();

    // What was measured last; null: nothing, or that failed.
    [[nodiscard]] const DeviationMap* map() const { return map_ && *map_ ? &**map_ : nullptr; }
    [[nodiscard]] QString failure() const;  // empty: none
    [[nodiscard]] bool isMeasuring() const { return thread_ != nullptr; }

Q_SIGNALS:
    void changed();  // settings, or what is known

private:
    void forget();
    void measure();
    void takeResult();

    const Document& document_;
    DeviationSettings settings_;
    bool isStale_ = true;
    std::unique_ptr<DeviationThread> thread_;  // null: nothing is being measured
    std::optional<Result<DeviationMap>> map_;
};

}  // namespace knotspan
