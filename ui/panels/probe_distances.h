// What lies between probes, in words for people.
#pragma once

#include "ui/panels/probe_table.h"

namespace knotspan {

// Of two places the distance, its parts along the axes and the angle between the normals; of three those of
// neighbours and the angle at the middle one; of more the length of the line through all. Empty for fewer
// than two.
[[nodiscard]] QString distancesText(const std::vector<ProbeTable::Row>& rows, const QString& units);

}  // namespace knotspan
