// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/tip_response.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/map_transform.hpp"
#include "setae/numerics/dense.hpp"
#include "setae/spectra/abel.hpp"
#include "setae/synthesis/height_transform.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/dilation.hpp"
#include "skewness.hpp"

namespace setae::spectral_fit {
namespace {

constexpr double bins_per_decade = 24.0;
constexpr double amplitude_step = 1.2, size_step = 1.1, skewness_step = 0.2;

/// Error of ln C_added in a band for a single simulated patch: measured on twelve patches.
constexpr double error_of_one_patch = 0.1;

/// Every second pixel along x, every eighth line: the measured points.
constexpr Index stride_x = 2, stride_y = 8;

/// |H(k, m)|² of a real map, k = 1 … nx/2 − 1 down the rows and m = 0 … ny/2 along them, with that of H(−k, m): both
/// signs of the wavevector along y.
Array2D wave_power(const Array2D& heights, parallel::Threads threads) {
    const Index nx = heights.rows(), ny = heights.cols();
    Array2D power(nx / 2 - 1, ny / 2 + 1);
    fourier::transform_map(
        nx, ny, [&](Index i, double* line) { Eigen::Map<Array1D>(line, ny) = heights.row(i).transpose(); },
        [&](const fourier::SpectrumBlock& block) {
            for (Index l = 0; l < block.lines; ++l) {
                const Index m = block.first + l;
                const bool both = m > 0 && 2 * m < ny;
                for (Index k = 1; k < nx / 2; ++k)
                    power(k - 1, m) = std::norm(block.line(l)[k]) + (both ? std::norm(block.line(l)[nx - k]) : 0.0);
            }
        },
        threads);
    return power;
}

/// Heights on the coarse grid, lines along x as columns.
Array2D every_point_read(const topography::HeightMap& surface) {
    return Array2D::NullaryExpr(surface.heights.rows() / stride_x, surface.heights.cols() / stride_y,
                                [&](Index i, Index j) { return surface.heights(i * stride_x, j * stride_y); });
}

/// The highest of the lines over the thickness of a foil, from every eighth line on; the patch is periodic.
Array2D silhouettes(const topography::HeightMap& surface, const Foil& foil, parallel::Threads threads) {
    const Index nx = surface.heights.rows() / stride_x, ny = surface.heights.cols() / stride_y,
                width = surface.heights.cols();
    const auto lines =
        std::min(width, static_cast<Index>(std::floor(foil.thickness / surface.pixel_size()[1] + 1e-9)) + 1);
    Array2D readings(nx, ny);
    parallel::for_each_index(static_cast<std::size_t>(nx), threads, [&](std::size_t i) {
        const double* row = surface.heights.data() + static_cast<Index>(i) * stride_x * width;
        for (Index j = 0; j < ny; ++j) {
            double highest = row[j * stride_y];
            for (Index l = 1; l < lines; ++l) highest = std::max(highest, row[(j * stride_y + l) % width]);
            readings(static_cast<Index>(i), j) = highest;
        }
    });
    return readings;
}

/// Readings of the probe there, line after line: each point starts from the contact of its neighbour.
Array2D read(const topography::HeightMap& surface, const Probe& probe, parallel::Threads threads) {
    if (const auto* foil = std::get_if<Foil>(&probe.shape)) return silhouettes(surface, *foil, threads);
    const auto& tip = std::get<topography::Tip>(probe.shape);
    const Index nx = surface.heights.rows() / stride_x, ny = surface.heights.cols() / stride_y;
    const auto [step_x, step_y] = surface.pixel_size();
    Array1D x(nx * ny), y(nx * ny);
    for (Index k = 0; k < x.size(); ++k) {
        const Index row = k / nx, column = k % nx;
        x[k] = static_cast<double>(column * stride_x) * step_x;
        y[k] = static_cast<double>(row * stride_y) * step_y;
    }
    const Array1D readings = topography::dilated_at(surface, tip, x, y, {.threads = threads});
    return Eigen::Map<const Array2D>(readings.data(), ny, nx).transpose();
}

struct Bins {
    explicit Bins(Index modes) {
        for (Index k = 1; k <= modes; ++k) {
            const auto bin =
                static_cast<Index>(std::floor(bins_per_decade * std::log10(static_cast<double>(k)) + 1e-9));
            if (first.empty() || bin != last_bin) first.push_back(k);
            last_bin = bin;
        }
        first.push_back(modes + 1);
    }
    [[nodiscard]] Index size() const { return static_cast<Index>(first.size()) - 1; }
    [[nodiscard]] Array1D sums(const Array1D& values) const {
        Array1D result(size());
        for (Index b = 0; b < size(); ++b) result[b] = values.segment(first[b] - 1, first[b + 1] - first[b]).sum();
        return result;
    }
    [[nodiscard]] double modes(Index b) const { return static_cast<double>(first[b + 1] - first[b]); }
    /// The bin of a mode, integer or not.
    [[nodiscard]] Index of(double mode) const {
        const auto above = std::upper_bound(first.begin(), first.end(), static_cast<Index>(mode + 1e-9));
        return static_cast<Index>(above - first.begin()) - 1;
    }
    [[nodiscard]] Index highest() const { return first.back() - 1; }
    /// First and last mode of a bin.
    [[nodiscard]] std::pair<double, double> ends(Index b) const {
        return {static_cast<double>(first[b]), static_cast<double>(first[b + 1])};
    }
    [[nodiscard]] double centre(Index b) const {
        return std::sqrt(static_cast<double>(first[b]) * static_cast<double>(first[b + 1] - 1));
    }
    std::vector<Index> first;
    Index last_bin = -1;
};

/// Limit of a curve at long waves, and its tolerance.
struct Limit {
    double value, error;
};

/// Whittaker smoothing: Σ w (y − x)² + Σ (Δ²x)²/s². At long waves x ends at a limit if that is known, otherwise
/// constant, to s of the first bin. bends: s, one value per bin.
Array1D smoothed(const Array1D& values, const Array1D& weights, const Array1D& bends,
                 const std::optional<Limit>& limit = std::nullopt) {
    const Index n = values.size();
    Eigen::MatrixXd matrix = weights.matrix().asDiagonal();
    Eigen::VectorXd right = (weights * values).matrix();
    for (Index i = 0; i + 2 < n; ++i) {
        const Eigen::Vector3d row(1.0, -2.0, 1.0);
        matrix.block(i, i, 3, 3) += row * row.transpose() / (bends[i + 1] * bends[i + 1]);
    }
    if (limit) {
        const double weight = 1.0 / (limit->error * limit->error);
        matrix(0, 0) += weight;
        right[0] += weight * limit->value;
    } else {
        const Eigen::Vector2d difference(1.0, -1.0);
        matrix.block(0, 0, 2, 2) += difference * difference.transpose() / (bends[0] * bends[0]);
    }
    return numerics::solved_symmetric(matrix, right).array();
}

/// Position of x between nodes: values are linear there, and constant beyond the ends.
class Place {
public:
    Place(const Array1D& nodes, double x) {
        const Index n = nodes.size();
        const auto above = std::upper_bound(nodes.data(), nodes.data() + n, x) - nodes.data();
        left_ = std::clamp<Index>(above - 1, 0, n - 2);
        share_ = std::clamp((x - nodes[left_]) / (nodes[left_ + 1] - nodes[left_]), 0.0, 1.0);
    }
    [[nodiscard]] double of(const ArrayView1D& values) const {
        return (1.0 - share_) * values[left_] + share_ * values[left_ + 1];
    }

private:
    Index left_;
    double share_;
};

topography::HeightMap gaussian_patch(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation,
                                     double step, int repetition) {
    return synthesis::random_surface(
        C_iso,
        {simulation.length, simulation.points, step * static_cast<double>(simulation.length),
         step * static_cast<double>(simulation.points)},
        {.key = {simulation.seed, static_cast<std::uint64_t>(repetition)}, .threads = simulation.threads});
}

/// Converts heights of a Gaussian patch to log-normal ones with the same rms height.
topography::HeightMap with_skewness(topography::HeightMap patch, double skewness) {
    if (skewness == 0.0) return patch;
    const auto transform = synthesis::lognormal_heights(skewness);
    const double rms = std::sqrt(patch.heights.square().mean());
    patch.heights = patch.heights.unaryExpr([&](double h) { return rms * transform(h / rms); });
    return patch;
}

/// wave_power() of the surface, of the reading of the tip, and of their difference.
struct WavePowers {
    Array2D surface, touched, lifted;
};

/// At the wavevectors of a response.
struct Transfer {
    Array1D log_transfer, log_followed, log_added;  ///< ln T, ln a², ln C_added
};

/// Simulation of a set of patches, and the scale of its powers.
class Reading {
public:
    Reading(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation)
        : simulation_(simulation), bins_(simulation.length / stride_x / 2 - 1) {
        const double length = simulation.step * static_cast<double>(simulation.length),
                     width = simulation.step * static_cast<double>(simulation.points);
        unit_x_ = 2.0 * pi / length;
        unit_y_ = 2.0 * pi / width;
        set_wavevectors(C_iso);
        independent_lines_ = std::max(4.0, width / std::max(simulation.correlation_length, simulation.step * stride_y));
        // Σ over m of |H|² is ny² times the mean power of lines, and that C1D · length/sample²
        const auto lines_read = static_cast<double>(simulation.points / stride_y);
        const double sample = simulation.step * stride_x;
        power_unit_ = sample * sample / length / (lines_read * lines_read);
        set_density(C_iso);
        const double carrying = pi / simulation.correlation_length;  // 2π over the wavelength of the heights' median
        const Array1D lines = log_lines_.exp();
        const auto bends = [&](double longest) {
            return Array1D(bend * (longest / carrying * lines).max(min_bend).min(1.0));
        };
        bends_of_followed_ = bends(3.0);
        bends_of_added_ = bends(10.0);
    }

