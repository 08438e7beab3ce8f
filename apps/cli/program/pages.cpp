// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/pages.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "program/messages.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::cli {
namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

void write_page(const std::string& path, const std::string& page) {
    if (std::filesystem::exists(path) && first_line(bytes::read_back(path)) != first_line(page))
        throw FileError(fmt::format("{}: is another file; expected \"{}\" as its first line, or no file with this name",
                                    path, first_line(page)));
    bytes::write_whole_file(path, page);
}

void write_pages(const std::string& folder, const std::map<std::string, std::string>& pages) {
    std::filesystem::create_directories(folder);
    for (const auto& [name, text] : pages) write_page((std::filesystem::path(folder) / name).string(), text);
    print(fmt::format("{}: {} pages\n", folder, pages.size()));
}

}  // namespace setae::cli
