// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/combination.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "checks.hpp"
#include "combination_mean.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::spectra {
namespace {

std::string instrument_of(const topography::Metadata& metadata) {
    const auto& instrument = metadata.instrument;
    if (!instrument.type.empty()) return instrument.type;
    return instrument.name.empty() ? "unknown" : instrument.name;
}

bool usable(const MeasuredSpectrum& spectrum, Index k) {
    return std::isfinite(spectrum.density[k]) &&
           in_band(spectrum.wavevector[k], spectrum.band.lower, spectrum.band.upper);
}

struct BinRange {
    Index first;
    Index count;
};

BinRange occupied_bins(std::span<const MeasuredSpectrum> spectra, const LogGrid& grid) {
    double least = std::numeric_limits<double>::infinity(), greatest = 0.0;
    for (const auto& spectrum : spectra)
        for (Index k = 0; k < spectrum.wavevector.size(); ++k) {
            if (!usable(spectrum, k)) continue;
            least = std::min(least, spectrum.wavevector[k]);
            greatest = std::max(greatest, spectrum.wavevector[k]);
        }
    if (least > greatest)
        throw InvalidArgument(fmt::format(
            "{} spectra have no value inside their reliable bands, so that nothing can be combined", spectra.size()));
    const Index first = grid.bin_of(least);
    return {first, grid.bin_of(greatest) - first + 1};
}

/// A value of a spectrum, and its bin.
struct BinnedMode {
    Index mode, bin;
};

/// The usable modes of each spectrum.
std::vector<std::vector<BinnedMode>> binned_modes(std::span<const MeasuredSpectrum> spectra,
                                                  const BinnedSpectra& bins) {
    std::vector<std::vector<BinnedMode>> modes;
    for (const auto& spectrum : spectra) {
        auto& own = modes.emplace_back();
        own.reserve(static_cast<std::size_t>(spectrum.wavevector.size()));
        for (Index k = 0; k < spectrum.wavevector.size(); ++k)
            if (usable(spectrum, k)) own.push_back({k, bins.grid.bin_of(spectrum.wavevector[k]) - bins.first_bin});
    }
    return modes;
}

/// Σ_ij |ρ_ij|²/m² of m neighbouring modes: ratio of the variance of their mean to that of one.
double variance_of_mean(const MeasuredSpectrum& spectrum, double modes) {
    if (spectrum.window != name(Window::hann)) return 1.0 / modes;
    constexpr double next = 4.0 / 9.0, next_but_one = 1.0 / 36.0;  // |ρ|² under a Hann window
    return (modes + 2.0 * (modes - 1.0) * next + 2.0 * std::max(0.0, modes - 2.0) * next_but_one) / (modes * modes);
}

/// Averages over bins of C_k (q_c/q_k)^slope, slope by bin.
void fill_bins(std::span<const MeasuredSpectrum> spectra, const std::vector<std::vector<BinnedMode>>& binned,
               const Array1D& slopes, BinnedSpectra& result) {
    const auto members = static_cast<Index>(spectra.size()), bins = result.wavevector.size();
    Array2D modes = Array2D::Zero(members, bins);
    result.C1D = Array2D::Zero(members, bins);
    result.relative_variance = Array2D::Zero(members, bins);
    for (Index i = 0; i < members; ++i) {
        const auto& spectrum = spectra[static_cast<std::size_t>(i)];
        for (const auto& [k, bin] : binned[static_cast<std::size_t>(i)]) {
            result.C1D(i, bin) +=
                spectrum.density[k] * std::pow(spectrum.wavevector[k] / result.wavevector[bin], -slopes[bin]);
            const double relative = spectrum.standard_error[k] / spectrum.density[k];
            // the periodogram of a single line has an exponential distribution: its deviation is its mean
            result.relative_variance(i, bin) += std::isfinite(relative) ? relative * relative : 1.0;
            modes(i, bin) += 1.0;
        }
    }
    result.C1D = (modes > 0.0).select(result.C1D / modes, undefined);
    for (Index i = 0; i < members; ++i)
        for (Index b = 0; b < bins; ++b) {
            auto& variance = result.relative_variance(i, b);
            const double m = modes(i, b);
            variance = m > 0.0 ? variance / m * variance_of_mean(spectra[static_cast<std::size_t>(i)], m) : undefined;
        }
}

/// dlnC/dlnq in every bin: a line through the logarithms of the bins with data within half a decade.
Array1D local_slopes(const BinnedSpectra& binned) {
    const Array1D mean = bin_means(binned, Weighting::equal, all_members(binned));
    const Index bins = mean.size(), reach = std::max(1, binned.grid.bins_per_decade / 2);
    Array1D slopes = Array1D::Zero(bins);
    for (Index b = 0; b < bins; ++b) {
        double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
        for (Index j = std::max<Index>(0, b - reach); j <= std::min(bins - 1, b + reach); ++j) {
            if (!(mean[j] > 0.0)) continue;
            const double x = std::log(binned.wavevector[j] / binned.wavevector[b]), y = std::log(mean[j]);
            n += 1.0;
            sx += x;
            sy += y;
            sxx += x * x;
            sxy += x * y;
        }
        const double spread = n * sxx - sx * sx;
        if (n >= 2.0 && spread > 0.0) slopes[b] = std::clamp((n * sxy - sx * sy) / spread, -6.0, 2.0);
    }
    return slopes;
}

/// Measurements and different instruments in a bin.
struct BinStatistics {
    Index members = 0;
    Index instruments = 0;
};

BinStatistics statistics(const BinnedSpectra& binned, Index bin) {
    BinStatistics result;
    std::vector<std::string> seen;
    for (Index i = 0; i < binned.C1D.rows(); ++i) {
        if (std::isnan(binned.C1D(i, bin))) continue;
        ++result.members;
        seen.push_back(binned.instruments[static_cast<std::size_t>(i)]);
    }
    std::sort(seen.begin(), seen.end());
    result.instruments = std::unique(seen.begin(), seen.end()) - seen.begin();
    return result;
}

double standard_error(const BinnedSpectra& binned, Index bin, Weighting weighting, double mean) {
    const Array1D weights = bin_weights(binned, bin, weighting, all_members(binned));
    const double n = static_cast<double>((weights > 0.0).count());
    if (n < 2.0) return undefined;
    double sum = 0.0;
    for (Index i = 0; i < weights.size(); ++i)
        if (weights[i] > 0.0) sum += std::pow(weights[i] * (binned.C1D(i, bin) - mean), 2);
    return std::sqrt(n / (n - 1.0) * sum) / weights.sum();
}

/// Whether one measurement has values on both sides: then an empty bin is narrower than the spacing of its modes.
bool spanned(const BinnedSpectra& binned, double below, double above) {
    for (Index i = 0; i < binned.C1D.rows(); ++i) {
        const auto has_value = !binned.C1D.row(i).transpose().isNaN();
        if ((has_value && binned.wavevector <= below).any() && (has_value && binned.wavevector >= above).any())
            return true;
    }
    return false;
}

void add_gap_alerts(const BinnedSpectra& binned, CombinedSpectrum& spectrum) {
    const double widest = std::pow(10.0, 1.5 / spectrum.grid.bins_per_decade);
    for (Index b = 1; b < spectrum.wavevector.size(); ++b) {
        const double below = spectrum.wavevector[b - 1], above = spectrum.wavevector[b];
        if (above < widest * below || spanned(binned, below, above)) continue;
        spectrum.alerts.push_back(
            {"COVERAGE_GAP", "combined spectrum",
             fmt::format("no measurement between {:.3g} and {:.3g} 1/m (a factor {:.2g})", below, above, above / below),
             "measure these wavelengths; until then, integrals bridge the gap by a power law"});
    }
}

/// Whole decades inside the coverage, each as its lower exponent of ten.
struct Decades {
    Index lowest, end;
};

Decades whole_decades(const CombinedSpectrum& spectrum) {
    const auto& grid = spectrum.grid;
    const auto n = static_cast<double>(grid.bins_per_decade);
    const auto first = static_cast<double>(grid.bin_of(spectrum.wavevector[0]));
    const auto last = static_cast<double>(grid.bin_of(spectrum.wavevector[spectrum.wavevector.size() - 1]) + 1);
    return {static_cast<Index>(std::ceil(first / n)), static_cast<Index>(std::floor(last / n))};
}

/// Maximum of a count in the bins of a decade.
double max_in_decade(Index decade, const CombinedSpectrum& spectrum, const Array1D& counts) {
    const auto& grid = spectrum.grid;
    const Index n = grid.bins_per_decade;
    double most = 0.0;
    for (Index b = 0; b < spectrum.wavevector.size(); ++b)
        if (spectrum.wavevector[b] > grid.edge(decade * n) && spectrum.wavevector[b] < grid.edge((decade + 1) * n))
            most = std::max(most, counts[b]);
    return most;
}

/// Warns of whole decades without a bin with two instruments, if there are at least two instruments.
void add_single_instrument_alerts(const BinnedSpectra& binned, CombinedSpectrum& spectrum) {
    const auto& instruments = binned.instruments;
    if (std::adjacent_find(instruments.begin(), instruments.end(), std::not_equal_to<>()) == instruments.end()) return;
    const auto decades = whole_decades(spectrum);
    for (Index decade = decades.lowest; decade < decades.end; ++decade)
        if (max_in_decade(decade, spectrum, spectrum.instrument_count) == 1.0)
            spectrum.alerts.push_back(
                {"SINGLE_INSTRUMENT_DECADE", "combined spectrum",
                 fmt::format(
                     "from 1e{} to 1e{} 1/m only one instrument has measured each bin, so that no second instrument "
                     "confirms it",
                     decade, decade + 1),
                 "measure this decade with a second instrument"});
}

/// Warns of whole decades without a bin with two measurements, if there are at least two measurements.
void add_single_measurement_alerts(const BinnedSpectra& binned, CombinedSpectrum& spectrum) {
    if (binned.C1D.rows() < 2) return;
    const auto decades = whole_decades(spectrum);
    for (Index decade = decades.lowest; decade < decades.end; ++decade)
        if (max_in_decade(decade, spectrum, spectrum.count) == 1.0)
            spectrum.alerts.push_back(
                {"SINGLE_MEASUREMENT_DECADE", "combined spectrum",
                 fmt::format(
                     "from 1e{} to 1e{} 1/m each bin has one measurement: its ± is the scatter of the modes of this "
                     "measurement, and the variation between places of the surface is not known",
                     decade, decade + 1),
                 "measure this decade at three places or more"});
}

/// Mean of ln C of an instrument's measurements in a bin and its standard error.
struct LogMean {
    double value;
    double variance;
};

std::map<std::string, LogMean> log_means(const BinnedSpectra& binned, Index bin) {
    std::map<std::string, std::vector<double>> logs;
    for (Index i = 0; i < binned.C1D.rows(); ++i)
        if (binned.C1D(i, bin) > 0.0)
            logs[binned.instruments[static_cast<std::size_t>(i)]].push_back(std::log(binned.C1D(i, bin)));
    std::map<std::string, LogMean> means;
    for (const auto& [instrument, values] : logs) {
        if (values.size() < 2) continue;
        const Eigen::Map<const Array1D> y(values.data(), static_cast<Index>(values.size()));
        const double n = static_cast<double>(values.size());
        means[instrument] = {y.mean(), (y - y.mean()).square().sum() / (n * (n - 1.0))};
    }
    return means;
}

/// Warns of pairs of instruments whose means differ by more than three standard errors in at least half of two or more
/// shared bins.
void add_disagreement_alerts(const BinnedSpectra& binned, CombinedSpectrum& spectrum) {
    struct Comparison {
        int shared = 0, apart = 0;
        double difference = 0.0;
    };
    std::map<std::pair<std::string, std::string>, Comparison> comparisons;
    for (Index bin = 0; bin < binned.wavevector.size(); ++bin) {
        const auto means = log_means(binned, bin);
        for (auto a = means.begin(); a != means.end(); ++a)
            for (auto b = std::next(a); b != means.end(); ++b) {
                auto& comparison = comparisons[{a->first, b->first}];
                const double difference = a->second.value - b->second.value;
                ++comparison.shared;
                comparison.difference += difference;
                constexpr double errors = 3.0;
                if (difference * difference > errors * errors * (a->second.variance + b->second.variance))
                    ++comparison.apart;
            }
    }
    for (const auto& [pair, comparison] : comparisons)
        if (comparison.shared >= 2 && 2 * comparison.apart >= comparison.shared)
            spectrum.alerts.push_back(
                {"DISAGREE", pair.first + ", " + pair.second,
                 fmt::format(
                     "C1D differs by more than three standard errors in {} of {} shared bins; C1D of the first is "
                     "{:.2g} times that of the second",
                     comparison.apart, comparison.shared, std::exp(comparison.difference / comparison.shared)),
                 "check scale, tip and reliable bands of both instruments"});
}

}  // namespace