    [[nodiscard]] const Array1D& wavevector() const { return wavevector_; }

    /// Hat functions over ln q, one row each, a factor of three apart; the first is 1 at all longer waves, the last at
    /// all shorter ones.
    [[nodiscard]] Array2D bands() const {
        const Array1D place = (wavevector_ / wavevector_[beyond_]).log() / std::log(band_step);
        const auto bands = static_cast<Index>(std::floor(place[place.size() - 1])) + 1;
        Array2D hats(bands, place.size());
        for (Index j = 0; j < bands; ++j)
            hats.row(j) =
                (1.0 - (place.max(0.0).min(static_cast<double>(bands - 1)) - static_cast<double>(j)).abs()).max(0.0);
        return hats;
    }

    /// Number of modes at each wavevector, none beyond the patch.
    [[nodiscard]] Array1D modes() const {
        return Array1D::NullaryExpr(wavevector_.size(),
                                    [&](Index i) { return i < beyond_ ? 0.0 : bins_.modes(i - beyond_); });
    }

    [[nodiscard]] WavePowers powers(const topography::HeightMap& patch, const Probe& probe) const {
        const Array2D surface = every_point_read(patch), touched = read(patch, probe, simulation_.threads);
        return {wave_power(surface, simulation_.threads), wave_power(touched, simulation_.threads),
                wave_power(touched - surface, simulation_.threads)};
    }

