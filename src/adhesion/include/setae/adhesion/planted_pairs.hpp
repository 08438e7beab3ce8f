// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// What would have been measured on pairs if their line held at W: every input, the noise of every value and the
/// scatter of the model drawn with the ± they have. Same numbers for a seed on any machine.
[[nodiscard]] std::vector<double> planted_values(const std::vector<PairPoint>& pairs, double work_of_adhesion,
                                                 const ModelScatter& scatter, std::uint64_t seed);

}  // namespace setae::adhesion
