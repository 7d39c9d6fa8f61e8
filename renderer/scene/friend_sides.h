// Which border sides of KSQuads have a friend all along: another border that they meet at least G1
// (model/friends). Rules that oversample borders leave those out (RPNS, eq. 5).
#pragma once

#include "model/friends/friends.h"
#include "renderer/scene/held_residents.h"

namespace knotspan {

class FriendSides {
public:
    // Looks again at what moved. By border side, as border_curves.h numbers them: 1 or 0. `log`: of the
    // residents; null: all are compared.
    const std::vector<std::uint8_t>& of(const std::vector<Resident>& residents,
                                        const ResidentChanges* log = nullptr);

private:
    Friends friends_;
    HeldResidents held_;
    std::vector<std::uint8_t> sides_;
};

}  // namespace knotspan
