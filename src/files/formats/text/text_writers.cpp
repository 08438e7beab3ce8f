// SPDX-License-Identifier: GPL-3.0-or-later
#include <iterator>

#include <fmt/format.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/profile_file.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/tables/table_file.hpp"
#include "text_channels.hpp"

namespace setae::formats {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Measurement;
using topography::Profile;

/// A name as one line.
std::string one_line(std::string text) {
    for (auto& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    return text;
}

/// Rows `first` to `last` of a map, with all digits.
std::string rows_of(const Array2D& heights, char separator, Index first, Index last) {
    fmt::memory_buffer text;
    for (Index j = first; j < last; ++j)
        for (Index i = 0; i < heights.rows(); ++i)
            fmt::format_to(std::back_inserter(text), "{}{}", heights(i, j), i + 1 < heights.rows() ? separator : '\n');
    return fmt::to_string(text);
}

std::string gwyddion_header(const HeightMap& map) {
    const auto channel =
        map.metadata.name.empty() ? std::string{} : fmt::format("# Channel: {}\n", one_line(map.metadata.name));
    return channel + fmt::format("# Width: {} m\n# Height: {} m\n# Value units: m\n", map.size[0], map.size[1]);
}

/// The top row first, as displayed and as open_text reads a matrix.
void write_matrix(const std::string& path, std::string text, const HeightMap& map, char separator) {
    constexpr Index together = 64;
    const Index rows = map.heights.cols();
    std::vector<std::string> parts(static_cast<std::size_t>((rows + together - 1) / together));
    parallel::for_each_index(parts.size(), {}, [&](std::size_t i) {
        const Index first = static_cast<Index>(i) * together;
        parts[i] = rows_of(map.heights, separator, first, std::min(first + together, rows));
    });
    for (const auto& part : parts) text += part;
    bytes::write_whole_file(path, text);
}

void write_columns(const std::string& path, const Array1D& x, const Array1D& heights) {
    tables::write_csv(path, {{{"x", "m", x}, {"h", "m", heights}}, {}});
}

void write_line(const std::string& path, const LineScan& scan) {
    const auto last = static_cast<double>(scan.heights.size() - 1);
    write_columns(path, scan.pixel_size() * Array1D::LinSpaced(scan.heights.size(), 0.0, last), scan.heights);
}

void write_curve(const std::string& path, const Profile& profile) {
    if (profile.response || profile.standard_error.size() > 0) write_profile(path, profile);
    else write_columns(path, profile.positions, profile.heights);
}

}  // namespace

void write_text_matrix(const std::string& path, const Measurement& measurement) {
    if (const auto* map = std::get_if<HeightMap>(&measurement)) write_matrix(path, gwyddion_header(*map), *map, '\t');
    else write_text_curve(path, measurement);
}

void write_text_curve(const std::string& path, const Measurement& measurement) {
    if (const auto* scan = std::get_if<LineScan>(&measurement)) write_line(path, *scan);
    else if (const auto* profile = std::get_if<Profile>(&measurement)) write_curve(path, *profile);
    else write_matrix(path, {}, std::get<HeightMap>(measurement), ',');
}

}  // namespace setae::formats
