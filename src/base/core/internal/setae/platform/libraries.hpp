// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::platform {

/// A shared library by the name of its file, which stays loaded; null where it cannot be.
[[nodiscard]] void* loaded_library(const char* name);

/// Where one of its functions is; null where it has none of this name.
[[nodiscard]] void* function_of(void* library, const char* name);

/// Why one of these was null the last time; empty where the system does not say.
[[nodiscard]] std::string reason_of_missing();

}  // namespace setae::platform