    /// Transfer for patches whose spectrum is `scale` times the given one: H_read = a H + H_added, ⟨H* H_added⟩ = 0.
    [[nodiscard]] Transfer transfer(const WavePowers& sums, int repetitions, double scale) const {
        if (simulation_.probe.is_foil()) return of_lines(sums, repetitions);
        const Array2D shared = 0.5 * (sums.touched + sums.surface - sums.lifted);
        const Array1D followed = followed_share(sums, shared);
        const Array1D log_added = added_power(sums, shared, followed, repetitions, scale);
        Transfer result{Array1D(wavevector_.size()), Array1D(wavevector_.size()), Array1D(wavevector_.size())};
        for (Index i = 0; i < wavevector_.size(); ++i) {
            const double a = followed[std::max<Index>(0, i - beyond_)];
            result.log_followed[i] = std::log(std::max(a * a, min_followed));
            result.log_added[i] = Place(log_lines_, std::log(wavevector_[i])).of(log_added);
        }
        result.log_transfer = log_transfer(result.log_followed, result.log_added, scale);
        return result;
    }

    /// A foil removes waves across the lines and follows those along them: T is the ratio of the line spectra, and no
    /// power counts as added.
    [[nodiscard]] Transfer of_lines(const WavePowers& sums, int repetitions) const {
        const Array1D ratio =
            (bins_.sums(sums.touched.rowwise().sum()) / bins_.sums(sums.surface.rowwise().sum())).log();
        const Array1D modes = Array1D::NullaryExpr(bins_.size(), [&](Index b) { return bins_.modes(b); });
        const Array1D own = smoothed(ratio, independent_lines_ * repetitions * modes, bends_of_followed_);
        const Index n = wavevector_.size();
        Transfer result{Array1D(n), Array1D::Zero(n), Array1D::Constant(n, std::log(nothing_added))};
        for (Index i = 0; i < n; ++i) result.log_transfer[i] = Place(log_lines_, std::log(wavevector_[i])).of(own);
        return result;
    }

