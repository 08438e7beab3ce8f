// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/output/json.hpp"

namespace setae::answers {

/// Every format that is read or written: "formats" of topographies, "force_curves" and "micrographs", as `setae
/// formats`.
[[nodiscard]] output::Json formats_json();

}  // namespace setae::answers
