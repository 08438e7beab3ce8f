// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::platform {

/// A shared library by its file name, which stays loaded; null if it cannot be loaded.
[[nodiscard]] void* loaded_library(const char* name);

/// Address of one of its functions; null if the library lacks it.
[[nodiscard]] void* function_of(void* library, const char* name);

/// Reason of the last null result; empty if the system gives none.
[[nodiscard]] std::string loading_error();

}  // namespace setae::platform
