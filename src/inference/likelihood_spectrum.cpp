// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/inference/likelihood_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Cholesky>
#include <boost/math/distributions/chi_squared.hpp>
#include <fmt/format.h>

#include "independent_lines.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/inference/contour_kernel.hpp"
#include "setae/inference/hat_node.hpp"
#include "setae/inference/scan_kernel.hpp"
#include "setae/inference/tip_response.hpp"
#include "setae/inference/whittle_fit.hpp"
#include "setae/spectra/reliability.hpp"
#include "setae/synthesis/abel.hpp"
#include "setae/synthesis/random_numbers.hpp"

namespace setae::inference {
namespace {

/// Neighbouring modes of a Hann window share their data: Σ |ρ|² = 1 + 2 (4/9 + 1/36).
constexpr double share_of_independent_modes = 0.5142857142857142;

/// A class with what its measurements were.
struct Group {
    PeriodogramClass data;
    double tip_radius = 0.0;
    double tip_radius_error = 0.0;
    double pixel_size = 0.0;
    Index lines = 1;
    double pitch = 0.0;
    int measurements = 0;
    double band_end = 0.0;
    Array1D mode_counts;
    SampledResponse tip;
};

struct Range {
    double shortest = 0.0;  ///< q_s
    double lowest = 0.0;    ///< of the spline
};

int trend_degree(topography::Trend trend) { return trend == topography::Trend::parabola ? 2 : 1; }

topography::HeightMap as_map(const topography::LineScan& scan) {
    topography::HeightMap map{Eigen::Map<const Array2D>(scan.heights.data(), scan.heights.size(), 1), {scan.size, scan.pixel_size()}, false, scan.metadata};
    return map;
}

double length_of(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) return map->size[0];
    if (const auto* scan = std::get_if<topography::LineScan>(&measurement)) return scan->size;
    return std::get<topography::Profile>(measurement).size();
}

Range range_of(std::span<const ObservedSurface> observed, const LikelihoodOptions& options) {
    if (observed.empty()) throw InvalidArgument("no measurement to fit a spectrum to");
    if (!(options.shortest_wavelength > 0.0)) throw InvalidArgument(fmt::format("shortest wavelength {} m; expected > 0", options.shortest_wavelength));
    Range range{2.0 * pi / options.shortest_wavelength, 0.0};
    double longest = 0.0;
    for (const auto& o : observed) longest = std::max(longest, length_of(o.measurement));
    range.lowest = 0.6 * 2.0 * pi / longest;
    return range;
}

/// Nodes and response of an equidistant class, the flat part and the end at q_s folded into the outer columns.
void add_response(Group& group, const ScanShape& shape, const Range& range, double length, parallel::Threads threads) {
    const double step = group.pixel_size;
    const auto first = static_cast<Index>(std::floor(std::log(0.03 * 2.0 * pi / length * step) / node_spacing));
    const double end = std::log(range.shortest * step) / node_spacing;
    const auto last = static_cast<Index>(std::floor(end + 1e-9));
    if (last <= first + 1) throw InvalidArgument(fmt::format("pixels of {} m below the surface's shortest wavelength", step));
    auto kernel = scan_kernel(shape, first, last + 1, threads);
    // between the last node and q_s C goes on, beyond it there is nothing: the hat of the node behind takes what is missing
    const double rest = end - static_cast<double>(last) - 0.5;
    const Index count = last - first + 1;
    kernel.response.col(count - 1) += rest * std::exp(-2.0 * node_spacing) * kernel.response.col(count);
    kernel.response.col(0) += kernel.flat_response;
    group.data.nodes = (Array1D::LinSpaced(count, static_cast<double>(first), static_cast<double>(last)) * node_spacing).exp() / step;
    group.data.response = kernel.response.leftCols(count) / step;
    group.data.noise_response = kernel.noise_response * step;
}

std::string class_name(const topography::Metadata& metadata, Index points, double size) {
    return fmt::format("{} of {} points over {:.4g} um", metadata.instrument.type.empty() ? "scan" : metadata.instrument.type, points, size * 1e6);
}

void add_uniform(std::vector<Group>& groups, const topography::HeightMap& map, const ObservedSurface& observed, const Range& range,
                 const LikelihoodOptions& options) {
    const ScanShape shape{map.heights.rows(), trend_degree(observed.trend)};
    const auto& instrument = map.metadata.instrument;
    const double step = map.pixel_size()[0];
    const Array1D periodogram = scan_periodogram(map.heights, step, shape.trend_degree, options.threads);
    double band_end = pi / step * (1.0 + 1e-9);
    if (options.tip_band) band_end = std::min(band_end, spectra::reliable_band(observed.measurement, {}, options.threads).band.upper);
    const std::string name = class_name(map.metadata, map.heights.rows(), map.size[0]);
    auto place = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
        return g.data.name == name && g.data.instrument == instrument.type && g.lines == map.heights.cols() && g.tip_radius == instrument.tip_radius.value_or(0.0) &&
               std::abs(g.pixel_size / step - 1.0) < 1e-6 && g.data.periodogram.size() == periodogram.size();
    });
    if (place == groups.end()) {
        Group group;
        group.data.instrument = instrument.type;
        group.data.name = name;
        group.tip_radius = instrument.tip_radius.value_or(0.0);
        group.tip_radius_error = instrument.tip_radius_standard_error.value_or(0.0);
        group.pixel_size = step;
        group.lines = map.heights.cols();
        group.pitch = map.pixel_size()[1];
        add_response(group, shape, range, map.size[0], options.threads);
        const ModeBins bins(shape.points / 2);
        group.data.wavevector = Array1D::NullaryExpr(bins.size(), [&](Index b) { return 2.0 * pi / map.size[0] * bins.centre(b); });
        group.mode_counts = Array1D::NullaryExpr(bins.size(), [&](Index b) { return static_cast<double>(bins.count(b)); });
        group.data.periodogram = Array1D::Zero(bins.size());
        groups.push_back(std::move(group));
        place = groups.end() - 1;
    }
    const double n = ++place->measurements;
    place->data.periodogram += (periodogram - place->data.periodogram) / n;
    place->band_end = std::exp(((n - 1.0) * std::log(n > 1.0 ? place->band_end : 1.0) + std::log(band_end)) / n);
}

