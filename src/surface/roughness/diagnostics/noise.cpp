// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "evidence.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/spectra/parametric_noise.hpp"
#include "white_floor.hpp"

namespace setae::diagnostics {

Found pixel_noise(const Evidence& evidence, const DiagnosisOptions& options) {
    const auto& map = evidence.heights;
    const Index points = map.heights.rows(), modes = (points - 1) / 2, lines = map.heights.cols();
    const Index first = std::max<Index>(4, points / 16), count = modes - first + 1;
    constexpr Index min_modes = 12;
    if (count < min_modes) return {};
    const auto& spectrum = *evidence.scan_spectrum;
    const double step = map.pixel_size()[0], nyquist = pi / step;
    const Array1D x = spectrum.wavevector.segment(first - 1, count) / nyquist,
                  power = spectrum.density.segment(first - 1, count);
    if (!(power.minCoeff() > 0.0)) return {};
    const double share = map.periodic ? 1.0 : spectra::share_under_hann;
    // lines of the surface are correlated over a few pixels; those of the noise are independent
    const double cautious = share * std::max(1.0, 0.5 * static_cast<double>(lines));
    const auto floor = white_floor(x, power, share * static_cast<double>(lines), cautious);
    if (!(floor.level > floor.surface_at_end) || !(floor.gain > 0.0) ||
        chi_squared_exceedance(2.0 * cautious * floor.gain, 1.0) > options.false_alarm)
        return {};
    const double sigma = std::sqrt(floor.level / step), sigma_error = 0.5 * sigma * floor.level_error / floor.level;
    const double slope = evidence.rms_slope_x ? *evidence.rms_slope_x : rms_slope_along_x(map.heights, step),
                 noise_slope2 = 2.0 * sigma * sigma / (step * step);
    const double slope_share = std::min(1.0, noise_slope2 / (slope * slope));
    const double wavelength = 2.0 * step * std::pow(floor.level / floor.amplitude, 1.0 / floor.exponent);
    const double rms = clean_rms_height(evidence), cleaner = slope * std::sqrt(std::max(0.0, 1.0 - slope_share));
    return Finding{
        {"PIXEL_NOISE", evidence.subject,
         fmt::format("C1D ends in a white floor of {:.3g} m3, a noise of {} rms that is independent from point to "
                     "point; this noise dominates below {} and makes up {:.2g} % of the mean square slope along x "
                     "(rms slope {:.3g}, without noise {:.3g})",
                     floor.level, length_text(sigma), length_text(wavelength), 100.0 * slope_share, slope, cleaner),
         "end spectra and parameters of slope and curvature above this wavelength, or measure more "
         "slowly and average more"},
        {effect("noise_rms_height", "", sigma, "m", sigma_error),
         effect("noise_floor", "C1D", floor.level, "m3", floor.level_error),
         effect("noise_dominates_below_wavelength", "", wavelength, "m"),
         effect("noise_share_of_mean_square_slope", "", slope_share, "1",
                slope_share * floor.level_error / floor.level),
         effect("noise_share_of_mean_square_height", "", std::min(1.0, sigma * sigma / (rms * rms)), "1")}};
}

}  // namespace setae::diagnostics
