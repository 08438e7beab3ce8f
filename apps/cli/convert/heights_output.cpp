// SPDX-License-Identifier: GPL-3.0-or-later
#include "convert/heights_output.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"
#include "setae/formats/profile_file.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli {
namespace {

constexpr const char* text_ending = ".csv";

Array1D positions(const topography::LineScan& scan) {
    return scan.pixel_size() *
           Array1D::LinSpaced(scan.heights.size(), 0.0, static_cast<double>(scan.heights.size() - 1));
}

void write_line(const std::string& path, const Array1D& x, const Array1D& h) {
    tables::write_csv(path, {{{"x", "m", x}, {"h", "m", h}}, {}});
}

/// A map as a matrix without header: one line for each x, NaN spelled out, since an empty cell ends some readers.
void write_matrix(const std::string& path, const Array2D& heights) {
    std::string text;
    for (Index i = 0; i < heights.rows(); ++i)
        for (Index j = 0; j < heights.cols(); ++j)
            fmt::format_to(std::back_inserter(text), "{}{}", heights(i, j), j + 1 < heights.cols() ? ',' : '\n');
    bytes::write_whole_file(path, text);
}

struct CsvWriter {
    std::string path;
    void operator()(const topography::HeightMap& map) const { write_matrix(path, map.heights); }
    void operator()(const topography::LineScan& scan) const { write_line(path, positions(scan), scan.heights); }
    void operator()(const topography::Profile& profile) const {
        if (profile.response || profile.standard_error.size() > 0) formats::write_profile(path, profile);
        else write_line(path, profile.positions, profile.heights);
    }
};

std::string ending_of(const std::string& path) {
    auto ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// Of formats that are written; .csv, which several are read from, comes last.
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

void require_heights_ending(const std::string& path) {
    const auto endings = written_endings();
    if (std::find(endings.begin(), endings.end(), ending_of(path)) == endings.end())
        throw InvalidArgument(
            fmt::format("{}: cannot tell the format from the name; expected an ending {}", path, endings_of_heights()));
}

void write_heights(const std::string& path, const topography::Measurement& measurement) {
    require_heights_ending(path);
    if (ending_of(path) == text_ending) std::visit(CsvWriter{path}, measurement);
    else formats::format_to_write(path).write(path, measurement);
}

}  // namespace setae::cli
