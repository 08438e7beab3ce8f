// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "evidence.hpp"
#include "scan_spectrum.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/spectra/parametric_noise.hpp"
#include "setae/spectra/reliability.hpp"

namespace setae::diagnostics {
namespace {

/// Exponent p of C1D ∝ q^−p with its standard error, by the likelihood of gamma variates.
struct Slope {
    double exponent = 0.0, standard_error = 0.0;
};

Slope fitted_slope(const Array1D& mode, const Array1D& power, const Array1D& freedom, bool hann) {
    const auto loss = [&](double p) {
        const Array1D s = mode.unaryExpr([&](double k) { return std::pow(k, -p) * window_gain(k, p, hann); });
        const double amplitude = (freedom * power / s).sum() / freedom.sum();
        return (freedom * (amplitude * s).log()).sum() + freedom.sum();
    };
    constexpr double lowest = -2.0, highest = 7.0, step = 0.01;
    double best = lowest, least = loss(lowest);
    for (double p = lowest + step; p <= highest; p += step)
        if (const double at = loss(p); at < least) best = p, least = at;
    const double weight = freedom.sum(), mean = (freedom * mode.log()).sum() / weight;
    return {best, 1.0 / std::sqrt((freedom * (mode.log() - mean).square()).sum())};
}

/// The upper end of the band of a measurement limited only by its steps [1/m].
double upper_without_instrument(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) {
        auto bands = topography::tiled(*map);  // no copy of the heights
        bands.metadata.instrument = {};
        return spectra::reliable_band(bands, bands.ny, {}).band.upper;
    }
    auto sharp = measurement;
    topography::metadata(sharp).instrument = {};
    return spectra::reliable_band(sharp).band.upper;
}

}  // namespace

Found tip_cutoff(const topography::Measurement& measurement, parallel::Threads threads) {
    const auto& instrument = topography::metadata(measurement).instrument;
    if (!instrument.tip_radius) return {};
    const auto band = spectra::reliable_band(measurement, {}, threads);
    for (const auto& alert : band.alerts) {
        if (alert.code != "TIP_CUTOFF") continue;
        const double nyquist = upper_without_instrument(measurement);
        const double decades =
            band.empty() ? std::log10(nyquist / band.band.lower) : std::log10(nyquist / band.band.upper);
        auto cutoff = effect("tip_cutoff_wavelength", "l_c", band.tip->value, "m");
        cutoff.estimate.interval = band.tip->interval;
        return Finding{alert,
                       {cutoff, effect("band_lost", "", decades, "decades"),
                        effect("tip_radius", "R", *instrument.tip_radius, "m")}};
    }
    return {};
}

Found low_wavevector_gap(const Evidence& evidence, const DiagnosisOptions& options) {
    const auto& map = evidence.heights;
    constexpr Index first = 2, last = 8, all_modes_needed = 32;  // detrending removes most of the first mode
    if (map.periodic || map.heights.rows() / 2 < all_modes_needed) return {};
    const auto& spectrum = *evidence.scan_spectrum;
    const Index count = last - first + 1;
    const Array1D mode = Array1D::LinSpaced(count, static_cast<double>(first), static_cast<double>(last)),
                  power = spectrum.density.segment(first - 1, count);
    if (!(power.minCoeff() > 0.0)) return {};
    // lines of a map are correlated over about half a wavelength
    const Array1D lines =
        (2.0 * mode * map.size[1] / map.size[0]).max(1.0).min(static_cast<double>(map.heights.cols()));
    const auto slope = fitted_slope(mode, power, spectra::share_under_hann * lines, true);
    // C1D steeper than 1/q: the rms height depends on the longest waves and grows with the size of the scan
    const double certain = normal_quantile(1.0 - options.false_alarm);
    if (!(slope.exponent - certain * slope.standard_error > 1.0)) return {};
    const double growth = std::pow(10.0, 0.5 * (slope.exponent - 1.0)),
                 growth_error = 0.5 * std::log(10.0) * slope.standard_error * growth;
    const double rms = evidence.form.rms_level, longest = map.size[0];
    return Finding{
        {"LOW_Q_GAP", evidence.subject,
         fmt::format("C1D still rises as q^-{:.2f} towards the longest wavelength, {}: most of the rms height, {}, "
                     "comes from there; a scan ten times as long would show {:.2g} times this rms height (standard "
                     "error {:.2g}) if the rise continues",
                     slope.exponent, length_text(longest), length_text(rms), growth, growth_error),
         "give the rms height together with the scan size, or measure larger scans until C1D becomes "
         "flat"},
        {effect("lowest_slope_of_C1D", "", slope.exponent, "1", slope.standard_error),
         effect("rms_height_growth_per_decade", "", growth, "1", growth_error),
         effect("missing_share_of_mean_square_height", "", 1.0 - 1.0 / (growth * growth), "1",
                2.0 * growth_error / (growth * growth * growth)),
         effect("longest_wavelength", "", longest, "m")}};
}

}  // namespace setae::diagnostics
