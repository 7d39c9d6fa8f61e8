// Places on surfaces whose measures are shown: the one under the cursor, and those that were pinned. They are
// kept as parameters of an object, so that they follow their surface wherever it goes.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include <QObject>

#include "model/analysis/place_measures.h"
#include "model/scene/scene.h"

namespace knotspan {

struct Probe {
    ObjectId object{};
    double u = 0;
    double v = 0;
    int number = 0;  // what a pinned one is called, from 1 on; 0: under the cursor

    [[nodiscard]] bool operator==(const Probe&) const = default;
};

// What is there now, at the parameters taken into the domain; nothing where the object is gone.
struct ProbedPlace {
    std::string object;  // its name
    double u = 0;
    double v = 0;
    PlaceMeasures measures;
    double size = 0;  // of the object: what tells a figure from rounding
};
[[nodiscard]] std::optional<ProbedPlace> probed(const Scene& scene, const Probe& probe);

class Probes : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<Probe>& pins() const { return pins_; }
    [[nodiscard]] const std::optional<Probe>& live() const { return live_; }

    // At most so many; the oldest goes for the next.
    static constexpr size_t kMostPins = 500;
    void pin(ObjectId object, double u, double v);
    void unpin(const std::set<int>& numbers);
    // The next one is number 1 again.
    void clear();
    void setLive(std::optional<Probe> probe);
    // Lets go of probes whose objects are gone.
    void keepOnly(const Scene& scene);

Q_SIGNALS:
    void changed();

private:
    std::vector<Probe> pins_;  // by number
    std::optional<Probe> live_;
    int lastNumber_ = 0;
};

}  // namespace knotspan
