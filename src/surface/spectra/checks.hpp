// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// @throws InvalidArgument for fewer than two points per direction or a size that is not positive; does not check
/// heights.
void require_shape(const topography::LineScan& scan);
void require_shape(const topography::HeightMap& map);

/// @throws UndefinedDataError if a height is undefined or infinite.
void require_defined(const ArrayView1D& heights, const topography::Metadata& metadata);

/// @throws UndefinedDataError with the measurement and the place.
[[noreturn]] void throw_undefined(const topography::Metadata& metadata, const std::string& where);

/// lower <= q <= upper up to the rounding of mode numbers times 2π/L.
[[nodiscard]] inline bool in_band(double wavevector, double lower, double upper) {
    constexpr double rounding = 1e-12;
    return wavevector >= lower * (1.0 - rounding) && wavevector <= upper * (1.0 + rounding);
}

}  // namespace setae::spectra
