// The same surface seen in other parameters: turned round, u and v exchanged, another domain. Trim loops have
// to go the same way, so each function has its like for them.
//
// Turning round and exchanging are exact, and undo themselves to the bit; each of them turns the surface's
// normal over.
#pragma once

#include "model/geometry/knot_insertion.h"
#include "model/geometry/trim_loop.h"

namespace knotspan {

// The parameter of `direction` becomes its negative, so that nothing is rounded: the domain [a, b] becomes
// [-b, -a].
[[nodiscard]] NurbsSurface reversed(const NurbsSurface& surface, Direction direction);

// u becomes v and v becomes u.
[[nodiscard]] NurbsSurface swapped(const NurbsSurface& surface);

// The domain of `direction` becomes [start, end] by an affine map; its ends are met exactly. Refuses, with a
// sentence, a domain that is empty or not finite, or so short or so far off that knots fall together.
[[nodiscard]] Result<NurbsSurface> withDomain(const NurbsSurface& surface, Direction direction, double start,
                                              double end);

// The face stays on the same side: the loop runs the other way round.
[[nodiscard]] TrimLoop reversed(const TrimLoop& loop, Direction direction);
[[nodiscard]] TrimLoop swapped(const TrimLoop& loop);

// Of a surface whose domain along `direction` was [oldStart, oldEnd].
[[nodiscard]] TrimLoop withDomain(const TrimLoop& loop, Direction direction, double oldStart, double oldEnd,
                                  double start, double end);

}  // namespace knotspan
