// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "setae/core/table.hpp"
#include "setae/persson/scales.hpp"

namespace setae::output {

/// Contact of a body with a surface of the given spectrum, in sentences: the band, h' and the pressure for full
/// contact, then a sentence for each of at most three pressures, the first, the middle and the last of
/// persson::load_table(); in lines of a given width.
[[nodiscard]] std::string persson_answer(const Table& load, const persson::Scales& scales, double contact_modulus,
                                         std::size_t width);

}  // namespace setae::output
