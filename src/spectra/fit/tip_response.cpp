// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/tip_response.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/map_transform.hpp"
#include "setae/numerics/dense.hpp"
#include "setae/synthesis/height_transform.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/dilation.hpp"
#include "skewness.hpp"

namespace setae::spectral_fit {
namespace {

constexpr double bins_a_decade = 8.0;
constexpr double amplitude_step = 1.2, radius_step = 1.1, skewness_step = 0.2;

/// Every second pixel along x, every eighth line: what is read.
constexpr Index stride_x = 2, stride_y = 8;

/// Σ over lines of |F|², a line a column, for modes 1 … n/2 − 1.
Array1D line_power(const Array2D& lines, parallel::Threads threads) {
    const Index modes = lines.rows() / 2, blocks = fourier::block_count(lines.cols());
    Array2D power = Array2D::Zero(blocks, modes);
    fourier::transform_lines(
        lines, [](Index, double*) {},
        [&](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m)
                for (Index k = 1; k < modes; ++k) power(block.index, k) += std::norm(block.line(m)[k]);
        },
        threads);
    Array1D sum = Array1D::Zero(modes);
    for (Index b = 0; b < blocks; ++b) sum += power.row(b).transpose();
    return sum.tail(modes - 1);
}

/// Heights on the coarse grid, lines along x as columns.
Array2D every_point_read(const topography::HeightMap& surface) {
    return Array2D::NullaryExpr(surface.heights.rows() / stride_x, surface.heights.cols() / stride_y,
                                [&](Index i, Index j) { return surface.heights(i * stride_x, j * stride_y); });
}

/// Readings of the tip there, line after line: each point starts from its neighbour's contact.
Array2D read(const topography::HeightMap& surface, double radius, parallel::Threads threads) {
    const Index nx = surface.heights.rows() / stride_x, ny = surface.heights.cols() / stride_y;
    const auto [step_x, step_y] = surface.pixel_size();
    Array1D x(nx * ny), y(nx * ny);
    for (Index k = 0; k < x.size(); ++k) {
        const Index row = k / nx, column = k % nx;
        x[k] = static_cast<double>(column * stride_x) * step_x;
        y[k] = static_cast<double>(row * stride_y) * step_y;
    }
    const Array1D readings = topography::dilated_at(surface, topography::SphereTip{radius}, x, y, {.threads = threads});
    return Eigen::Map<const Array2D>(readings.data(), ny, nx).transpose();
}

struct Bins {
    explicit Bins(Index modes) {
        for (Index k = 1; k <= modes; ++k) {
            const auto bin = static_cast<Index>(std::floor(bins_a_decade * std::log10(static_cast<double>(k)) + 1e-9));
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
    [[nodiscard]] double centre(Index b) const {
        return std::sqrt(static_cast<double>(first[b]) * static_cast<double>(first[b + 1] - 1));
    }
    std::vector<Index> first;
    Index last_bin = -1;
};

/// Whittaker smoothing: Σ w (y − x)² + Σ (Δ²x)²/s².
Array1D smoothed(const Array1D& values, const Array1D& weights) {
    constexpr double bend = 0.09;  // per bin: what ln T turns by
    const Index n = values.size();
    Eigen::MatrixXd matrix = weights.matrix().asDiagonal();
    for (Index i = 0; i + 2 < n; ++i) {
        const Eigen::Vector3d row(1.0, -2.0, 1.0);
        matrix.block(i, i, 3, 3) += row * row.transpose() / (bend * bend);
    }
    matrix(0, 0) += 1.0 / (bend * bend);  // flat at long waves
    matrix(1, 1) += 1.0 / (bend * bend);
    matrix(0, 1) -= 1.0 / (bend * bend);
    matrix(1, 0) -= 1.0 / (bend * bend);
    return numerics::solved_symmetric(matrix, Eigen::VectorXd((weights * values).matrix())).array();
}

/// Where x lies between nodes: values there are linear, and constant beyond the ends.
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
    const double size = step * static_cast<double>(simulation.points);
    return synthesis::random_surface(
        C_iso, {simulation.points, simulation.points, size, size},
        {.key = {simulation.seed, static_cast<std::uint64_t>(repetition)}, .threads = simulation.threads});
}

/// Heights of a Gaussian patch become log-normal of the same rms height.
topography::HeightMap with_skewness(topography::HeightMap patch, double skewness) {
    if (skewness == 0.0) return patch;
    const auto transform = synthesis::lognormal_heights(skewness);
    const double rms = std::sqrt(patch.heights.square().mean());
    patch.heights = patch.heights.unaryExpr([&](double h) { return rms * transform(h / rms); });
    return patch;
}

/// Sums of line power over repetitions, a bin a column.
struct PowerSums {
    Array1D surface, touched, higher, blunter, skewed_surface, skewed;
    Array2D single;  ///< ln T of each repetition
};

PowerSums power_sums(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation, const Bins& bins,
                     bool with_derivatives) {
    const Index count = bins.size();
    const double radius = simulation.tip_radius;
    const Array1D none = Array1D::Zero(count);
    PowerSums sums{none, none, none, none, none, none, Array2D(simulation.repetitions, count)};
    const auto power = [&](const Array2D& lines) { return bins.sums(line_power(lines, simulation.threads)); };
    for (int r = 0; r < simulation.repetitions; ++r) {
        const auto parent = gaussian_patch(C_iso, simulation, simulation.step, r);
        auto patch = with_skewness(parent, simulation.skewness);
        const Array1D surface = power(every_point_read(patch)),
                      touched = power(read(patch, radius, simulation.threads));
        sums.surface += surface;
        sums.touched += touched;
        sums.single.row(r) = (touched / surface).log().transpose();
        if (!with_derivatives) continue;
        if (simulation.radius_response) sums.blunter += power(read(patch, radius * radius_step, simulation.threads));
        patch.heights *= std::sqrt(amplitude_step);
        sums.higher += power(read(patch, radius, simulation.threads)) / amplitude_step;
        if (!simulation.skewness_response) continue;
        patch = with_skewness(parent, simulation.skewness + skewness_step);
        sums.skewed_surface += power(every_point_read(patch));
        sums.skewed += power(read(patch, radius, simulation.threads));
    }
    return sums;
}

/// Smoothed departures of the repetitions from their mean, over √(n(n − 1)).
Array2D simulation_errors(const Array2D& single, const Array1D& weights) {
    if (single.rows() < 2) return Array2D(0, single.cols());
    const auto n = static_cast<double>(single.rows());
    Array2D errors = (single.rowwise() - single.colwise().mean()) / std::sqrt(n * (n - 1.0));
    for (Index r = 0; r < errors.rows(); ++r) errors.row(r) = smoothed(errors.row(r).transpose(), weights).transpose();
    return errors;
}

void require(const TipSimulation& simulation) {
    if (!(simulation.tip_radius > 0.0) || !(simulation.step > 0.0) || !(simulation.correlation_length > 0.0) ||
        simulation.repetitions < 1)
        throw InvalidArgument(
            fmt::format("a tip of {} m simulated with steps of {} m, correlated over {} m, {} times; expected all > 0",
                        simulation.tip_radius, simulation.step, simulation.correlation_length, simulation.repetitions));
}

TipResponse simulated(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation, bool with_derivatives) {
    require(simulation);
    const Bins bins(simulation.points / stride_x / 2 - 1);
    const double size = simulation.step * static_cast<double>(simulation.points);
    const auto sums = power_sums(C_iso, simulation, bins, with_derivatives);
    // independent values behind a bin: its modes, and lines a correlation length apart
    const double lines = std::max(4.0, size / std::max(simulation.correlation_length, simulation.step * stride_y)) *
                         static_cast<double>(simulation.repetitions);
    const Array1D weights = Array1D::NullaryExpr(
        bins.size(), [&](Index b) { return lines * static_cast<double>(bins.first[b + 1] - bins.first[b]); });
    const auto log_ratio = [&](const Array1D& over, const Array1D& under) {
        return smoothed((over / under).log(), weights);
    };
    TipResponse response;
    response.wavevector = Array1D::NullaryExpr(bins.size(), [&](Index b) { return 2.0 * pi / size * bins.centre(b); });
    response.log_transfer = log_ratio(sums.touched, sums.surface);
    response.amplitude_response = response.radius_response = response.skewness_response = Array1D::Zero(bins.size());
    if (with_derivatives) response.amplitude_response = log_ratio(sums.higher, sums.touched) / std::log(amplitude_step);
    if (with_derivatives && simulation.radius_response)
        response.radius_response = log_ratio(sums.blunter, sums.touched) / std::log(radius_step);
    if (with_derivatives && simulation.skewness_response)
        response.skewness_response =
            (log_ratio(sums.skewed, sums.skewed_surface) - response.log_transfer) / skewness_step;
    response.simulation_errors = simulation_errors(sums.single, weights);
    return response;
}

}  // namespace

double simulation_step(double tip_radius, double median_wavelength, double shortest_step) {
    return std::max(std::min(median_wavelength / 50.0, tip_radius / 20.0), shortest_step);
}

TipResponse tip_response(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation) {
    return simulated(C_iso, simulation, true);
}

TipResponse tip_response(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation,
                         const TipResponse& before) {
    TipResponse response = simulated(C_iso, simulation, false);
    response.amplitude_response = before.amplitude_response;
    response.radius_response = before.radius_response;
    response.skewness_response = before.skewness_response;
    return response;
}

double added_skewness(const spectra::SpectralDensity& C_iso, const TipSimulation& simulation) {
    constexpr double coarser = 4.0;
    require(simulation);
    const auto patch =
        with_skewness(gaussian_patch(C_iso, simulation, coarser * simulation.step, 0), simulation.skewness);
    return skewness_of(read(patch, simulation.tip_radius, simulation.threads)) - skewness_of(every_point_read(patch));
}

SampledResponse sampled(const TipResponse& response, const spectra::SpectralDensity& C1D, double pixel_size,
                        const ArrayView1D& wavevectors) {
    const Array1D x = response.wavevector.log();
    constexpr int aliases = 12;
    const Index n = wavevectors.size(), repetitions = response.simulation_errors.rows();
    const auto zero = Array1D::Zero(n);
    SampledResponse result{zero, zero, zero, zero, Array2D::Zero(repetitions, n)};
    for (Index k = 0; k < n; ++k) {
        double plain = 0.0, read = 0.0;
        for (int m = -aliases; m <= aliases; ++m) {
            const double q = std::abs(wavevectors[k] + 2.0 * pi * m / pixel_size), power = C1D(q);
            const Place place(x, std::log(q));
            const double kept = power * std::exp(place.of(response.log_transfer));
            plain += power;
            read += kept;
            result.amplitude_response[k] += kept * place.of(response.amplitude_response);
            result.radius_response[k] += kept * place.of(response.radius_response);
            result.skewness_response[k] += kept * place.of(response.skewness_response);
            for (Index r = 0; r < repetitions; ++r)
                result.simulation_errors(r, k) += kept * place.of(response.simulation_errors.row(r).transpose());
        }
        result.log_transfer[k] = plain > 0.0 ? std::log(read / plain) : 0.0;
        const double share = read > 0.0 ? 1.0 / read : 0.0;
        result.amplitude_response[k] *= share;
        result.radius_response[k] *= share;
        result.skewness_response[k] *= share;
        result.simulation_errors.col(k) *= share;
    }
    return result;
}

}  // namespace setae::spectral_fit