void add_contour(std::vector<Group>& groups, const topography::Profile& contour, const Array1D& nodes, const LikelihoodOptions& options) {
    auto kernel = contour_kernel(contour, nodes, options.threads);
    Group group;
    group.data.instrument = contour.metadata.instrument.type;
    group.data.name = class_name(contour.metadata, contour.positions.size(), kernel.length);
    group.data.nodes = nodes;
    group.data.response = std::move(kernel.response);
    group.data.wavevector = Array1D::NullaryExpr(kernel.bins.size(), [&](Index b) { return 2.0 * pi / kernel.length * kernel.bins.centre(b); });
    group.mode_counts = Array1D::NullaryExpr(kernel.bins.size(), [&](Index b) { return static_cast<double>(kernel.bins.count(b)); });
    group.data.periodogram = std::move(kernel.periodogram);
    group.measurements = 1;
    group.band_end = pi * static_cast<double>(contour.positions.size() - 1) / kernel.length;
    groups.push_back(std::move(group));
}

/// Fit and everything it is repeated with.
class Estimate {
public:
    Estimate(std::vector<Group> groups, const Range& range, const LikelihoodOptions& options)
        : groups_(std::move(groups)), options_(options), spline_(range.lowest, range.shortest),
          smoothness_{options.bend, 0.5, 8.0 * range.lowest / 0.6} {
        for (auto& g : groups_) {
            const Index n = g.data.wavevector.size();
            g.data.log_transfer = g.data.amplitude_response = Array1D::Zero(n);
            g.data.freedom = freedom(g, Array1D::Ones(n), Array1D::Ones(n));
        }
    }

    void run() {
        refit();
        count_lines();
        refit();
        for (int round = 0; options_.tip_factor && round < options_.rounds; ++round) {
            simulate_tips();
            refit();
            count_lines();
            ++rounds_;
        }
        refit();
    }

    [[nodiscard]] LikelihoodSpectrum result() const {
        LikelihoodSpectrum r;
        const auto count = static_cast<Index>(std::floor(std::log(spline_.shortest() / std::exp(spline_.position(1))) / node_spacing + 1e-9)) + 1;
        r.wavevector = spline_.shortest() * (Array1D::LinSpaced(count, static_cast<double>(1 - count), 0.0) * node_spacing).exp();
        r.design = spline_.design(r.wavevector);
        r.theta = fit_.theta;
        r.covariance = full_covariance();
        r.C_iso = (r.design * r.theta).array().exp();
        r.standard_error = (r.design * r.covariance).cwiseProduct(r.design).rowwise().sum().array().max(0.0).sqrt();
        r.rounds = rounds_;
        r.converged = fit_.converged;
        r.band = used_band();
        add_agreement(r);
        for (const auto& g : groups_)
            if (g.tip.log_transfer.size() > 0) r.tips.push_back({g.data.instrument, g.tip_radius, g.data.wavevector, g.tip.log_transfer.exp()});
        if (!r.converged)
            r.alerts.push_back({"NOT_CONVERGED", "spectrum", fmt::format("the fit stopped after {} steps short of its optimum", fit_.iterations),
                                "look at the agreement of each instrument; a measurement in the wrong unit does this"});
        return r;
    }

private:
    /// ν of every group of modes, 0 outside the band and where the tip leaves too little.
    [[nodiscard]] Array1D freedom(const Group& g, const Array1D& lines, const Array1D& transfer) const {
        Array1D result = share_of_independent_modes * g.mode_counts * lines * static_cast<double>(g.measurements);
        for (Index k = 0; k < result.size(); ++k)
            if (g.data.wavevector[k] > g.band_end || transfer[k] < options_.least_transfer || !(g.data.periodogram[k] > 0.0)) result[k] = 0.0;
        return result;
    }

