// SPDX-License-Identifier: GPL-3.0-or-later
// Data of the fit of a self-affine surface, from combined spectra and from single measurements.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "checks.hpp"
#include "self_affine_model.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/parametric_noise.hpp"
#include "setae/spectra/self_affine_fit.hpp"

namespace setae::spectra {
namespace {

/// n · (SE/C)² of every bin: the relative variance of one measurement, with those of the two bins on either side if few
/// share one.
Array1D relative_variances(const CombinedSpectrum& spectrum) {
    const Index bins = spectrum.wavevector.size();
    Array1D result = Array1D::Constant(bins, undefined);
    for (Index b = 0; b < bins; ++b) {
        double sum = 0.0, freedom = 0.0;
        constexpr Index reach = 2;
        for (Index k = std::max<Index>(0, b - reach); k <= std::min(bins - 1, b + reach); ++k) {
            const double n = spectrum.count[k], relative = spectrum.standard_error[k] / spectrum.density[k];
            if (!(relative > 0.0)) continue;
            sum += (n - 1.0) * n * relative * relative;
            freedom += n - 1.0;
        }
        if (freedom > 0.0) result[b] = sum / freedom;
    }
    return result;
}

/// Modes of one measurement in groups: single ones up to 16, then about 32 per decade.
struct ModeGroup {
    Index first, last;  ///< of the spectrum's wavevectors
};

std::vector<ModeGroup> groups_of(const MeasuredSpectrum& spectrum, double q_max) {
    std::vector<ModeGroup> groups;
    const double fundamental = 2.0 * pi / spectrum.length, ratio = std::pow(10.0, 1.0 / 32.0);
    for (Index k = 0; k < spectrum.wavevector.size();) {
        if (!in_band(spectrum.wavevector[k], spectrum.band.lower, q_max)) {
            ++k;
            continue;
        }
        const double end = std::max(spectrum.wavevector[k] + 0.5 * fundamental,
                                    spectrum.wavevector[k] > 16.0 * fundamental ? spectrum.wavevector[k] * ratio : 0.0);
        Index last = k;
        while (last + 1 < spectrum.wavevector.size() && spectrum.wavevector[last + 1] < end &&
               in_band(spectrum.wavevector[last + 1], spectrum.band.lower, q_max))
            ++last;
        groups.push_back({k, last});
        k = last + 1;
    }
    return groups;
}

/// Expectation of modes: mixing of neighbours by the window, and aliasing by sampling.
class ModeExpectation {
public:
    ModeExpectation(const MeasuredSpectrum& spectrum, std::vector<ModeGroup> groups)
        : groups_(std::move(groups)),
          wavevector_(spectrum.wavevector),
          fundamental_(2.0 * pi / spectrum.length),
          hann_(spectrum.window == "hann") {
        // modes up to n/2 of a scan; the Nyquist wavevector of others is unknown
        const Index modes = wavevector_.size();
        if (std::abs(wavevector_[modes - 1] / (static_cast<double>(modes) * fundamental_) - 1.0) < 1e-6 && modes >= 4)
            sampling_ = 2.0 * wavevector_[modes - 1];
    }

    [[nodiscard]] Array1D operator()(const spectra::SelfAffine& model) const {
        const SelfAffineLines lines(
            model, 0.4 * fundamental_,
            (sampling_ > 0.0 ? (aliases + 0.6) * sampling_ : 1.2 * wavevector_[wavevector_.size() - 1]) + fundamental_);
        Array1D result(static_cast<Index>(groups_.size()));
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const double first = wavevector_[groups_[g].first], last = wavevector_[groups_[g].last],
                         middle = 0.5 * (first + last);
            result[static_cast<Index>(g)] =
                groups_[g].first == groups_[g].last
                    ? mode(lines, model, first)
                    : (mode(lines, model, first) + 4.0 * mode(lines, model, middle) + mode(lines, model, last)) / 6.0;
        }
        return result;
    }

private:
    static constexpr int aliases = 4;

    [[nodiscard]] double mode(const SelfAffineLines& lines, const spectra::SelfAffine& model, double q) const {
        // |1 at k, −½ next to it|² of Hann, scaled to keep the mean square; below the first mode C1D is that at half of
        // it
        double sum = hann_ ? (2.0 / 3.0) * (lines(q) + 0.25 * (lines(std::max(q - fundamental_, 0.5 * fundamental_)) +
                                                               lines(q + fundamental_)))
                           : lines(q);
        if (sampling_ == 0.0) return sum;
        for (int m = 1; m <= aliases; ++m) sum += lines(m * sampling_ - q) + lines(m * sampling_ + q);
        const double rest = (aliases + 0.5) * sampling_;
        return sum + 2.0 * lines(rest) * rest / (sampling_ * 2.0 * model.hurst_exponent);
    }

