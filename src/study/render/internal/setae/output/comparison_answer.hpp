// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "setae/core/quantity.hpp"
#include "setae/core/table.hpp"

namespace setae::output {

/// Difference of Persson's theory from solved contacts, in a sentence; then both at the first, the middle and the last
/// pressure; in lines of a given width.
///
/// load: pressure and, for area_fraction, mean_gap, contact_stiffness and stored_energy, each, "…_standard_error" and
/// "…_persson".  band: of the spectrum [1/m].  surfaces: number of surfaces of every mean.
[[nodiscard]] std::string comparison_answer(const Table& load, const Band& band, int surfaces, std::size_t columns);

}  // namespace setae::output
