// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/look.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/study_figures/write_figures.hpp"

namespace setae::file_figures {
namespace {

std::string ending_of(const std::string& path) {
    const auto ending = std::filesystem::path(path).extension().string();
    return ending.empty() ? ending : ending.substr(1);
}

}  // namespace

bool is_figure_path(const std::string& path) {
    constexpr std::array<std::string_view, 3> endings{"svg", "pdf", "png"};
    return std::find(endings.begin(), endings.end(), ending_of(path)) != endings.end();
}

void write_figure(const StudyFigure& figure, const std::string& path) {
    if (!is_figure_path(path))
        throw InvalidArgument(
            fmt::format("{}: cannot tell the format from the name; expected an ending {}", path, figure_endings));
    if (!figure.drawable()) throw UndefinedDataError(fmt::format("{}: cannot be drawn: {}", path, figure.reason));
    bytes::write_whole_file(path, study_figures::bytes_of(figure, ending_of(path)));
}

}  // namespace setae::file_figures
