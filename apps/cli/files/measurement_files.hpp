// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/answers/surface_request.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::cli {

/// The measurements of a file as they are, nothing removed: of a container every one, of other files the channel asked
/// for or else the first that holds heights.
/// @throws what reading throws; InvalidArgument where no channel holds heights.
[[nodiscard]] std::vector<topography::Measurement> measurements_of(const std::string& path,
                                                                   const answers::FileRequest& options);

}  // namespace setae::cli
