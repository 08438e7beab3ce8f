// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/heights_file.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

namespace setae::answers {
namespace {

constexpr const char* text_ending = ".csv";

std::string ending_of(const std::string& path) {
    auto ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// Endings of formats that are written; .csv, which several formats use, is last.
std::vector<std::string> written_endings() {
    std::vector<std::string> endings;
    for (const auto& format : formats::formats()) {
        if (!format.writes()) continue;
        std::istringstream words(format.extensions);
        for (std::string ending; words >> ending;)
            if (ending != text_ending) endings.push_back(ending);
    }
    endings.emplace_back(text_ending);
    return endings;
}

}  // namespace

std::string endings_of_heights() {
    auto endings = written_endings();
    const auto last = endings.back();
    endings.pop_back();
    return fmt::format("{} or {}", fmt::join(endings, ", "), last);
}

void require_heights_ending(const std::string& path, const std::string& others) {
    const auto endings = written_endings();
    if (std::find(endings.begin(), endings.end(), ending_of(path)) == endings.end())
        throw InvalidArgument(fmt::format("{}: cannot tell the format from the name; expected an ending {}{}", path,
                                          endings_of_heights(), others.empty() ? others : "; of a figure " + others));
}

void write_heights(const std::string& path, const topography::Measurement& measurement) {
    require_heights_ending(path);
    formats::format_to_write(path).write(path, measurement);
}

}  // namespace setae::answers