    void refit() {
        std::vector<PeriodogramClass> classes;
        for (const auto& g : groups_) classes.push_back(g.data);
        fit_ = fit_whittle(classes, spline_, smoothness_, fit_.theta);
    }

    [[nodiscard]] synthesis::SpectralDensity C_iso() const {
        return [this, theta = fit_.theta](double q) { return spline_.value(theta, q); };
    }

    void count_lines() {
        for (std::size_t c = 0; c < groups_.size(); ++c) {
            auto& g = groups_[c];
            const Index n = g.data.wavevector.size();
            Array1D lines = Array1D::Ones(n);
            if (g.lines > 1) {
                const double noise = std::exp(fit_.log_noise[static_cast<Index>(c)]);
                const Array1D signal = (1.0 - g.data.noise_response * noise * g.data.log_transfer.exp() / fit_.expected[c]).max(0.0).min(1.0);
                lines = independent_lines(C_iso(), g.data.wavevector, signal, g.lines, g.pitch);
            }
            g.data.freedom = freedom(g, lines, g.data.log_transfer.exp());
        }
    }

    [[nodiscard]] double median_wavelength() const {
        const double total = spline_moment(spline_, fit_.theta, 1.0, spline_.shortest()).value;
        double lower = std::log(std::exp(spline_.position(1)) * 0.1), upper = std::log(spline_.shortest());
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (lower + upper);
            (spline_moment(spline_, fit_.theta, 1.0, std::exp(middle)).value < 0.5 * total ? lower : upper) = middle;
        }
        return 2.0 * pi / std::exp(0.5 * (lower + upper));
    }

    /// C1D of the fit on ten wavevectors a decade.
    [[nodiscard]] synthesis::SpectralDensity C1D() const {
        const double lowest = std::exp(spline_.position(1)), end = spline_.shortest();
        const auto nodes = static_cast<Index>(std::ceil(20.0 * std::log10(end / lowest)));
        const Array1D q = Array1D::LinSpaced(nodes + 1, std::log(lowest), std::log(end)).exp();
        const Array1D values = q.unaryExpr([&](double x) { return spline_.value(fit_.theta, std::min(x, end)); });
        Array1D line = synthesis::profile_from_isotropic(q, values, q.head(nodes));
        const Array1D at = q.head(nodes);
        return synthesis::tabulated_density(at, line);
    }

    void simulate_tips() {
        const double wavelength = median_wavelength();
        const auto line_density = C1D();
        std::map<double, TipResponse> responses;
        for (auto& g : groups_) {
            if (!(g.tip_radius > 0.0)) continue;
            auto found = responses.find(g.tip_radius);
            if (found == responses.end()) {
                const TipSimulation simulation{.tip_radius = g.tip_radius, .shortest_step = 0.5 * options_.shortest_wavelength, .points = options_.tip_points,
                                               .seed = options_.seed, .threads = options_.threads};
                found = responses.emplace(g.tip_radius, tip_response(C_iso(), wavelength, simulation)).first;
            }
            g.tip = sampled(found->second, line_density, g.pixel_size, g.data.wavevector);
            g.data.log_transfer = g.tip.log_transfer;
            g.data.amplitude_response = g.tip.amplitude_response;
            const bool fine = g.tip_radius < 0.25 * wavelength;
            g.data.amplitude_order = fine ? 5.0 : 1.0;
            g.data.amplitude_end = fine ? pi / g.tip_radius : spline_.shortest();
            g.data.reference_amplitude = spline_moment(spline_, fit_.theta, g.data.amplitude_order, g.data.amplitude_end).value;
        }
    }

    /// Of the fit, plus what uncertain radii and the noise of the simulation do, each tip by itself.
    [[nodiscard]] Eigen::MatrixXd full_covariance() const {
        Eigen::MatrixXd covariance = fit_.covariance;
        std::map<double, std::pair<Eigen::VectorXd, Eigen::VectorXd>> moved;  // by tip: radius, simulation
        for (std::size_t c = 0; c < groups_.size(); ++c) {
            const auto& g = groups_[c];
            if (g.tip.log_transfer.size() == 0) continue;
            auto& [radius, simulation] = moved.try_emplace(g.tip_radius, Eigen::VectorXd::Zero(fit_.theta.size()), Eigen::VectorXd::Zero(fit_.theta.size())).first->second;
            const Eigen::MatrixXd score = fit_.jacobian[c].transpose() * g.data.freedom.matrix().asDiagonal();
            radius += fit_.gain * score * (g.tip.radius_response * (g.tip_radius_error / g.tip_radius)).matrix();
            simulation += fit_.gain * score * g.tip.standard_error.matrix();
        }
        for (const auto& [tip, both] : moved) covariance += both.first * both.first.transpose() + both.second * both.second.transpose();
        return covariance;
    }

    [[nodiscard]] Band used_band() const {
        Band band{std::numeric_limits<double>::infinity(), 0.0};
        for (const auto& g : groups_)
            for (Index k = 0; k < g.data.wavevector.size(); ++k)
                if (g.data.freedom[k] > 0.0) {
                    band.lower = std::min(band.lower, g.data.wavevector[k]);
                    band.upper = std::max(band.upper, g.data.wavevector[k]);
                }
        return band;
    }

    void add_agreement(LikelihoodSpectrum& r) const {
        std::map<std::pair<std::string, int>, Agreement> rows;
        std::map<std::pair<std::string, int>, double> weights;
        for (std::size_t c = 0; c < groups_.size(); ++c) {
            const auto& g = groups_[c];
            for (Index k = 0; k < g.data.wavevector.size(); ++k) {
                if (!(g.data.freedom[k] > 0.0)) continue;
                const std::pair key{g.data.instrument, static_cast<int>(std::floor(std::log10(g.data.wavevector[k])))};
                auto& row = rows[key];
                const double ratio = g.data.periodogram[k] / fit_.expected[c][k], nu = g.data.freedom[k];
                row.ratio = (weights[key] * (weights[key] > 0.0 ? row.ratio : 0.0) + nu * ratio) / (weights[key] + nu);
                weights[key] += nu;
                row.chi_squared += nu * (ratio - 1.0) * (ratio - 1.0);
                ++row.groups;
            }
        }
        for (auto& [key, row] : rows) {
            row.instrument = key.first;
            row.decade = key.second;
            row.probability = boost::math::cdf(boost::math::complement(boost::math::chi_squared(row.groups), row.chi_squared));
            if (row.probability < 1e-4)
                r.alerts.push_back({"INSTRUMENTS_DISAGREE", row.instrument,
                                    fmt::format("between 1e{} and 1e{} 1/m its periodograms are {:.2f} of what the fit expects, chi² {:.0f} for {} groups of modes",
                                                row.decade, row.decade + 1, row.ratio, row.chi_squared, row.groups),
                                    "check its calibration, tip radius and shape; look at its own spectrum beside the others"});
            r.agreement.push_back(row);
        }
    }

    std::vector<Group> groups_;
    LikelihoodOptions options_;
    LogSpline spline_;
    Smoothness smoothness_;
    WhittleFit fit_;
    int rounds_ = 0;
};

}  // namespace