    /// ln T = ln [(Abel integral of a² C_iso + C_added)/C1D].
    [[nodiscard]] Array1D log_transfer(const Array1D& log_followed, const Array1D& log_added, double scale) const {
        const Array1D x = wavevector_.log();
        const Array1D followed =
            nodes_.unaryExpr([&](double q) { return std::exp(Place(x, std::log(q)).of(log_followed)); }) * C_iso_;
        return ((spectra::profile_from_isotropic(nodes_, followed, wavevector_) + log_added.exp() / scale) / density_)
            .log();
    }

private:
    static constexpr double band_step = 3.0;
    static constexpr double decades_beyond = 3.0;  ///< of waves longer than the patch
    static constexpr double min_added = 1e-12;     ///< of C1D: without an effect of the tip only rounding is added
    static constexpr double nothing_added = 1e-300;
    static constexpr double min_followed = 1e-8;  ///< a²: a tip does not follow waves that it cannot enter
    static constexpr double bend = 0.05;          ///< bend of a and ln C_added per bin, at short waves …
    static constexpr double min_bend = 0.1;  ///< … and this share of it where they are flat: decreasing at waves longer
                                             ///< than those that carry heights, by factors of three and ten

    /// Wavevectors of the rings with data, their mean of ln q, each wave weighted by its power as in the regression;
    /// and longer ones.
    void set_wavevectors(const spectra::SpectralDensity& C_iso) {
        constexpr int pieces = 8;
        beyond_ = static_cast<Index>(decades_beyond * bins_per_decade);
        wavevector_.resize(beyond_ + bins_.size());
        for (Index b = 0; b < bins_.size(); ++b) {
            const auto [first, end] = bins_.ends(b);
            const double width = std::log(end / first) / pieces;
            double sum = 0.0, weights = 0.0;
            for (int i = 0; i < pieces; ++i) {
                const double log_q = std::log(unit_x_ * first) + (i + 0.5) * width, q = std::exp(log_q);
                const double weight = q * q * C_iso(q);
                sum += weight * log_q;
                weights += weight;
            }
            wavevector_[beyond_ + b] = weights > 0.0 ? std::exp(sum / weights) : unit_x_ * std::sqrt(first * end);
        }
        for (Index i = 0; i < beyond_; ++i)
            wavevector_[i] = wavevector_[beyond_] * std::pow(10.0, -static_cast<double>(beyond_ - i) / bins_per_decade);
        log_lines_ = Array1D::NullaryExpr(bins_.size(), [&](Index b) { return std::log(unit_x_ * bins_.centre(b)); });
    }

