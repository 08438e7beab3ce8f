// SPDX-License-Identifier: GPL-3.0-or-later
#include "writing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <regex>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/formats/npy.hpp"

namespace setae::formats {

const topography::HeightMap& required_map(const topography::Measurement& measurement, const std::string& path,
                                          const std::string& format) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) return *map;
    const bool line = std::holds_alternative<topography::LineScan>(measurement);
    throw InvalidArgument(fmt::format("{}: {} can hold only maps, and this is a {}; write it as {}", path, format,
                                      line ? "line" : "profile",
                                      line ? ".x3p, .sdf, .nc, .npy or .csv" : ".x3p, .nc or .csv"));
}

void refuse_trace(const topography::Measurement& measurement, const std::string& path) {
    const auto* profile = std::get_if<topography::Profile>(&measurement);
    if (profile && (profile->response || profile->standard_error.size() > 0))
        throw InvalidArgument(
            fmt::format("{}: the profile has standard errors or the response of its trace, which this format cannot "
                        "hold; write it as .csv",
                        path));
}

void write_measurement_as_netcdf(const std::string& path, const topography::Measurement& measurement) {
    refuse_trace(measurement, path);
    write_netcdf(path, measurement);
}

void write_measurement_as_npy(const std::string& path, const topography::Measurement& measurement) {
    refuse_trace(measurement, path);
    if (std::holds_alternative<topography::Profile>(measurement))
        throw InvalidArgument(fmt::format(
            "{}: NPY can hold only heights, and this is a profile with its own positions; write it as .x3p, "
            ".nc or .csv",
            path));
    std::visit([&](const auto& m) { write_npy(path, m.heights); }, measurement);
}

std::string row_bytes(const Array2D& heights, double undefined_as) {
    static_assert(std::endian::native == std::endian::little, "heights are written in the byte order of the memory");
    constexpr Index tile = 64;  // rows whose memory distance shares cache lines
    const Index nx = heights.rows(), ny = heights.cols();
    std::string bytes(static_cast<std::size_t>(nx * ny) * sizeof(double), '\0');
    for (Index top = 0; top < ny; top += tile)
        for (Index i = 0; i < nx; ++i)
            for (Index j = top; j < std::min(top + tile, ny); ++j) {
                const double height = std::isnan(heights(i, j)) ? undefined_as : heights(i, j);
                std::memcpy(bytes.data() + static_cast<std::size_t>(j * nx + i) * sizeof(double), &height,
                            sizeof(double));
            }
    return bytes;
}

WrittenTime written_time(const std::string& text) {
    static const std::regex pattern(
        R"((\d{4})-(0[1-9]|1[0-2])-(0[1-9]|[12]\d|3[01])(?:[T ]([01]\d|2[0-3]):([0-5]\d)(?::([0-5]\d(?:\.\d+)?))?\s?(Z|[+-]\d{2}:\d{2})?)?)");
    std::smatch match;
    if (text.size() > 40 || !std::regex_match(text, match, pattern)) return {};
    const auto part = [&](std::size_t index) { return match[index].matched ? match[index].str() : std::string("00"); };
    return {match[1], match[2], match[3], part(4), part(5), part(6), match[7]};
}

}  // namespace setae::formats
