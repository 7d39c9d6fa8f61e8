// The tables by which neighbours draw the same vertices along their common borders
// (shaders/shared/borders.glsl), made from where the borders of surfaces run together.
#pragma once

#include <optional>

#include "model/analysis/coincident_edges.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

struct BorderTables {
    std::vector<gpu::BorderSide> sides;  // borderSideIndex()
    std::vector<std::uint32_t> corners;  // borderCornerIndex(): 4 KSQuad + corner that owns the point
    std::vector<gpu::BorderPiece> pieces;
    std::vector<gpu::BorderUse> uses;
};

// What an update changed of them.
struct BorderChanges {
    std::optional<BorderTables> before;  // all may be others; nothing: only these entries are
    std::vector<std::uint32_t> sides;
    std::vector<std::uint32_t> corners;
};

class SharedEdges {
public:
    explicit SharedEdges(const std::vector<PlacedSurface>& surfaces = {});

    // The result is as if all were made anew, to the bit. Returns nothing where no border moved: the tables
    // stay as they are.
    std::optional<BorderChanges> update(const std::vector<CoincidentEdges::Change>& changes);

    // Which sides have a friend (friend_sides.h). An edge counts as friendly where all its sides do; before
    // this is told, where anybody shares it. Returns the tables as they were before, or nothing where they
    // stay.
    std::optional<BorderTables> setFriends(const std::vector<std::uint8_t>& sides);

    [[nodiscard]] const BorderTables& tables() const { return tables_; }
    [[nodiscard]] const CoincidentEdges& edges() const { return edges_; }

private:
    void makeTables();
    // Where no side that was touched is cut into pieces, or was; else false.
    bool updateEntries(BorderChanges& changes);
    [[nodiscard]] bool isInPieces(std::uint32_t side) const;
    // Of a side that is not in pieces, without its friends.
    [[nodiscard]] gpu::BorderSide entryOf(std::uint32_t side) const;
    [[nodiscard]] bool isFriendly(std::uint32_t side) const;
    void markFriends();
    void addPieces(std::uint32_t side, const CoincidentEdge& edge, std::uint32_t firstUse);
    void addUses(const CoincidentEdge& edge);

    CoincidentEdges edges_;
    std::vector<std::uint32_t> names_;  // 4 KSQuad + side, by border side
    BorderTables tables_;
    std::vector<std::uint8_t> friends_;  // by side; empty: not told
};

}  // namespace knotspan
