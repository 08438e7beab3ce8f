// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/platform/libraries.hpp"

#include <dlfcn.h>

namespace setae::platform {

void* loaded_library(const char* name) { return ::dlopen(name, RTLD_NOW | RTLD_LOCAL); }

void* function_of(void* library, const char* name) { return ::dlsym(library, name); }

std::string loading_error() {
    const char* const reason = ::dlerror();
    return reason ? reason : "";
}

}  // namespace setae::platform
