// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::cli {

/// The folder of mappings that came with the program, beside the folder it runs from; empty where that is not known.
[[nodiscard]] std::string mapping_folder();

}  // namespace setae::cli
