// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::cli {

/// The folder of mappings installed with the program, next to the folder of the program; empty if it is unknown.
[[nodiscard]] std::string mapping_folder();

}  // namespace setae::cli
