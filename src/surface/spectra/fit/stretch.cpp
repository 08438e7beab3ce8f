// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/LU>

#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/spectra/isotropic.hpp"
#include "setae/spectra/parametric_noise.hpp"

namespace setae::spectral_fit {
namespace {

constexpr double annulus_width = 0.1, scale_width = 0.5;  // decades
constexpr int sectors = 24;                               // of 180°

Eigen::Vector2d axis(double angle) { return {std::cos(2.0 * angle), std::sin(2.0 * angle)}; }

double sinh_over(double x) { return x < 1e-4 ? 1.0 + x * x / 6.0 : std::sinh(x) / x; }

/// Waves of an annulus by their direction.
struct Annulus {
    double wavevector = 0.0, exponent = 0.0;
    double power[sectors] = {}, count[sectors] = {};

    [[nodiscard]] double members() const {
        double sum = 0.0;
        for (const double n : count) sum += n;
        return sum;
    }
    [[nodiscard]] double mean_power() const {
        double sum = 0.0;
        for (const double p : power) sum += p;
        return sum / members();
    }
};

double sector_angle(int sector) { return pi * (sector + 0.5) / sectors; }

/// Sums over half of the plane of q; counts are those of independent waves.
std::vector<Annulus> annuli_of(const topography::HeightMap& map, const Band& band, parallel::Threads threads) {
    constexpr Index of_lines = 2;  // wavevectors along the lines affected by offsets and trends of lines
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const Array2D C2D = spectra::power_spectrum_map(
        map, {.window = spectra::Window::hann, .trend = topography::Trend::tilt, .threads = threads});
    const double dqx = 2.0 * pi / map.size[0], dqy = 2.0 * pi / map.size[1];
    const double decades = std::log10(band.upper / band.lower);
    std::vector<Annulus> annuli(static_cast<std::size_t>(std::max(0.0, std::floor(decades / annulus_width))));
    for (Index k = 0; k < nx; ++k) {
        const Index kx = 2 * k > nx ? k - nx : k;
        if (std::abs(kx) <= of_lines) continue;
        for (Index m = 0; 2 * m <= ny; ++m) {
            if (m == 0 && kx < 0) continue;
            const double qx = static_cast<double>(kx) * dqx, qy = static_cast<double>(m) * dqy, q = std::hypot(qx, qy);
            const double place = std::log10(q / band.lower) / annulus_width;
            if (place < 0.0 || place >= static_cast<double>(annuli.size())) continue;
            auto& annulus = annuli[static_cast<std::size_t>(place)];
            const auto sector = static_cast<std::size_t>(std::min(std::atan2(qy, qx) / pi, 1.0 - 1e-12) * sectors);
            annulus.power[sector] += C2D(k, m);
            annulus.count[sector] += 1.0;
        }
    }
    for (std::size_t a = 0; a < annuli.size(); ++a)
        annuli[a].wavevector = band.lower * std::pow(10.0, annulus_width * (static_cast<double>(a) + 0.5));
    return annuli;
}

/// Keeps those with power above the noise, with their local exponents; one at each end is used for the exponent.
std::vector<Annulus> usable(const std::vector<Annulus>& annuli) {
    constexpr double above_noise = 20.0;
    double least = 0.0;
    for (const auto& annulus : annuli)
        if (annulus.members() > 0.0) least = least > 0.0 ? std::min(least, annulus.mean_power()) : annulus.mean_power();
    std::vector<Annulus> found;
    for (std::size_t a = 1; a + 1 < annuli.size(); ++a) {
        auto annulus = annuli[a];
        const auto &before = annuli[a - 1], &after = annuli[a + 1];
        if (!(annulus.members() > sectors) || !(before.members() > 0.0) || !(after.members() > 0.0)) continue;
        if (!(annulus.mean_power() > above_noise * least)) continue;
        annulus.exponent =
            -std::log(after.mean_power() / before.mean_power()) / std::log(after.wavevector / before.wavevector);
        found.push_back(annulus);
    }
    return found;
}

struct Score {
    Eigen::Vector2d score = Eigen::Vector2d::Zero();
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    double chi_squared = 0.0;
    int cells = 0;
};

/// ∂ ln m²/∂vector by central differences.
Eigen::Vector2d slope_of_log_square(const Stretch& stretch, double angle) {
    constexpr double step = 1e-5;
    Eigen::Vector2d slope;
    for (Index i = 0; i < 2; ++i) {
        Stretch more = stretch, less = stretch;
        more.vector[i] += step;
        less.vector[i] -= step;
        slope[i] = std::log(more.wave_square(angle) / less.wave_square(angle)) / (2.0 * step);
    }
    return slope;
}

/// Score of an annulus at its best amplitude.
void add_score(const Annulus& annulus, const Stretch& stretch, double share, Score& sum) {
    double weight = 0.0, power = 0.0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    double scaled[sectors] = {};
    Eigen::Vector2d slope[sectors];
    for (int s = 0; s < sectors; ++s) {
        if (!(annulus.count[s] > 0.0)) continue;
        const double angle = sector_angle(s);
        scaled[s] = annulus.power[s] * std::pow(stretch.wave_square(angle), 0.5 * annulus.exponent);
        slope[s] = -0.5 * annulus.exponent * slope_of_log_square(stretch, angle);
        weight += annulus.count[s];
        power += scaled[s];
        mean += annulus.count[s] * slope[s];
    }
    mean /= weight;
    for (int s = 0; s < sectors; ++s) {
        if (!(annulus.count[s] > 0.0)) continue;
        const double n = share * annulus.count[s], residual = scaled[s] / annulus.count[s] * weight / power - 1.0;
        const Eigen::Vector2d away = slope[s] - mean;
        sum.score += n * residual * away;
        sum.information += n * away * away.transpose();
        sum.chi_squared += n * residual * residual;
        ++sum.cells;
    }
    --sum.cells;
}

/// Fit of several annuli.
ObservedStretch fitted(const std::vector<Annulus>& annuli) {
    constexpr int max_rounds = 30;
    constexpr double longest_step = 0.5, small_step = 1e-6;
    const double share = std::pow(spectra::share_under_hann, 2);
    ObservedStretch result;
    double log_wavevector = 0.0;
    for (const auto& annulus : annuli)
        log_wavevector += std::log(annulus.wavevector) / static_cast<double>(annuli.size());
    result.wavevector = std::exp(log_wavevector);
    for (int round = 0; round < max_rounds; ++round) {
        Score sum;
        for (const auto& annulus : annuli) add_score(annulus, result.stretch, share, sum);
        if (!(sum.information.determinant() > 1e-12 * std::pow(sum.information.trace(), 2))) return result;
        Eigen::Vector2d step = sum.information.inverse() * sum.score;
        if (step.norm() > longest_step) step *= longest_step / step.norm();
        result.stretch.vector += step;
        const double scatter = sum.chi_squared / std::max(1.0, static_cast<double>(sum.cells - 2));
        result.information = sum.information / std::max(1.0, scatter);
        if (step.norm() < small_step) break;
    }
    return result;
}

/// Weighted mean of vectors, the sum of their information, and χ² about the mean.
struct Mean {
    Eigen::Vector2d vector = Eigen::Vector2d::Zero();
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    double chi_squared = 0.0;
    int degrees = 0;
};

Mean mean_of(const std::vector<ObservedStretch>& observed) {
    Mean mean;
    Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
    for (const auto& o : observed) {
        mean.information += o.information;
        weighted += o.information * o.stretch.vector;
    }
    mean.vector = mean.information.inverse() * weighted;
    for (const auto& o : observed) {
        const Eigen::Vector2d away = o.stretch.vector - mean.vector;
        mean.chi_squared += away.dot(o.information * away);
    }
    mean.degrees = 2 * static_cast<int>(observed.size()) - 2;
    if (mean.degrees > 0) mean.information /= std::max(1.0, mean.chi_squared / mean.degrees);
    return mean;
}

/// Whether such a stretch is improbable by chance, and large enough.
bool evident(const Mean& mean) {
    constexpr double significant = 0.01, min_stretch = 1.05;
    return chi_squared_exceedance(mean.vector.dot(mean.information * mean.vector), 2.0) < significant &&
           Stretch{mean.vector}.ratio() > min_stretch;
}

/// One knot per decade with data of maps; empty if none is significantly stretched.
StretchOfMaps by_decade(const std::vector<ObservedStretch>& observed, double constancy) {
    std::map<int, std::vector<ObservedStretch>> decades;
    for (const auto& o : observed) decades[static_cast<int>(std::floor(std::log10(o.wavevector)))].push_back(o);
    std::vector<double> log_wavevector;
    std::vector<Eigen::Vector2d> vectors;
    bool stretched = false;
    StretchOfMaps result{{}, Eigen::MatrixXd::Zero(2 * std::ssize(decades), 2 * std::ssize(decades)), constancy};
    for (const auto& [decade, own] : decades) {
        const auto mean = mean_of(own);
        stretched = stretched || evident(mean);
        result.information.block<2, 2>(2 * std::ssize(vectors), 2 * std::ssize(vectors)) = mean.information;
        double place = 0.0;
        for (const auto& o : own) place += std::log(o.wavevector) / static_cast<double>(own.size());
        log_wavevector.push_back(place);
        vectors.push_back(mean.vector);
    }
    if (!stretched) return {{}, {}, constancy};
    result.law = StretchLaw(std::move(log_wavevector), std::move(vectors));
    return result;
}

}  // namespace

double Stretch::ratio() const { return std::exp(vector.norm()); }

double Stretch::direction() const { return 0.5 * std::atan2(vector[1], vector[0]); }

double Stretch::wave_square(double angle) const {
    const double size = vector.norm();
    return std::cosh(size) + sinh_over(size) * vector.dot(axis(angle));
}

double Stretch::length_square(double angle) const {
    const double size = vector.norm();
    return std::cosh(size) - sinh_over(size) * vector.dot(axis(angle));
}

StretchLaw::StretchLaw(std::vector<double> log_wavevector, std::vector<Eigen::Vector2d> vectors)
    : log_wavevector_(std::move(log_wavevector)), vectors_(std::move(vectors)) {}

Stretch StretchLaw::at(double wavevector) const {
    if (isotropic()) return {};
    const double place = std::log(wavevector);
    const auto next = std::upper_bound(log_wavevector_.begin(), log_wavevector_.end(), place) - log_wavevector_.begin();
    const auto after = static_cast<std::size_t>(next);
    if (after == 0) return {vectors_.front()};
    if (after == vectors_.size()) return {vectors_.back()};
    const double share = (place - log_wavevector_[after - 1]) / (log_wavevector_[after] - log_wavevector_[after - 1]);
    return {(1.0 - share) * vectors_[after - 1] + share * vectors_[after]};
}

Eigen::VectorXd StretchLaw::values() const {
    Eigen::VectorXd all(2 * knots());
    for (Index k = 0; k < knots(); ++k) all.segment<2>(2 * k) = vectors_[static_cast<std::size_t>(k)];
    return all;
}

StretchLaw StretchLaw::with(const Eigen::VectorXd& values) const {
    StretchLaw other = *this;
    for (Index k = 0; k < knots(); ++k) other.vectors_[static_cast<std::size_t>(k)] = values.segment<2>(2 * k);
    return other;
}

std::vector<ObservedStretch> observed_stretch(const topography::HeightMap& map, const Band& band,
                                              parallel::Threads threads) {
    constexpr double min_periods = 8.0, of_nyquist = 0.5;
    constexpr Index min_points = 32;
    if (std::min(map.heights.rows(), map.heights.cols()) < min_points || map.heights.isNaN().any()) return {};
    const auto pixel = map.pixel_size();
    const Band used{std::max(band.lower, min_periods * 2.0 * pi / std::min(map.size[0], map.size[1])),
                    std::min(band.upper, of_nyquist * pi / std::max(pixel[0], pixel[1]))};
    if (!(used.upper > used.lower)) return {};
    std::map<int, std::vector<Annulus>> scales;
    for (const auto& annulus : usable(annuli_of(map, used, threads)))
        scales[static_cast<int>(std::floor(std::log10(annulus.wavevector) / scale_width))].push_back(annulus);
    std::vector<ObservedStretch> found;
    for (const auto& [scale, annuli] : scales) {
        const auto one = fitted(annuli);
        if (one.information.trace() > 0.0) found.push_back(one);
    }
    return found;
}

StretchOfMaps combined_stretch(const std::vector<ObservedStretch>& observed) {
    constexpr double inconstant = 0.001;
    if (observed.empty()) return {};
    const auto mean = mean_of(observed);
    const double constancy = mean.degrees > 0 ? chi_squared_exceedance(mean.chi_squared, mean.degrees) : 1.0;
    if (constancy < inconstant) return by_decade(observed, constancy);
    if (!evident(mean)) return {{}, {}, constancy};
    double place = 0.0;
    for (const auto& o : observed) place += std::log(o.wavevector) / static_cast<double>(observed.size());
    return {StretchLaw({place}, {mean.vector}), mean.information, constancy};
}

}  // namespace setae::spectral_fit
