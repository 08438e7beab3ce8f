// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "evidence.hpp"
#include "scan_spectrum.hpp"
#include "setae/core/constants.hpp"

namespace setae::diagnostics {
namespace {

/// Means of both spectra over windows of a tenth of their modes: how much one lies above the other.
struct Lift {
    double factor = 1.0;      ///< at the shortest wavelengths
    double wavelength = 0.0;  ///< below which the factor is above 2 [m]; 0 where it never is
};

Lift lift(const spectra::MeasuredSpectrum& with, const spectra::MeasuredSpectrum& without) {
    const Index n = with.density.size(), width = std::max<Index>(4, n / 10);
    const auto ratio = [&](Index first) {
        return with.density.segment(first, width).sum() / without.density.segment(first, width).sum();
    };
    Lift result;
    result.factor = ratio(n - width);
    for (Index first = n - width; first >= 0 && ratio(first) > 2.0; --first)
        result.wavelength = 2.0 * pi / with.wavevector[first];
    return result;
}

}  // namespace

Found spikes(const Evidence& evidence, parallel::Threads threads) {
    if (!evidence.spikes || evidence.spikes->count == 0) return {};
    const auto& found = *evidence.spikes;
    topography::HeightMap with = *evidence.clean;
    for (Index k = 0; k < with.heights.size(); ++k)
        if (found.mask.data()[k] != 0) with.heights.data()[k] = evidence.level->heights.data()[k];
    const double step = with.pixel_size()[0];
    const double rms_with = rms_height(with.heights), rms_without = rms_height(evidence.clean->heights);
    const double slope_with = rms_slope_along_x(with.heights, step),
                 slope_without = rms_slope_along_x(evidence.clean->heights, step);
    const auto [factor, wavelength] = lift(scan_spectrum(with, threads), *evidence.scan_spectrum);
    const std::string psd =
        wavelength > 0.0
            ? fmt::format(
                  "C1D is {:.2g} times what it is without at the shortest wavelengths, and more than twice below {}",
                  factor, length_text(wavelength))
            : fmt::format("C1D is {:.3g} times what it is without at the shortest wavelengths", factor);
    return Finding{
        {"SPIKES", evidence.subject,
         fmt::format(
             "{} {} out of the median around by more than {}: {}; rms height {} instead of {}, rms slope along x {:.3g} instead of {:.3g}",
             found.count, found.count == 1 ? "spike stands" : "spikes stand", length_text(found.threshold), psd,
             length_text(rms_with), length_text(rms_without), slope_with, slope_without),
         "look at them; despike (level with a step despike) where they are the instrument's"},
        {effect_count("spikes", found.count), effect("spike_threshold", "", found.threshold, "m"),
         effect("psd_factor", "", factor, "1"),
         effect("psd_lifted_below_wavelength", "", wavelength > 0.0 ? wavelength : undefined, "m"),
         effect("rms_height_with_spikes", "h_rms", rms_with, "m"),
         effect("rms_height_without_spikes", "h_rms", rms_without, "m"),
         effect("rms_slope_x_with_spikes", "", slope_with, "1"),
         effect("rms_slope_x_without_spikes", "", slope_without, "1")}};
}

}  // namespace setae::diagnostics
