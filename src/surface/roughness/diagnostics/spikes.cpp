// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "evidence.hpp"
#include "scan_spectrum.hpp"
#include "setae/core/constants.hpp"

namespace setae::diagnostics {
namespace {

/// Means of both spectra over windows of a tenth of their modes: ratio of the two.
struct Lift {
    double factor = 1.0;      ///< at the shortest wavelengths
    double wavelength = 0.0;  ///< below which the factor exceeds 2 [m]; 0 if it never does
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

/// Rms height [m] and rms slope along x of the unmodified heights.
struct Seen {
    double rms, slope;
};

Seen seen(const Evidence& evidence) {
    const auto& heights = evidence.heights.heights;
    return {rms_height(heights), rms_slope_along_x(heights, evidence.heights.pixel_size()[0])};
}

/// Restores the spikes in the heights, or removes them again.
void exchange_spikes(Evidence& evidence) {
    for (auto& [point, height] : evidence.at_spikes) std::swap(evidence.heights.heights.data()[point], height);
}

}  // namespace

Found spikes(Evidence& evidence, parallel::Threads threads) {
    if (!evidence.spikes) return {};
    const auto& found = *evidence.spikes;
    const auto without = seen(evidence);
    exchange_spikes(evidence);
    const auto with = seen(evidence);
    const auto spectrum_with = scan_spectrum(evidence.heights, threads);
    exchange_spikes(evidence);
    const double rms_with = with.rms, rms_without = without.rms, slope_with = with.slope, slope_without = without.slope;
    const auto [factor, wavelength] = lift(spectrum_with, *evidence.scan_spectrum);
    const std::string psd =
        wavelength > 0.0
            ? fmt::format(
                  "C1D with the spikes is {:.2g} times C1D without them at the shortest wavelengths, and more "
                  "than twice below {}",
                  factor, length_text(wavelength))
            : fmt::format("C1D with the spikes is {:.3g} times C1D without them at the shortest wavelengths", factor);
    return Finding{
        {"SPIKES", evidence.subject,
         fmt::format("{} {} from the local median by more than {}: {}; the rms height is {} instead of {}, the rms "
                     "slope along x {:.3g} instead of {:.3g}",
                     found.count, found.count == 1 ? "spike deviates" : "spikes deviate", length_text(found.threshold),
                     psd, length_text(rms_with), length_text(rms_without), slope_with, slope_without),
         "look at the spikes; remove them (step despike) if they come from the instrument"},
        {effect_count("spikes", found.count), effect("spike_threshold", "", found.threshold, "m"),
         effect("psd_factor", "", factor, "1"),
         effect("psd_lifted_below_wavelength", "", wavelength > 0.0 ? wavelength : undefined, "m"),
         effect("rms_height_with_spikes", "h_rms", rms_with, "m"),
         effect("rms_height_without_spikes", "h_rms", rms_without, "m"),
         effect("rms_slope_x_with_spikes", "", slope_with, "1"),
         effect("rms_slope_x_without_spikes", "", slope_without, "1")}};
}

}  // namespace setae::diagnostics
