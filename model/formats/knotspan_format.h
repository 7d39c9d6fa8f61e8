// Knotspan's own format: JSON that keeps every number to the last bit (docs/formats.md).
#pragma once

#include "model/files/format.h"

namespace knotspan::formats {

[[nodiscard]] Format knotspanFormat();

}  // namespace knotspan::formats
