// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace setae::tests {

/// Folder of real files that lie beside the project and are never part of it: $SETAE_REFERENCE_DATA, else
/// ../shared/data from the project's root (tests run there).
inline std::filesystem::path reference_data_folder() {
    if (const char* folder = std::getenv("SETAE_REFERENCE_DATA")) return folder;
    return std::filesystem::path("..") / "shared" / "data";
}

}  // namespace setae::tests

/// Path of a real file; skips the test with a clear line where it is missing.
#define SETAE_REQUIRE_REFERENCE_DATA(path, relative)                      \
    const auto path = setae::tests::reference_data_folder() / (relative); \
    if (!std::filesystem::exists(path))                                   \
    GTEST_SKIP() << "no " << path << "; set SETAE_REFERENCE_DATA to the folder with the real files"