    std::vector<ModeGroup> groups_;
    Array1D wavevector_;
    double fundamental_, sampling_ = 0.0;
    bool hann_;
};

}  // namespace

MeasuredSpectrum undistorted(MeasuredSpectrum spectrum) {
    constexpr double first_mode = 8.0, highest = 0.25;
    if (spectrum.wavevector.size() == 0) return spectrum;
    spectrum.band.lower = std::max(spectrum.band.lower, first_mode * 2.0 * pi / spectrum.length);
    spectrum.band.upper = std::min(spectrum.band.upper, highest * spectrum.wavevector[spectrum.wavevector.size() - 1]);
    return spectrum;
}

SelfAffineFit fit_self_affine(const CombinedSpectrum& spectrum, const SelfAffineFitOptions& options) {
    const Array1D variance = relative_variances(spectrum);
    FittedValues data{spectrum.wavevector, spectrum.density, Array1D::Zero(variance.size()), {}};
    for (Index b = 0; b < variance.size(); ++b)
        if (variance[b] > 0.0) data.freedom[b] = spectrum.count[b] / variance[b];
    if (!(data.freedom > 0.0).any())
        throw UndefinedDataError(
            "no bin of the combined spectrum has a standard error; fit the spectrum of the single "
            "measurement, or combine at least two");
    data.expected = [q = spectrum.wavevector](const spectra::SelfAffine& model) {
        return spectra::profile_power_spectrum(model, q);
    };
    return fit_self_affine(std::array<FittedValues, 1>{std::move(data)}, options);
}

namespace {

/// Modes of one measurement up to q_max in groups, and their expectation; empty if none is in its reliable band.
std::optional<FittedValues> values_up_to(double q_max, const MeasuredSpectrum& spectrum) {
    auto groups = groups_of(spectrum, q_max);
    if (groups.empty()) return std::nullopt;
    const auto count = static_cast<Index>(groups.size());
    FittedValues data{Array1D(count), Array1D(count), Array1D(count), {}};
    const double own = spectrum.window == "none" ? 1.0 : share_under_hann;
    for (Index g = 0; g < count; ++g) {
        const auto [first, last] = groups[static_cast<std::size_t>(g)];
        const auto modes = static_cast<double>(last - first + 1);
        data.wavevector[g] = 0.5 * (spectrum.wavevector[first] + spectrum.wavevector[last]);
        data.values[g] = spectrum.density.segment(first, last - first + 1).mean();
        // ∫ρ² dy of lines on a self-affine surface is about 2.5/q
        const double lines = std::clamp(data.wavevector[g] * spectrum.count[first] * spectrum.pitch / 2.5, 1.0,
                                        std::max(1.0, spectrum.count[first]));
        data.freedom[g] = data.values[g] > 0.0 ? own * modes * lines : 0.0;
        if (!(data.values[g] > 0.0)) data.values[g] = 1.0;  // left out
    }
    data.expected = ModeExpectation(spectrum, std::move(groups));
    return data;
}

std::optional<FittedValues> values_of(const MeasuredSpectrum& spectrum, const SelfAffineFitOptions& options) {
    // aliasing by sampling and averaging by the instrument are visible above that; a larger range includes aliases
    return values_up_to(options.range ? spectrum.band.upper : undistorted(spectrum).band.upper, spectrum);
}

/// ln(measured/model) of reliable values on one side of the fit: its mean weighted by ν, and the variance of that.
class Departure {
public:
    void add(double wavevector, double measured, double expected, double freedom) {
        // E ln of a gamma variate with shape ν is below ln of its mean by 1/(2ν) + 1/(12ν²)
        sum_ += freedom * (std::log(measured / expected) + 0.5 / freedom + 1.0 / (12.0 * freedom * freedom));
        freedom_ += freedom;
        log_wavevector_ += freedom * std::log(wavevector);
        lower_ = std::min(lower_, wavevector);
        upper_ = std::max(upper_, wavevector);
        ++count_;
    }

