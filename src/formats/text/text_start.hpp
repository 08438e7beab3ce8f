// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/tables/text_numbers.hpp"

namespace setae::formats {

/// Where the numbers of a text begin, from its first bytes: as many as it takes to see a whole row. Nothing where no
/// row is found.
[[nodiscard]] std::optional<tables::TextStart> find_start(const bytes::Source& source);

}  // namespace setae::formats
