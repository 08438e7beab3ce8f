// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/formats/channel.hpp"
#include "setae/study/study.hpp"

namespace setae::study {

/// What a study says of a file of heights that the file leaves open.
[[nodiscard]] formats::ReadOptions read_options(const MeasurementInput& input);

}  // namespace setae::study
