// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "setae/answers/json_schemas.hpp"

namespace setae::answers::schemas {

/// In the order of the commands' names.
[[nodiscard]] std::span<const DescribedOutput> described_outputs();

}  // namespace setae::answers::schemas
