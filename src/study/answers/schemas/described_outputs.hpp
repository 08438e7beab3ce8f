// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "setae/fields/describe.hpp"

namespace setae::answers::schemas {

/// The JSON output of a command whose result is described by rows.
struct DescribedOutput {
    std::string_view command;  ///< such as "jkr lens"
    const fields::Description* description;
    bool is_list = false;  ///< a list of such results
};

/// In the order of the commands' names.
[[nodiscard]] std::span<const DescribedOutput> described_outputs();

}  // namespace setae::answers::schemas
