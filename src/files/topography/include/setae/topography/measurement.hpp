// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"

namespace setae::topography {

/// The instrument of a measurement; wavelengths below its resolution are cut from spectra (spectra/reliability.hpp).
struct Instrument {
    std::string name;                                 ///< from the file or the study, such as "Dimension V"
    std::string type;                                 ///< "stylus", "afm", "tem", "optical", or empty if unknown
    std::optional<double> tip_radius;                 ///< [m]
    std::optional<double> tip_radius_standard_error;  ///< [m]
    std::optional<double> resolution;                 ///< shortest wavelength resolved [m]
};

/// Origin of heights.
struct Metadata {
    std::string name;              ///< of the measurement or channel
    std::string file;              ///< path given by the user
    std::string format;            ///< identifier in the table of formats
    std::string unit;              ///< length unit of the file; values here are always metres
    std::string acquisition_time;  ///< as stated by the file
    Instrument instrument;
    std::map<std::string, std::string> attributes;  ///< further header entries
    std::vector<Alert> alerts;  ///< changes to heights on reading: values set undefined, points averaged
};

/// Heights on a regular grid: h(x_i, y_j) with x_i = i · size[0]/nx, shape (nx, ny); first index x, the fast axis.
struct HeightMap {
    Array2D heights;               ///< [m]; NaN = undefined
    std::array<double, 2> size{};  ///< extent along x and y [m]: n · pixel size
    bool periodic = false;
    Metadata metadata;

    [[nodiscard]] std::array<Index, 2> shape() const { return {heights.rows(), heights.cols()}; }
    [[nodiscard]] std::array<double, 2> pixel_size() const {
        return {size[0] / static_cast<double>(heights.rows()), size[1] / static_cast<double>(heights.cols())};
    }
};

/// Heights at equal steps along a line: x_i = i · size/n.
struct LineScan {
    Array1D heights;    ///< [m]; NaN = undefined
    double size = 0.0;  ///< n · pixel size [m]
    bool periodic = false;
    Metadata metadata;

    [[nodiscard]] double pixel_size() const { return size / static_cast<double>(heights.size()); }
};

/// Effect of tracing on a curve, known in advance, for the correction of spectra.
///
///   C_traced(q) = T(q)² C1D(q) + K(q)² N,   T = K exp(−(q blur)²/2),
///   K = 1/(1 + (smoothing_length/step)⁴ (2 − 2 cos(q step))²)
///
/// Lengths along x [m]. K: a smoothing spline on points `step` apart; exp: Gaussian blur of the picture along the
/// curve, to first order in the slope.
struct TraceResponse {
    double blur = 0.0;              ///< standard deviation [m], >= 0
    double smoothing_length = 0.0;  ///< [m], >= 0
    double step = 0.0;              ///< [m], > 0
    double noise_density = 0.0;     ///< N: C1D of the noise of the trace before smoothing [m³], >= 0
    bool jumps = false;  ///< overhangs became jumps of h(x), unaffected by blur and smoothing: T is then not corrected
};

/// A traced curve h(x) as a polyline with strictly increasing x (see clean_contour); integrals are exact on straight
/// segments; the size is x_last − x_first.
struct Profile {
    Array1D positions;  ///< [m]
    Array1D heights;    ///< [m]
    Metadata metadata;
    Array1D standard_error = {};                 ///< of each height [m]; empty if unknown
    std::optional<TraceResponse> response = {};  ///< of a curve traced in a picture

    [[nodiscard]] double size() const { return positions[positions.size() - 1] - positions[0]; }
};

using Measurement = std::variant<HeightMap, LineScan, Profile>;

/// Name of a measurement in messages: its file, and its name in parentheses, if known; otherwise "measurement".
[[nodiscard]] std::string label(const Metadata& metadata);

[[nodiscard]] const Metadata& metadata(const Measurement& measurement);
[[nodiscard]] Metadata& metadata(Measurement& measurement);

/// Shape (nx, ny) of a map, (n) otherwise with the second entry 1.
[[nodiscard]] std::array<Index, 2> shape(const Measurement& measurement);

/// All heights in storage order.
[[nodiscard]] Array1D all_heights(const Measurement& measurement);

/// The measurement with every height multiplied by `factor`, including standard errors and noise of a profile.
[[nodiscard]] Measurement scaled(Measurement measurement, double factor);

/// Checks the invariants of the three types: at least two points per direction, positive finite size, increasing x, no
/// infinite height, at least one defined height; for a profile also one standard error >= 0 per height, or none, and a
/// response within its domain.
/// @throws InvalidArgument or UndefinedDataError with measurement and invalid point.
void validate(const Measurement& measurement);

}  // namespace setae::topography
