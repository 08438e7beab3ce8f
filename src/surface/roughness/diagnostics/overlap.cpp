// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>

#include "evidence.hpp"
#include "options.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/spectra/combination.hpp"
#include "setae/spectra/parametric_noise.hpp"

namespace setae::diagnostics {
namespace {

using topography::Measurement;

/// A spectrum of a measurement in bins, with the number of independent values per bin.
struct Binned {
    std::string subject;
    spectra::MeasuredSpectrum spectrum;
};

Binned binned(const Measurement& measurement, const DiagnosisOptions& options) {
    spectra::SpectrumOptions settings;
    settings.trend = topography::Trend::tilt;
    settings.reliability.first_mode = 3;
    settings.reliability.nyquist_fraction = 0.5;
    settings.threads = options.threads;
    return {topography::label(topography::metadata(measurement)), spectra::power_spectrum(measurement, settings)};
}

/// ν of a bin: modes times independent lines (correlation over half a wavelength) times the independent share of a
/// mode.
double freedom(const spectra::MeasuredSpectrum& spectrum, const spectra::LogGrid& grid, Index bin) {
    double sum = 0.0;
    for (Index k = 0; k < spectrum.wavevector.size(); ++k) {
        const double q = spectrum.wavevector[k];
        if (q < spectrum.band.lower * (1.0 - 1e-9) || q > spectrum.band.upper || grid.bin_of(q) != bin) continue;
        const double width = spectrum.count[k] * spectrum.pitch;
        sum += std::clamp(q * width / pi, 1.0, std::max(1.0, spectrum.count[k]));
    }
    return spectra::share_under_hann * sum;
}

/// ln(C_a/C_b) = mean + tilt (ln q − centre), fitted over shared bins.
struct Comparison {
    double centre = 0.0, mean = 0.0, mean_error = 0.0, tilt = 0.0, tilt_error = 0.0;
    double lower = 0.0, upper = 0.0;  ///< wavevectors of the shared bins [1/m]
    int bins = 0;
};

Comparison compared(const Binned& a, const Binned& b) {
    const std::array<spectra::MeasuredSpectrum, 2> both{a.spectrum, b.spectrum};
    Comparison result;
    for (const auto& spectrum : both)
        if (!(spectrum.band.upper > spectrum.band.lower)) return result;  // nothing reliable
    const auto bins = spectra::binned(both);
    std::vector<std::array<double, 3>> points;  // ln q, ln ratio, weight
    for (Index k = 0; k < bins.wavevector.size(); ++k) {
        if (!(bins.C1D(0, k) > 0.0 && bins.C1D(1, k) > 0.0)) continue;
        const double nu_a = freedom(both[0], bins.grid, bins.first_bin + k),
                     nu_b = freedom(both[1], bins.grid, bins.first_bin + k);
        if (!(nu_a > 0.0 && nu_b > 0.0)) continue;
        // mean and variance of the logarithm of a gamma variate of mean 1
        const double bias = boost::math::digamma(nu_a) - std::log(nu_a) - boost::math::digamma(nu_b) + std::log(nu_b);
        const double variance = boost::math::trigamma(nu_a) + boost::math::trigamma(nu_b);
        points.push_back(
            {std::log(bins.wavevector[k]), std::log(bins.C1D(0, k) / bins.C1D(1, k)) - bias, 1.0 / variance});
    }
    result.bins = static_cast<int>(points.size());
    if (points.size() < 2) return result;
    result.lower = std::exp(points.front()[0]);
    result.upper = std::exp(points.back()[0]);
    double weight = 0.0, sxx = 0.0, sxy = 0.0;
    for (const auto& [x, y, w] : points) {
        weight += w;
        result.centre += w * x;
        result.mean += w * y;
    }
    result.centre /= weight;
    result.mean /= weight;
    for (const auto& [x, y, w] : points) {
        sxx += w * (x - result.centre) * (x - result.centre);
        sxy += w * (x - result.centre) * (y - result.mean);
    }
    result.mean_error = std::sqrt(1.0 / weight);
    result.tilt = sxy / sxx;
    result.tilt_error = std::sqrt(1.0 / sxx);
    return result;
}

void add_findings(std::vector<Finding>& findings, const Binned& a, const Binned& b, const DiagnosisOptions& options) {
    const auto c = compared(a, b);
    if (c.bins < 2) return;
    const double chi2 = std::pow(c.mean / c.mean_error, 2) + std::pow(c.tilt / c.tilt_error, 2);
    const auto ratio = [&](double q) { return std::exp(c.mean + c.tilt * (std::log(q) - c.centre)); };
    const double largest = std::max(std::abs(std::log(ratio(c.lower))), std::abs(std::log(ratio(c.upper))));
    constexpr double small = 1.3;
    if (chi_squared_exceedance(chi2, 2.0) > options.false_alarm || largest < std::log(small)) return;
    const std::string subject = a.subject + ", " + b.subject;
    const double mean = std::exp(c.mean);
    findings.push_back(
        {{"DISAGREE", subject,
          fmt::format("C1D of the first measurement is {:.3g} times that of the second (standard error {:.2g}) "
                      "between {} and {}: {:.3g} times at the long end, {:.3g} times at the short end",
                      mean, mean * c.mean_error, length_text(2.0 * pi / c.lower), length_text(2.0 * pi / c.upper),
                      ratio(c.lower), ratio(c.upper)),
          "check scale, unit, tip and noise of both measurements before combining them"},
         {effect("psd_ratio", "", mean, "1", mean * c.mean_error),
          effect("psd_ratio_at_longest", "", ratio(c.lower), "1"),
          effect("psd_ratio_at_shortest", "", ratio(c.upper), "1")}});
    // a constant factor over at least a third of a decade indicates a scale error
    constexpr double constant = 3.0, wide = 0.3, plain = 1.5, level = 2.0;
    constexpr int enough_bins = 4;
    const double factor = std::exp(0.5 * c.mean);
    const bool constant_ratio = c.bins >= enough_bins && std::abs(c.tilt) < constant * c.tilt_error &&
                                std::abs(c.tilt) * std::log(c.upper / c.lower) < std::log(level);
    if (!constant_ratio || std::log10(c.upper / c.lower) < wide || std::abs(std::log(factor)) < std::log(plain)) return;
    findings.push_back(
        {{"SCALE_TWICE", subject,
          fmt::format("heights of the first measurement are {:.3g} times those of the second (standard error {:.2g}) "
                      "at all wavelengths that both contain: suspect a height scale applied twice or a wrong unit",
                      factor, 0.5 * factor * c.mean_error),
          "compare the heights with those in the instrument's own program; look for a scale in the file "
          "and for one given in addition"},
         {effect("height_factor", "", factor, "1", 0.5 * factor * c.mean_error)}});
}

}  // namespace

std::vector<Finding> diagnose_overlap(std::span<const Measurement> measurements, const DiagnosisOptions& options) {
    check(options);
    if (measurements.size() < 2)
        throw InvalidArgument(fmt::format("{} measurement to compare; expected at least two", measurements.size()));
    std::vector<Binned> all;
    for (const auto& measurement : measurements) all.push_back(binned(measurement, options));
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j) add_findings(findings, all[i], all[j], options);
    return findings;
}

}  // namespace setae::diagnostics
