// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "matrix_header.hpp"
#include "setae/formats/channel.hpp"
#include "setae/tables/text_numbers.hpp"

namespace setae::formats {

/// The maps of a text, one per header, or the line of heights of one column or row. Lines are counted here, numbers
/// parsed by `read`.
/// @throws FormatError with the line: a header with another number of points, an incomplete last line.
[[nodiscard]] std::vector<Channel> matrix_channels(const tables::TextStart& start, const MatrixHeader& header,
                                                   const ReadOptions& options, const std::vector<Alert>& alerts);

}  // namespace setae::formats
