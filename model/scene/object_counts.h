// How many objects of a scene are hidden, and how many locked, kept up while it changes: a look costs what
// changed since the last one.
#pragma once

#include "model/scene/scene.h"

namespace knotspan {

class ObjectCounts {
public:
    void follow(const Scene& scene);

    [[nodiscard]] size_t hidden() const { return hidden_; }
    [[nodiscard]] size_t locked() const { return locked_; }

private:
    void count(const SharedObject& object, bool comes);

    Scene scene_;
    size_t hidden_ = 0;
    size_t locked_ = 0;
};

}  // namespace knotspan
