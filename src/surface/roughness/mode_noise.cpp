// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/mode_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>

#include "mode_parts.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/mode_groups.hpp"
#include "setae/spectra/parametric_noise.hpp"

namespace setae::roughness {
namespace {

constexpr std::size_t decade_count = no_decades.size();
using PerDecade = std::array<double, decade_count>;

/// ∫ d(ln q) over the parts of the cell of a mode in each decade, as a share of ln 10.
PerDecade shares_of_decades(const ModePart& part) {
    PerDecade shares{};
    double lower = std::pow(10.0, first_decade);
    for (std::size_t d = 0; d < decade_count; ++d, lower *= 10.0) {
        const double from = std::max(part.left, lower), to = std::min(part.right, 10.0 * lower);
        if (from < to) shares[d] = std::log(to / from) / std::log(10.0);
    }
    return shares;
}

/// Mean and variance of ln G. Neighbouring modes usually have the same shape.
class Logarithm {
public:
    void take(double shape) {
        if (shape == shape_) return;
        shape_ = shape;
        mean_ = boost::math::digamma(shape) - std::log(shape);
        variance_ = boost::math::trigamma(shape);
    }
    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] double variance() const { return variance_; }

private:
    double shape_ = 0.0, mean_ = 0.0, variance_ = 0.0;
};

/// One mode, or a narrow band of modes, with noise from one random number.
struct Drawn {
    std::uint64_t index = 0;  ///< of the first mode
    double shape = 0.0;       ///< of the gamma number G that multiplies all its contributions
    Contribution adds;
    PerDecade shares{};
    /// The mean of ln G over the modes of a band: mean + slope (G − 1) + deviation · normal.
    bool is_band = false;
    double log_mean = 0.0, log_slope = 0.0, log_deviation = 0.0;
};

/// The modes of a band as one.
class Band {
public:
    void add(const ModePart& part, double freedom, const PerDecade& shares) {
        adds_ += part.adds;
        const double energy = part.adds.energy;
        energy2_ += energy * energy / freedom;
        freedom_ += freedom;
        double share = 0.0;
        for (std::size_t d = 0; d < decade_count; ++d) {
            shares_[d] += shares[d];
            share += shares[d];
        }
        logarithm_.take(freedom);
        share_ += share;
        log_mean_ += share * logarithm_.mean();
        log_variance_ += share * share * logarithm_.variance();
        covariance_ += share * energy / freedom;
    }

    [[nodiscard]] Drawn drawn(std::uint64_t index) const {
        Drawn result{.index = index, .adds = adds_, .shares = shares_, .is_band = true};
        const double energy = adds_.energy;
        result.shape = energy2_ > 0.0 ? energy * energy / energy2_ : freedom_;
        if (!(share_ > 0.0)) return result;
        result.log_mean = log_mean_ / share_;
        const double covariance = energy > 0.0 ? covariance_ / (share_ * energy) : 0.0;
        result.log_slope = covariance * result.shape;
        const double rest = log_variance_ / (share_ * share_) - covariance * result.log_slope;
        result.log_deviation = std::sqrt(std::max(0.0, rest));
        return result;
    }

private:
    Contribution adds_;
    PerDecade shares_{};
    double energy2_ = 0.0, freedom_ = 0.0, share_ = 0.0, log_mean_ = 0.0, log_variance_ = 0.0, covariance_ = 0.0;
    Logarithm logarithm_;
};

/// Common data of the replicas of a spectrum.
struct Noise {
    std::vector<Drawn> drawn;
    DecadeMeans measured = no_decades;  ///< decade means of the spectrum
};

/// Collects modes in order: single ones directly, those of a band until the band ends.
class DrawnModes {
public:
    /// first: of each group of modes; see spectra::narrow_groups().
    explicit DrawnModes(std::vector<Index> first) : first_(std::move(first)) {}

    void add(Index index, const ModePart& part, double freedom) {
        if (index >= first_[group_ + 1]) end_band();
        while (first_[group_ + 1] <= index) ++group_;
        const auto shares = shares_of_decades(part);
        if (first_[group_ + 1] - first_[group_] == 1) {
            drawn_.push_back(
                {.index = static_cast<std::uint64_t>(index), .shape = freedom, .adds = part.adds, .shares = shares});
            return;
        }
        if (!band_) {
            band_.emplace();
            band_begin_ = index;
        }
        band_->add(part, freedom, shares);
    }

    [[nodiscard]] std::vector<Drawn> take() {
        end_band();
        return std::move(drawn_);
    }

private:
    void end_band() {
        if (band_) drawn_.push_back(band_->drawn(static_cast<std::uint64_t>(band_begin_)));
        band_.reset();
    }

    std::vector<Index> first_;
    std::size_t group_ = 0;
    std::optional<Band> band_;
    Index band_begin_ = 0;
    std::vector<Drawn> drawn_;
};

Noise noise_of(const spectra::MeasuredSpectrum& spectrum, const ArrayView1D& freedom, const ModeNoiseOptions& options) {
    constexpr double band_ratio = 1.02;
    const auto curve = limited(spectra::within_band(spectrum), options.limits);
    DrawnModes drawn(spectra::narrow_groups(spectrum.wavevector, band_ratio));
    Index index = 0;
    for (const auto& part : mode_parts(curve, options.conversion)) {
        while (spectrum.wavevector[index] != part.wavevector) ++index;
        drawn.add(index, part, freedom[index]);
    }
    return {drawn.take(), curve.kind == spectra::Density::C1D ? decade_means(curve) : no_decades};
}

SpectralParameters replica_of(const Noise& noise, const spectra::NoiseNumbers& random) {
    Contribution sum;
    PerDecade logarithms{};
    for (const auto& drawn : noise.drawn) {
        const double factor = random.gamma(drawn.index, drawn.shape);
        sum += factor * drawn.adds;
        const double logarithm = drawn.is_band ? drawn.log_mean + drawn.log_slope * (factor - 1.0) +
                                                     drawn.log_deviation * random.normal(drawn.index)
                                               : std::log(factor);
        for (std::size_t d = 0; d < decade_count; ++d) logarithms[d] += drawn.shares[d] * logarithm;
    }
    auto parameters = sum.parameters();
    for (std::size_t d = 0; d < decade_count; ++d)
        parameters.decade_C1D[d] = noise.measured[d] * std::exp(logarithms[d]);
    return parameters;
}

}  // namespace

std::vector<SpectralParameters> parameters_of_noise(const spectra::MeasuredSpectrum& spectrum,
                                                    const ArrayView1D& freedom, const ModeNoiseOptions& options) {
    if (spectrum.nodes != spectra::Nodes::modes)
        throw InvalidArgument("noise of single modes needs a spectrum whose nodes are modes");
    if (freedom.size() != spectrum.wavevector.size() || !(freedom > 0.0).all() || options.count < 1)
        throw InvalidArgument(fmt::format(
            "{} replicas of {} modes with {} degrees of freedom, the smallest {}; expected at least one "
            "replica and one number > 0 per mode",
            options.count, spectrum.wavevector.size(), freedom.size(), freedom.size() > 0 ? freedom.minCoeff() : 0.0));
    const auto noise = noise_of(spectrum, freedom, options);
    std::vector<SpectralParameters> replicas(static_cast<std::size_t>(options.count));
    parallel::for_each_index(replicas.size(), options.threads, [&](std::size_t r) {
        replicas[r] = replica_of(noise, spectra::NoiseNumbers(options.seed, r));
    });
    return replicas;
}

}  // namespace setae::roughness