BinnedSpectra binned(std::span<const MeasuredSpectrum> spectra, const CombinationOptions& options) {
    const auto range = occupied_bins(spectra, options.grid);
    BinnedSpectra result;
    result.grid = options.grid;
    result.first_bin = range.first;
    result.wavevector =
        Array1D::NullaryExpr(range.count, [&](Index b) { return options.grid.centre(range.first + b); });
    for (const auto& spectrum : spectra) result.instruments.push_back(instrument_of(spectrum.metadata));
    const auto modes = binned_modes(spectra, result);
    fill_bins(spectra, modes, Array1D::Zero(range.count), result);
    // slopes and values depend on each other; each round leaves about a seventh of the error
    constexpr int rounds = 4;
    for (int round = 0; round < (options.slope_correction ? rounds : 0); ++round)
        fill_bins(spectra, modes, local_slopes(result), result);
    return result;
}

CombinedSpectrum combine(const BinnedSpectra& spectra, Weighting weighting) {
    const Array1D mean = bin_means(spectra, weighting, all_members(spectra));
    std::vector<Index> filled;
    for (Index b = 0; b < mean.size(); ++b)
        if (!std::isnan(mean[b])) filled.push_back(b);
    const auto count = static_cast<Index>(filled.size());
    CombinedSpectrum result;
    result.grid = spectra.grid;
    result.wavevector = spectra.wavevector(filled);
    result.density = mean(filled);
    result.standard_error.resize(count);
    result.count.resize(count);
    result.instrument_count.resize(count);
    for (Index k = 0; k < count; ++k) {
        const Index bin = filled[static_cast<std::size_t>(k)];
        const auto [members, instruments] = statistics(spectra, bin);
        result.count[k] = static_cast<double>(members);
        result.instrument_count[k] = static_cast<double>(instruments);
        result.standard_error[k] = standard_error(spectra, bin, weighting, mean[bin]);
    }
    result.band.lower = spectra.grid.edge(spectra.first_bin + filled.front());
    result.band.upper = spectra.grid.edge(spectra.first_bin + filled.back() + 1);
    add_gap_alerts(spectra, result);
    add_single_instrument_alerts(spectra, result);
    add_single_measurement_alerts(spectra, result);
    add_disagreement_alerts(spectra, result);
    return result;
}

CombinedSpectrum combine(std::span<const MeasuredSpectrum> spectra, const CombinationOptions& options) {
    auto result = combine(binned(spectra, options), options.weighting);
    result.band.lower = std::numeric_limits<double>::infinity();
    result.band.upper = 0.0;
    for (const auto& spectrum : spectra)
        for (Index k = 0; k < spectrum.wavevector.size(); ++k) {
            if (!usable(spectrum, k)) continue;
            result.band.lower = std::min(result.band.lower, spectrum.wavevector[k]);
            result.band.upper = std::max(result.band.upper, spectrum.wavevector[k]);
        }
    return result;
}

}  // namespace setae::spectra