LikelihoodSpectrum likelihood_spectrum(std::span<const ObservedSurface> observed, const LikelihoodOptions& options) {
    const auto range = range_of(observed, options);
    const auto count = static_cast<Index>(std::ceil(std::log(range.shortest / (0.03 * range.lowest)) / node_spacing)) + 1;
    const Array1D nodes = range.shortest * (Array1D::LinSpaced(count, static_cast<double>(1 - count), 0.0) * node_spacing).exp();
    std::vector<Group> groups;
    for (const auto& o : observed) {
        if (const auto* map = std::get_if<topography::HeightMap>(&o.measurement)) add_uniform(groups, *map, o, range, options);
        else if (const auto* scan = std::get_if<topography::LineScan>(&o.measurement)) add_uniform(groups, as_map(*scan), o, range, options);
        else add_contour(groups, std::get<topography::Profile>(o.measurement), nodes, options);
    }
    Estimate estimate(std::move(groups), range, options);
    estimate.run();
    return estimate.result();
}

Array2D drawn_spectra(const LikelihoodSpectrum& spectrum, Index count, std::uint64_t seed) {
    const Index n = spectrum.theta.size();
    const Eigen::LLT<Eigen::MatrixXd> root(0.5 * (spectrum.covariance + spectrum.covariance.transpose()));
    if (root.info() != Eigen::Success) throw InternalError("covariance of the spectrum is not positive definite");
    const Eigen::MatrixXd lower = root.matrixL();
    Array2D result(count, spectrum.wavevector.size());
    Array1D normal(n);
    for (Index r = 0; r < count; ++r) {
        synthesis::fill_normal({seed, 0}, static_cast<std::uint64_t>(r * n), normal);
        result.row(r) = (spectrum.design * (spectrum.theta + lower * normal.matrix())).array().exp().transpose();
    }
    return result;
}

}  // namespace setae::inference
