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

/// Rows `first` to `last` of a map, every digit of them.
std::string rows_of(const Array2D& heights, Index first, Index last) {
    fmt::memory_buffer text;
    for (Index j = first; j < last; ++j)
        for (Index i = 0; i < heights.rows(); ++i)
            fmt::format_to(std::back_inserter(text), "{}{}", heights(i, j), i + 1 < heights.rows() ? '\t' : '\n');
    return fmt::to_string(text);
}

void write_matrix(const std::string& path, const HeightMap& map) {
    std::string text;
    if (!map.metadata.name.empty()) text += fmt::format("# Channel: {}\n", one_line(map.metadata.name));
    text += fmt::format("# Width: {} m\n# Height: {} m\n# Value units: m\n", map.size[0], map.size[1]);
    constexpr Index together = 64;
    const Index rows = map.heights.cols();
    std::vector<std::string> parts(static_cast<std::size_t>((rows + together - 1) / together));
    parallel::for_each_index(parts.size(), {}, [&](std::size_t i) {
        const Index first = static_cast<Index>(i) * together;
        parts[i] = rows_of(map.heights, first, std::min(first + together, rows));
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
    if (const auto* map = std::get_if<HeightMap>(&measurement)) write_matrix(path, *map);
    else write_text_curve(path, measurement);
}

void write_text_curve(const std::string& path, const Measurement& measurement) {
    if (const auto* scan = std::get_if<LineScan>(&measurement)) write_line(path, *scan);
    else if (const auto* profile = std::get_if<Profile>(&measurement)) write_curve(path, *profile);
    else throw InvalidArgument(fmt::format("{}: a map has no columns x and h; write it as .txt", path));
}

}  // namespace setae::formats
