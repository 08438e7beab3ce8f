// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/mapping_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/mapping.hpp"

namespace setae::tables {
namespace {

namespace fs = std::filesystem;

constexpr const char* ending_of_mappings = ".toml";

bool reads_through(const std::string& file, const std::string& mapping) {
    try {
        require_loop_columns(read_mapped_table(file, read_mapping(mapping)), file);
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

std::vector<std::string> mapping_names(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(folder, failure))
        if (entry.path().extension() == ending_of_mappings) names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string mapping_path(const std::string& name, const std::string& folder) {
    // a broken link, or a name that is too long, is refused on opening
    std::error_code failure;
    if (fs::symlink_status(name, failure).type() != fs::file_type::not_found) return name;
    const auto names = mapping_names(folder);
    if (std::find(names.begin(), names.end(), name) != names.end())
        return (fs::path(folder) / (name + ending_of_mappings)).string();
    const auto nearest = nearest_match(name, names);
    throw FileError(fmt::format("{}: no such file, and no mapping of this name{}; mappings in this folder: {}", name,
                                nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest),
                                names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

std::vector<std::string> fitting_mappings(const std::string& file, const std::string& folder) {
    auto names = mapping_names(folder);
    std::erase_if(names, [&](const std::string& name) { return !reads_through(file, mapping_path(name, folder)); });
    return names;
}

std::string fitting_mappings_hint(const std::string& file, const std::string& folder) {
    const auto fitting = fitting_mappings(file, folder);
    return fitting.empty() ? ""
                           : fmt::format("; a mapping that came with setae reads it: --mapping {}",
                                         fmt::join(fitting, ", or --mapping "));
}

}  // namespace setae::tables
