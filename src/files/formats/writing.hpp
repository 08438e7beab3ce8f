// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// The map for a format of maps only.
/// @throws InvalidArgument for a line or profile; the message contains the endings that can store it.
[[nodiscard]] const topography::HeightMap& required_map(const topography::Measurement& measurement,
                                                        const std::string& path, const std::string& format);

/// Refuses data that only .csv can store: the standard errors of a profile and the response of its trace.
/// @throws InvalidArgument with this reason.
void refuse_trace(const topography::Measurement& measurement, const std::string& path);

/// Format::write of NetCDF and NPY. NPY contains only heights, without size; a profile is refused because its positions
/// would be lost.
/// @throws as write_netcdf, write_npy and refuse_trace.
void write_measurement_as_netcdf(const std::string& path, const topography::Measurement& measurement);
void write_measurement_as_npy(const std::string& path, const topography::Measurement& measurement);

/// Heights h(x, y) as little-endian float64, row after row from the top, as in most formats. Undefined ones become
/// `undefined_as`.
[[nodiscard]] std::string row_bytes(const Array2D& heights, double undefined_as);

/// The parts of a time such as "2016-01-12T09:57:48+02:00", "2016-01-12 09:57" or "2016-01-12"; empty for other forms,
/// which many instruments write.
struct WrittenTime {
    std::string year, month, day, hour, minute, second, zone;

    [[nodiscard]] bool known() const { return !year.empty(); }
};
[[nodiscard]] WrittenTime written_time(const std::string& text);

}  // namespace setae::formats