    void set_density(const spectra::SpectralDensity& C_iso) {
        constexpr double nodes_per_decade = 40.0;
        const double lowest = 0.5 * wavevector_[0], highest = pi / simulation_.step;
        const auto count = static_cast<Index>(std::ceil(nodes_per_decade * std::log10(highest / lowest))) + 1;
        nodes_ = Array1D::LinSpaced(count, std::log(lowest), std::log(highest)).exp();
        C_iso_ = nodes_.unaryExpr([&](double q) { return C_iso(q); });
        C_iso_ = C_iso_.max(1e-30 * C_iso_.maxCoeff());
        density_ = spectra::profile_from_isotropic(nodes_, C_iso_, wavevector_);
        density_of_lines_ = spectra::profile_from_isotropic(nodes_, C_iso_, log_lines_.exp());
    }

    [[nodiscard]] double wavevector_of(Index k, Index m) const {
        return std::hypot(unit_x_ * static_cast<double>(k + 1), unit_y_ * static_cast<double>(m));
    }

    /// a for waves of every direction, one ring each: the regression of the reading on the surface.
    [[nodiscard]] Array1D followed_share(const WavePowers& sums, const Array2D& shared) const {
        Array1D surface = Array1D::Zero(bins_.size()), together = surface, left = surface, counts = surface;
        for (Index k = 0; k < shared.rows(); ++k)
            for (Index m = 0; m < shared.cols(); ++m) {
                const Index b = bins_.of(wavevector_of(k, m) / unit_x_);
                if (b >= bins_.size()) continue;
                surface[b] += sums.surface(k, m);
                together[b] += shared(k, m);
                left[b] += sums.touched(k, m);
                counts[b] += m > 0 ? 2.0 : 1.0;
            }
        const Array1D follows = together / surface;
        left = (left - together * follows).max(min_added * surface);
        constexpr Limit of_endless_waves{1.0, 0.009};  // uniform shifts and tilts are followed
        return smoothed(follows, counts * surface / left, bends_of_followed_, of_endless_waves);
    }

    /// ln C_added of lines, one bin each: the reading without the followed part.
    [[nodiscard]] Array1D added_power(const WavePowers& sums, const Array2D& shared, const Array1D& followed,
                                      int repetitions, double scale) const {
        const Array1D log_rings = wavevector_.tail(bins_.size()).log();
        Array1D line(shared.rows());
        for (Index k = 0; k < shared.rows(); ++k) {
            line[k] = 0.0;
            for (Index m = 0; m < shared.cols(); ++m) {
                const double a = Place(log_rings, std::log(wavevector_of(k, m))).of(followed);
                line[k] += sums.touched(k, m) - 2.0 * a * shared(k, m) + a * a * sums.surface(k, m);
            }
        }
        const Array1D modes = Array1D::NullaryExpr(bins_.size(), [&](Index b) { return bins_.modes(b); });
        const Array1D waves = independent_lines_ * repetitions * modes;
        const Array1D added =
            (bins_.sums(line) / modes * (power_unit_ / repetitions)).max(min_added * scale * density_of_lines_);
        // the logarithm of a mean of n exponential variates is low by 1/2n
        return smoothed(added.log() + 0.5 / waves, waves, bends_of_added_);
    }

