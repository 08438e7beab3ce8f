// SPDX-License-Identifier: GPL-3.0-or-later
#include "column_meaning.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "curve_channel.hpp"
#include "height_names.hpp"

namespace setae::formats {
namespace {

template <std::size_t n>
std::string_view word_among(const std::string& name, const std::array<std::string_view, n>& known) {
    const auto words = words_of_name(name);
    for (const auto word : known)
        if (std::find(words.begin(), words.end(), word) != words.end()) return word;
    return {};
}

}  // namespace

bool is_position_name(const std::string& name) {
    static constexpr std::array<std::string_view, 14> positions{"x",        "pos",    "position", "distance", "lateral",
                                                                "abscissa", "weg",    "strecke",  "messweg",  "abstand",
                                                                "arc",      "offset", "scan",     "path"};
    const auto words = words_of_name(name);
    return !words.empty() && std::find(positions.begin(), positions.end(), words.front()) != positions.end();
}

bool counts_rows(const Array1D& values) {
    for (Index i = 0; i < values.size(); ++i)
        if (values[i] != values[0] + static_cast<double>(i)) return false;
    return values[0] == 0.0 || values[0] == 1.0;
}

std::string other_quantity(const std::string& name) {
    static constexpr std::array quantities = std::to_array<std::string_view>(
        {"time",        "zeit",       "temps",       "timestamp",   "force",        "kraft",
         "load",        "voltage",    "current",     "temperature", "humidity",     "frequency",
         "wavelength",  "wavevector", "wavenumber",  "intensity",   "count",        "counts",
         "energy",      "work",       "adhesion",    "modulus",     "stress",       "strain",
         "pressure",    "phase",      "amplitude",   "deflection",  "indentation",  "penetration",
         "charge",      "speed",      "velocity",    "stiffness",   "rms",          "radius",
         "diameter",    "area",       "volume",      "psd",         "density",      "acf",
         "bandwidth",   "error",      "deviation",   "residual",    "fft",          "spectrum",
         "spectra",     "power",      "correlation", "corr",        "covariance",   "autocorrelation",
         "probability", "histogram",  "hist",        "absorbance",  "transmission", "transmittance",
         "reflectance", "hardness",   "friction",    "weight",      "weights",      "kernel",
         "bias",        "gradient",   "slope",       "curvature",   "mask",         "label",
         "labels",      "log",        "log10",       "ln",          "lg",           "latitude",
         "longitude",   "angle"});
    return std::string(word_among(name, quantities));
}

std::string reason_against_heights(const tables::RawTable::RawColumn& column) {
    constexpr Index min_counted = 8;
    if (!column.text.empty()) return fmt::format("text, {}", column.text);
    if (const auto quantity = other_quantity(column.name); !quantity.empty() && !is_height_name(column.name))
        return fmt::format("its name means {}", quantity);
    if (!column.unit.empty() && !is_length_unit(column.unit)) return fmt::format("its unit is {}", column.unit);
    if (column.values.size() >= min_counted && counts_rows(column.values)) return "numbers of rows";
    return {};
}

}  // namespace setae::formats
