// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/pages.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "program/messages.hpp"
#include "setae/bytes/whole_file.hpp"

namespace setae::cli {

void write_pages(const std::string& folder, const std::map<std::string, std::string>& pages) {
    std::filesystem::create_directories(folder);
    for (const auto& [name, text] : pages)
        bytes::write_whole_file((std::filesystem::path(folder) / name).string(), text);
    print(fmt::format("{}: {} pages\n", folder, pages.size()));
}

}  // namespace setae::cli