    /// Warns if the values differ from the model by more than chance and more than a quarter.
    void report(SelfAffineFit& fit, const char* side) const {
        if (count_ < 2) return;
        constexpr double errors = 4.0, least = 0.22314355131420976;  // ln 1.25
        const auto model = model_spectrum(fit, Array1D::Constant(1, std::exp(log_wavevector_ / freedom_)));
        const double mean = sum_ / freedom_, relative = model.standard_error[0] / model.density[0],
                     error = std::sqrt(1.0 / freedom_ + relative * relative);
        if (!(std::abs(mean) > least && std::abs(mean) > errors * error)) return;
        fit.alerts.push_back(
            {"MODEL_MISSES_BEYOND", "self-affine fit",
             fmt::format("{} the range fitted, from {:.3g} to {:.3g} 1/m, reliable values of C1D are {:.2g} times the "
                         "model (standard error of the logarithm {:.2g}): the fit holds only within its range",
                         side, lower_, upper_, std::exp(mean), error),
             "fit both ranges separately (fit_range) and compare their H, or limit the reliable band "
             "(tip_radius, resolution)"});
    }

private:
    double sum_ = 0.0, freedom_ = 0.0, log_wavevector_ = 0.0, upper_ = 0.0;
    double lower_ = std::numeric_limits<double>::infinity();
    int count_ = 0;
};

/// Tests values of the reliable bands outside the fit: up to half of the highest wavevector, where aliases are still
/// few, and from the third mode on, unaffected by detrending.
void look_beyond(SelfAffineFit& fit, std::span<const MeasuredSpectrum> spectra) {
    constexpr double highest = 0.5, first_mode = 2.5;
    Departure above, below;
    for (const auto& spectrum : spectra) {
        if (spectrum.wavevector.size() == 0) continue;
        const auto values = values_up_to(
            std::min(spectrum.band.upper, highest * spectrum.wavevector[spectrum.wavevector.size() - 1]), spectrum);
        if (!values) continue;
        const Array1D expected = values->expected(fit.model);
        for (Index g = 0; g < expected.size(); ++g) {
            const double q = values->wavevector[g];
            if (!(values->freedom[g] > 0.0 && expected[g] > 0.0)) continue;
            auto* side = q > fit.range.upper ? &above : q < fit.range.lower ? &below : nullptr;
            if (side == nullptr || q < first_mode * 2.0 * pi / spectrum.length) continue;
            side->add(q, values->values[g], expected[g], values->freedom[g]);
        }
    }
    above.report(fit, "above");
    below.report(fit, "below");
}

/// The combined spectrum of the undistorted parts of the measurements, if every bin of it has a scatter.
std::optional<CombinedSpectrum> combined_with_scatter(std::span<const MeasuredSpectrum> spectra) {
    std::vector<MeasuredSpectrum> parts;
    for (const auto& spectrum : spectra) {
        auto part = undistorted(spectrum);
        if (part.band.upper > part.band.lower) parts.push_back(std::move(part));
    }
    if (parts.size() < 2) return std::nullopt;
    auto combined = combine(parts);
    if (!(relative_variances(combined) > 0.0).all()) return std::nullopt;
    return combined;
}

}  // namespace

SelfAffineFit fit_self_affine(const MeasuredSpectrum& spectrum, const SelfAffineFitOptions& options) {
    return fit_self_affine(std::span(&spectrum, 1), options);
}

namespace {

SelfAffineFit fit_of_all(std::span<const MeasuredSpectrum> spectra, const SelfAffineFitOptions& options) {
    if (spectra.empty()) throw InvalidArgument("no spectrum is given; expected at least one to fit");
    if (const auto combined = combined_with_scatter(spectra)) return fit_self_affine(*combined, options);
    std::vector<FittedValues> data;
    for (const auto& spectrum : spectra)
        if (auto values = values_of(spectrum, options)) data.push_back(std::move(*values));
    if (data.empty())
        throw InvalidArgument(fmt::format("{}: no wavevector lies inside its reliable band",
                                          topography::label(spectra.front().metadata)));
    return fit_self_affine(data, options);
}

}  // namespace

SelfAffineFit fit_self_affine(std::span<const MeasuredSpectrum> spectra, const SelfAffineFitOptions& options) {
    auto fit = fit_of_all(spectra, options);
    // a given range, or a fitted end of the spectrum, excludes values deliberately
    if (!options.range && !options.short_cutoff) look_beyond(fit, spectra);
    return fit;
}

}  // namespace setae::spectra
