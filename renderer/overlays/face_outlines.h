// The outlines of what is left of surfaces as lines in the parameters of KSQuads, kept from picture to
// picture.
#pragma once

#include <map>
#include <vector>

#include "renderer/scene/packed_scene.h"

namespace knotspan {

struct OutlineChord {
    std::uint32_t ksquad = 0;  // of the surface's
    Vec2 from{0};              // 0 to 1 across it
    Vec2 to{0};
};

class FaceOutlines {
public:
    // Of a surface's trim curves and the stretches of its border between them; without trim loops all of its
    // border. Chords are no further from the curves than 1/2000 of a KSQuad's side. Made anew where the shape
    // changed.
    const std::vector<OutlineChord>& of(const Resident& resident);

private:
    struct Held {
        SharedTrim trim;
        SharedObject object;
        std::vector<OutlineChord> chords;
    };
    std::map<ObjectId, Held> held_;
};

}  // namespace knotspan