    TipSimulation simulation_;
    Bins bins_;  ///< of modes along lines, and rings of waves of all directions
    Index beyond_ = 0;
    double unit_x_ = 0.0, unit_y_ = 0.0;  ///< between modes [1/m]
    Array1D wavevector_;
    Array1D bends_of_followed_, bends_of_added_;
    double independent_lines_ = 0.0, power_unit_ = 0.0;
    Array1D nodes_, C_iso_;
    Array1D log_lines_;         ///< ln q of the bins of lines
    Array1D density_;           ///< C1D at the wavevectors …
    Array1D density_of_lines_;  ///< … and there
};

void add(WavePowers& sum, const WavePowers& powers) {
    if (sum.surface.size() == 0) {
        sum = powers;
        return;
    }
    sum.surface += powers.surface;
    sum.touched += powers.touched;
    sum.lifted += powers.lifted;
}

/// Standard errors of the mean of ln C_added in each band, times the band.
Array2D added_errors(const Reading& reading, const std::vector<Transfer>& each) {
    Array2D bands = reading.bands();
    const Array1D modes = reading.modes();
    const auto n = static_cast<double>(each.size());
    for (Index j = 0; j < bands.rows(); ++j) {
        const Array1D weights = modes * bands.row(j).transpose();
        double sum = 0.0, squares = 0.0;
        for (const auto& one : each) {
            const double level = (weights * (one.log_added - each.front().log_added)).sum() / weights.sum();
            sum += level;
            squares += level * level;
        }
        const double variance = (squares - sum * sum / n) / (n * (n - 1.0));
        bands.row(j) *= each.size() > 1 ? std::sqrt(std::max(variance, 0.0)) : error_of_one_patch;
    }
    return bands;
}

/// Differences between repetitions in the followed part, from their mean and over √(n(n − 1)), as ln T.
Array2D simulation_errors(const Reading& reading, const Transfer& all, const std::vector<Transfer>& each,
                          bool is_foil) {
    const auto repetitions = static_cast<Index>(each.size());
    if (repetitions < 2) return Array2D(0, all.log_transfer.size());
    Array2D errors(repetitions, all.log_transfer.size());
    for (Index r = 0; r < repetitions; ++r) {
        const auto& one = each[static_cast<std::size_t>(r)];
        errors.row(r) =
            (is_foil ? one.log_transfer : reading.log_transfer(one.log_followed, all.log_added, 1.0)).transpose();
    }
    const auto n = static_cast<double>(repetitions);
    return (errors.rowwise() - errors.colwise().mean().eval()) / std::sqrt(n * (n - 1.0));
}

void require(const TipSimulation& simulation) {
    if (!(simulation.probe.size > 0.0) || !(simulation.step > 0.0) || !(simulation.correlation_length > 0.0) ||
        simulation.repetitions < 1)
        throw InvalidArgument(fmt::format(
            "a probe of {} m simulated with steps of {} m, correlated over {} m, {} times; expected all > 0",
            simulation.probe.size, simulation.step, simulation.correlation_length, simulation.repetitions));
}

TipResponse simulated(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation, bool with_derivatives) {
    require(simulation);
    const Reading reading(C_iso, simulation);
    const auto& probe = simulation.probe;
    WavePowers plain, blunter, higher, skewed;
    std::vector<Transfer> each;
    for (int r = 0; r < simulation.repetitions; ++r) {
        const auto parent = gaussian_patch(C_iso, simulation, simulation.step, r);
        auto patch = with_skewness(parent, simulation.skewness);
        const auto powers = reading.powers(patch, probe);
        add(plain, powers);
        each.push_back(reading.transfer(powers, 1, 1.0));
        if (!with_derivatives) continue;
        if (simulation.size_response) add(blunter, reading.powers(patch, with_size(probe, probe.size * size_step)));
        patch.heights *= std::sqrt(amplitude_step);
        add(higher, reading.powers(patch, probe));
        if (simulation.skewness_response)
            add(skewed, reading.powers(with_skewness(parent, simulation.skewness + skewness_step), probe));
    }
    const auto transfer = [&](const WavePowers& sums, double scale) {
        return reading.transfer(sums, simulation.repetitions, scale);
    };
    const auto own = transfer(plain, 1.0);
    TipResponse response{.wavevector = reading.wavevector(),
                         .log_transfer = own.log_transfer,
                         .log_followed = own.log_followed,
                         .log_added = own.log_added};
    const Array1D none = Array1D::Zero(response.wavevector.size());
    response.followed_response = response.added_response = response.size_response = response.skewness_response = none;
    if (with_derivatives) {
        const auto of_higher = transfer(higher, amplitude_step);
        response.followed_response = (of_higher.log_followed - own.log_followed) / std::log(amplitude_step);
        response.added_response = (of_higher.log_added - own.log_added) / std::log(amplitude_step);
    }
    if (with_derivatives && simulation.size_response)
        response.size_response = (transfer(blunter, 1.0).log_transfer - own.log_transfer) / std::log(size_step);
    if (with_derivatives && simulation.skewness_response)
        response.skewness_response = (transfer(skewed, 1.0).log_transfer - own.log_transfer) / skewness_step;
    response.added_errors = added_errors(reading, each);
    response.simulation_errors = simulation_errors(reading, own, each, probe.is_foil());
    return response;
}

}  // namespace

double simulation_step(const Probe& probe, double median_wavelength, double shortest_step, Index points) {
    constexpr double foils_per_patch = 4.0, finer = 0.5;
    if (probe.is_foil())
        return std::max(finer * shortest_step, foils_per_patch * probe.size / static_cast<double>(points));
    return std::max(std::min(median_wavelength / 50.0, probe.size / 20.0), shortest_step);
}

TipResponse tip_response(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation) {
    return simulated(C_iso, simulation, true);
}

TipResponse tip_response(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation,
                         const TipResponse& before) {
    TipResponse response = simulated(C_iso, simulation, false);
    response.followed_response = before.followed_response;
    response.added_response = before.added_response;
    response.size_response = before.size_response;
    response.skewness_response = before.skewness_response;
    return response;
}

double added_skewness(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation) {
    constexpr double coarser = 4.0;
    require(simulation);
    auto square = simulation;
    square.length = square.points;
    const auto patch = with_skewness(gaussian_patch(C_iso, square, coarser * simulation.step, 0), simulation.skewness);
    return skewness_of(read(patch, simulation.probe, simulation.threads)) - skewness_of(every_point_read(patch));
}

SampledResponse sampled(const TipResponse& response, const spectra::SpectralDensity& C1D, double pixel_size,
                        const ArrayView1D& wavevectors) {
    const Array1D x = response.wavevector.log();
    constexpr int aliases = 12;
    const Index n = wavevectors.size(), repetitions = response.simulation_errors.rows(),
                bands = response.added_errors.rows();
    const auto zero = Array1D::Zero(n);
    SampledResponse result{zero, zero, zero, zero, zero, Array2D::Zero(bands, n), Array2D::Zero(repetitions, n)};
    for (Index k = 0; k < n; ++k) {
        double plain = 0.0, read = 0.0, added = 0.0;
        for (int m = -aliases; m <= aliases; ++m) {
            const double q = std::abs(wavevectors[k] + 2.0 * pi * m / pixel_size), power = C1D(q);
            const Place place(x, std::log(q));
            const double kept = power * std::exp(place.of(response.log_transfer)),
                         own = power > 0.0 ? std::exp(place.of(response.log_added)) : 0.0;
            plain += power;
            read += kept;
            added += own;
            result.added_response[k] += own * place.of(response.added_response);
            result.size_response[k] += kept * place.of(response.size_response);
            result.skewness_response[k] += kept * place.of(response.skewness_response);
            for (Index r = 0; r < repetitions; ++r)
                result.simulation_errors(r, k) += kept * place.of(response.simulation_errors.row(r).transpose());
            for (Index j = 0; j < bands; ++j)
                result.added_errors(j, k) += own * place.of(response.added_errors.row(j).transpose());
        }
        result.log_transfer[k] = plain > 0.0 ? std::log(read / plain) : 0.0;
        result.added_share[k] = plain > 0.0 ? added / plain : 0.0;
        const double share = read > 0.0 ? 1.0 / read : 0.0, of_added = added > 0.0 ? 1.0 / added : 0.0;
        result.added_response[k] *= of_added;
        result.size_response[k] *= share;
        result.skewness_response[k] *= share;
        result.simulation_errors.col(k) *= share;
        result.added_errors.col(k) *= of_added;
    }
    return result;
}

FollowedShare followed_at(const TipResponse& response, const ArrayView1D& wavevectors) {
    const Array1D x = response.wavevector.log();
    FollowedShare result{Array1D(wavevectors.size()), Array1D(wavevectors.size())};
    for (Index i = 0; i < wavevectors.size(); ++i) {
        const Place place(x, std::log(wavevectors[i]));
        result.log_square[i] = place.of(response.log_followed);
        result.response[i] = place.of(response.followed_response);
    }
    return result;
}

}  // namespace setae::spectral_fit
