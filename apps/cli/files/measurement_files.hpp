// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "program/options.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::cli {

/// The measurements of a file as they are, nothing removed: of a container every one, of other files the channel asked
/// for or else the first that holds heights.
/// @throws what reading throws; InvalidArgument where no channel holds heights.
[[nodiscard]] std::vector<topography::Measurement> measurements_of(const std::string& path, const FileOptions& options);

}  // namespace setae::cli
