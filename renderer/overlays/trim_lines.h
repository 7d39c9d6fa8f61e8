// Trim curves as lines in the parameters of KSQuads, kept from picture to picture.
#pragma once

#include <map>

#include "model/friends/edge_part.h"
#include "model/friends/trim_pieces.h"
#include "model/scene/scene.h"

namespace knotspan {

class TrimLines {
public:
    // Of an object's curve, pieces of degree 1, no further from it than 1/500 of a KSQuad's side. None where
    // the object has no such curve. Made anew where the curve or the knots changed.
    const std::vector<TrimPiece>* of(ObjectId id, const SharedObject& object, const TrimPlace& place);

private:
    struct Held {
        SharedObject object;
        std::vector<TrimPiece> pieces;
    };
    std::map<std::tuple<ObjectId, std::uint32_t, std::uint32_t>, Held> held_;
};

}  // namespace knotspan
