// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/amplitude_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::synthesis {
namespace {

/// Cell and place in the cell are the upper and lower bits of a double: exponent and 7 bits, and the other 45.
constexpr int place_bits = 45;

double number_at(std::uint64_t cell, double place) {
    const double lower = std::bit_cast<double>(cell << place_bits),
                 upper = std::bit_cast<double>((cell + 1) << place_bits);
    return lower + place * (upper - lower);
}

}  // namespace

AmplitudeTable::AmplitudeTable(const spectra::SpectralDensity& density, double lowest, double highest)
    : density_(density), first_(std::bit_cast<std::uint64_t>(lowest) >> place_bits) {
    constexpr double tolerance = 1e-6;
    const std::uint64_t last = std::bit_cast<std::uint64_t>(highest) >> place_bits;
    cells_.reserve(last - first_ + 1);
    double left = exact(number_at(first_, 0.0));
    for (std::uint64_t cell = first_; cell <= last; ++cell) {
        const double middle = exact(number_at(cell, 0.5)), right = exact(number_at(cell, 1.0));
        const Cell parabola{left, -3.0 * left + 4.0 * middle - right, 2.0 * (left - 2.0 * middle + right)};
        const auto misses = [&](double place) {
            const double value = parabola.value + place * (parabola.linear + place * parabola.square);
            return std::abs(value - exact(number_at(cell, place))) > tolerance * std::min(left, right);
        };
        cells_.push_back(misses(0.25) || misses(0.75) ? Cell{undefined, 0.0, 0.0} : parabola);
        left = right;
    }
}

double AmplitudeTable::operator()(double squared_wavevector) const {
    const auto bits = std::bit_cast<std::uint64_t>(squared_wavevector);
    const Cell& cell = cells_[(bits >> place_bits) - first_];
    constexpr std::uint64_t place_mask = (std::uint64_t{1} << place_bits) - 1;
    const double place = std::bit_cast<double>(0x3ff0000000000000 | (bits & place_mask) << (52 - place_bits)) - 1.0;
    const double value = cell.value + place * (cell.linear + place * cell.square);
    return std::isnan(value) ? exact(squared_wavevector) : value;
}

double AmplitudeTable::exact(double squared_wavevector) const {
    const double wavevector = std::sqrt(squared_wavevector), power = density_(wavevector);
    if (!(power >= 0.0) || std::isinf(power))
        throw InvalidArgument(
            fmt::format("the power spectrum is {} at {} 1/m; expected a finite number >= 0", power, wavevector));
    return std::sqrt(power);
}

}  // namespace setae::synthesis
