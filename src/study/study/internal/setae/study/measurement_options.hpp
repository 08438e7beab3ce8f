// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/formats/channel.hpp"
#include "setae/study/study.hpp"

namespace setae::study {

/// Metadata that a study gives for a file of heights without them.
[[nodiscard]] formats::ReadOptions read_options(const MeasurementInput& input);

}  // namespace setae::study
