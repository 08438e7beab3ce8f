// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/data_folder.hpp"

#include <filesystem>
#include <system_error>

namespace setae::cli {

std::string mapping_folder() {
    std::error_code failure;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (failure) return {};
    return (program.parent_path() / SETAE_DATA_FROM_PROGRAM / "mappings").lexically_normal().string();
}

}  // namespace setae::cli
