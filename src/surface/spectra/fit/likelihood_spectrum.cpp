// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/likelihood_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>
#include <Eigen/Core>

#include "agreement.hpp"
#include "contour_kernel.hpp"
#include "input_responses.hpp"
#include "observed_groups.hpp"
#include "place_scatter.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/estimate.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/numerics/dense.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/spectra/abel.hpp"
#include "setae/spectra/reliability.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/spectral_fit/hat_node.hpp"
#include "setae/spectral_fit/independent_lines.hpp"
#include "setae/spectral_fit/stretch.hpp"
#include "stretched_groups.hpp"

namespace setae::spectral_fit {
namespace {

/// Width of a patch in median wavelengths of the heights, sufficient for their long waves.
constexpr double waves_per_patch = 8.0;

/// Beyond this skewness log-normal heights are another kind of surface.
constexpr double max_skewness = 1.5;

/// rms change of ln T, weighted by freedoms, that ends the rounds.
constexpr double small_change = 0.005;

/// Longer curves are treated as scans with nearly equal steps.
constexpr Index max_points_of_shares = 2048;

/// Fit and the data for its repetition.
class JointFit {
public:
    JointFit(std::vector<ObservedGroup> groups, StretchOfMaps maps, const SpectrumRange& range,
             const LikelihoodOptions& options)
        : groups_(std::move(groups)),
          maps_(std::move(maps)),
          options_(options),
          spline_(range.lowest, range.shortest),
          smoothness_{options.bend, 0.5, 8.0 * range.lowest / 0.6} {
        known_stretch_ = {maps_.law, maps_.information};
        use_stretch(maps_.law, maps_.law.isotropic() ? Eigen::MatrixXd() : numerics::inverse(maps_.information));
        for (auto& g : groups_) {
            const Index n = g.data.wavevector.size();
            g.data.freedom = freedom(g, Array1D::Ones(n));
        }
    }

    void run() {
        refit();
        find_independent_shares();
        take_gaps();
        count_lines();
        refit();
        compare_directions();
        bool settled = !options_.tip_factor;
        while (!settled && rounds_ < options_.rounds) {
            take_gaps();
            settled = simulate_tips();
            refit();
            count_lines();
            ++rounds_;
        }
        refit();
        compare_directions();
    }

    [[nodiscard]] LikelihoodSpectrum result() const {
        LikelihoodSpectrum r;
        const auto count = static_cast<Index>(std::floor(
                               std::log(spline_.shortest() / std::exp(spline_.position(1))) / node_spacing + 1e-9)) +
                           1;
        r.C_iso.wavevector =
            spline_.shortest() * (Array1D::LinSpaced(count, static_cast<double>(1 - count), 0.0) * node_spacing).exp();
        r.design = spline_.design(r.C_iso.wavevector);
        r.theta = fit_.theta;
        const auto scatter = scatter_between_places(groups_, fit_);
        r.covariance = own_covariance(scatter);
        r.inputs = input_responses(groups_, responses_, fit_, spline_, smoothness_);
        r.C_iso.kind = spectra::Density::C_iso;
        r.C_iso.density = (r.design * r.theta).array().exp();
        if (!stretch_.isotropic()) {
            auto mean = direction_mean(spline_, fit_.theta, stretch_, r.C_iso.wavevector);
            r.C_iso.density = mean.log_density.exp();
            r.design = std::move(mean.design);
            r.C_along = density_of_lines(spline_, fit_.theta, stretch_, r.C_iso.wavevector, 0.0);
            r.C_across = density_of_lines(spline_, fit_.theta, stretch_, r.C_iso.wavevector, 0.5 * pi);
        }
        r.log_standard_error =
            (r.design * r.total_covariance()).cwiseProduct(r.design).rowwise().sum().array().max(0.0).sqrt();
        r.rounds = rounds_;
        r.converged = fit_.converged;
        r.iterations = fit_.iterations;
        r.C_iso.band = used_band();
        r.agreement = agreement(groups_, fit_);
        for (const auto& alerts : {agreement_alerts(r.agreement), scatter_alerts(scatter)})
            r.alerts.insert(r.alerts.end(), alerts.begin(), alerts.end());
        add_rolloff_alert(r);
        add_stretch(r);
        for (const auto& g : groups_)
            if (g.tip.log_transfer.size() > 0)
                r.tips.push_back(
                    {g.data.instrument, g.probe->name, g.probe->size, g.data.wavevector, g.tip.log_transfer.exp()});
        return r;
    }

private:
    /// Whether a group of modes contains information on the surface: inside the band, with sufficient transfer by the
    /// tip.
    [[nodiscard]] bool inside(const ObservedGroup& g, Index k) const {
        const bool seen = g.tip.log_transfer.size() == 0 || std::exp(g.tip.log_transfer[k]) >= options_.min_transfer;
        const double end = std::min(g.band_end, (1.0 + 1e-9) * lines_end(stretch_, spline_.shortest(), g.direction));
        if (g.optics && std::pow(g.optics->at(g.data.wavevector[k]), 2) < options_.min_transfer) return false;
        return g.data.wavevector[k] >= g.band_begin && g.data.wavevector[k] <= end && seen &&
               g.data.periodogram[k] > 0.0;
    }

    /// ν of every group of modes, 0 outside the band and for insufficient transfer by the tip.
    [[nodiscard]] Array1D freedom(const ObservedGroup& g, const Array1D& lines) const {
        Array1D result = g.independent_share * g.mode_counts * lines * static_cast<double>(g.measurements);
        for (Index k = 0; k < result.size(); ++k)
            if (!inside(g, k)) result[k] = 0.0;
        return result;
    }

    void refit() {
        std::vector<PeriodogramClass> classes;
        for (const auto& g : groups_) classes.push_back(g.data);
        fit_ = fit_whittle(classes, spline_, smoothness_, fit_.theta);
    }

    void use_stretch(StretchLaw law, Eigen::MatrixXd covariance) {
        stretch_ = std::move(law);
        stretch_covariance_ = std::move(covariance);
        take_stretch(groups_, stretch_, spline_.shortest());
    }

    /// Stretch from lines along several directions, in addition to maps; repeats the fit with it. Without a significant
    /// stretch of maps, it is used if chance is improbable (p < 0.01).
    void compare_directions() {
        constexpr int rounds = 4;
        constexpr double significant = 0.01;
        if (!several_directions(groups_)) return;
        if (known_stretch_.law.isotropic()) known_stretch_ = unknown_stretch(used_band());
        if (stretch_.isotropic()) use_stretch(known_stretch_.law, {});
        for (int round = 0; round < rounds; ++round) {
            auto step = stretch_step(groups_, spline_, fit_, stretch_, known_stretch_);
            use_stretch(std::move(step.law), std::move(step.covariance));
            count_lines();
            refit();
        }
        if (!maps_.law.isotropic()) return;
        const Eigen::VectorXd values = stretch_.values();
        const double chi_squared = values.dot(numerics::solved_symmetric(stretch_covariance_, values));
        if (chi_squared_exceedance(chi_squared, static_cast<double>(values.size())) < significant) return;
        use_stretch({}, {});
        refit();
    }

    [[nodiscard]] spectra::SpectralDensity C_iso() const {
        return [this, theta = fit_.theta](double q) { return spline_.value(theta, q); };
    }

    /// Effect of interpolated gaps on the periodograms of lines with the spectrum of the fit.
    void take_gaps() {
        for (std::size_t c = 0; c < groups_.size(); ++c) {
            auto& g = groups_[c];
            if (g.gaps.empty()) continue;
            const ScanShape shape{g.gaps.front().undefined.rows(), g.trend_degree};
            const auto read = spectra::tabulated_density(g.data.wavevector, fit_.expected[c]);
            Array1D factor = Array1D::Ones(g.data.wavevector.size());
            for (std::size_t m = 0; m < g.gaps.size(); ++m)
                factor +=
                    (gap_factor(g.gaps[m], shape, g.pixel_size, read, options_.seed + m, options_.threads) - 1.0) /
                    g.measurements;
            const Array1D change = g.gap_factor.size() > 0 ? Array1D(factor / g.gap_factor) : factor;
            g.data.response.colwise() *= change;
            g.data.noise_response *= change;
            g.gap_factor = factor;
        }
    }

    void find_independent_shares() {
        for (auto& g : groups_) {
            if (!g.contour || g.contour->positions.size() > max_points_of_shares) continue;
            g.independent_share = independent_share(*g.contour, g.data.nodes, C_iso_of(g), options_.threads);
        }
    }

    void count_lines() {
        for (std::size_t c = 0; c < groups_.size(); ++c) {
            auto& g = groups_[c];
            const Index n = g.data.wavevector.size();
            Array1D lines = Array1D::Ones(n);
            if (g.lines > 1) {
                const double noise = std::exp(fit_.log_noise[static_cast<Index>(c)]);
                const Array1D signal = (1.0 - g.data.noise_response * noise / fit_.expected[c]).max(0.0).min(1.0);
                lines = independent_lines(C_iso(), g.data.wavevector, signal, g.lines, g.pitch, options_.threads);
            }
            g.data.freedom = freedom(g, lines);
        }
    }

    [[nodiscard]] double median_wavelength() const {
        const double total = spline_moment(spline_, fit_.theta, 1.0, spline_.shortest()).value;
        const auto below_half = [&](double log_q) {
            return spline_moment(spline_, fit_.theta, 1.0, std::exp(log_q)).value < 0.5 * total;
        };
        const auto [lower, upper] = numerics::bisected(below_half, std::log(std::exp(spline_.position(1)) * 0.1),
                                                       std::log(spline_.shortest()), 40);
        return 2.0 * pi / std::exp(0.5 * (lower + upper));
    }

    /// C1D of the fit at ten wavevectors per decade.
    [[nodiscard]] spectra::SpectralDensity C1D() const {
        const double lowest = std::exp(spline_.position(1)), end = spline_.shortest();
        const auto nodes = static_cast<Index>(std::ceil(20.0 * std::log10(end / lowest)));
        const Array1D q = Array1D::LinSpaced(nodes + 1, std::log(lowest), std::log(end)).exp();
        const Array1D values = q.unaryExpr([&](double x) { return spline_.value(fit_.theta, std::min(x, end)); });
        Array1D line = spectra::profile_from_isotropic(q, values, q.head(nodes));
        const Array1D at = q.head(nodes);
        return spectra::tabulated_density(at, line);
    }

    [[nodiscard]] static bool read_with(const ObservedGroup& g, const std::string& probe) {
        return g.probe && g.probe->name == probe;
    }

    /// Simulates every tip on the fit: derivatives in the first round, only T in the others, on heights with the
    /// measured skewness. Returns whether T agreed with the expectation from the derivatives.
    bool simulate_tips() {
        if (rounds_ == 0) wavelength_ = median_wavelength();
        const auto line_density = C1D();
        std::set<std::string> done;
        double change = 0.0, weight = 0.0;
        for (auto& g : groups_) {
            if (!g.probe) continue;
            if (done.insert(g.probe->name).second) simulate_tip(*g.probe, line_density);
            const Array1D before = expected_transfer(g);
            g.tip = sampled(responses_.at(g.probe->name), line_density, g.pixel_size, g.data.wavevector);
            if (!g.probe->is_foil()) take_tip(g);
            const Array1D now = g.probe->is_foil() ? g.tip.log_transfer : Array1D((with_tip(g) / without_tip(g)).log());
            change += (g.data.freedom * (now - before).square()).sum();
            weight += g.data.freedom.sum();
            if (g.probe->is_foil()) {
                take_foil(g, now - before);
                continue;
            }
            const bool fine = g.probe->size < 0.25 * wavelength_;
            g.data.amplitude_order = fine ? 5.0 : 1.0;
            g.data.amplitude_end = fine ? pi / g.probe->size : spline_.shortest();
            g.data.reference_amplitude = amplitude(g);
        }
        flatten_below(end_of_unmeasured());
        return rounds_ > 0 && change < small_change * small_change * weight;
    }

    /// T of a foil multiplies the expectation of lines.
    static void take_foil(ObservedGroup& g, const Array1D& change) { g.data.response.colwise() *= change.exp(); }

    /// Followed and added power of the tip in the periodogram of the fitted surface, with their responses to C_iso ∝ A.
    void take_tip(ObservedGroup& g) const {
        const auto followed = followed_at(responses_.at(g.probe->name), g.data.nodes);
        g.data.probe = g.probe->name;
        g.data.log_followed = followed.log_square;
        g.data.followed_response = followed.response;
        g.data.added = g.tip.added_share * without_tip(g);
        g.data.added_response = g.tip.added_response;
        g.data.added_errors = g.tip.added_errors;
        g.data.reference_amplitude = 0.0;
    }

    /// End of the waves, longer than those that carry the heights, of which more than half of the measured power is
    /// added by a tip.
    [[nodiscard]] double end_of_unmeasured() const {
        constexpr double half = 0.5, longer = 3.0;
        double end = 0.0;
        for (const auto& g : groups_)
            for (Index k = 0; k < g.tip.log_transfer.size(); ++k)
                if (g.data.wavevector[k] < 2.0 * pi / (longer * wavelength_) &&
                    g.tip.added_share[k] > half * std::exp(g.tip.log_transfer[k]))
                    end = std::max(end, g.data.wavevector[k]);
        return end;
    }

    /// For waves that are almost not measured, ln C_iso is assumed to change by e^0.47 per decade.
    void flatten_below(double end) {
        constexpr double slope = 0.15;
        if (!(end > smoothness_.slope_end)) return;
        smoothness_.slope = slope;
        smoothness_.slope_end = end;
    }

    /// C_iso for the lines of a group at its nodes.
    [[nodiscard]] Array1D C_iso_of(const ObservedGroup& g) const {
        return surface_wavevectors(g.data).unaryExpr([&](double q) {
            return spline_.value(fit_.theta, std::min(q, spline_.shortest()));
        }) * surface_factors(g.data);
    }

    /// Periodogram of the fitted surface without tip and noise …
    [[nodiscard]] Array1D without_tip(const ObservedGroup& g) const {
        return (g.data.response.matrix() * C_iso_of(g).matrix()).array();
    }

    /// … and with the tip.
    [[nodiscard]] Array1D with_tip(const ObservedGroup& g) const {
        const double change =
            g.data.reference_amplitude > 0.0 ? std::log(amplitude(g) / g.data.reference_amplitude) : 0.0;
        const Array1D followed = C_iso_of(g) * (g.data.log_followed + g.data.followed_response * change).exp();
        return (g.data.response.matrix() * followed.matrix()).array() +
               g.data.added * (g.data.added_response * change).exp();
    }

    /// A sphere touches only points of a patch: this adds white noise of about step²/8R to the measured heights, C1D
    /// (step²/8R)² step. If that is more than a hundredth of C1D of the surface at half of the shortest waves of the
    /// patch, the patch is refined until it is a hundredth or less.
    [[nodiscard]] double fine_step(const Probe& probe, const spectra::SpectralDensity& line_density) const {
        constexpr double much = 0.01, finer = 0.3;
        const double least = 0.5 * options_.shortest_wavelength, radius = probe.size,
                     step = simulation_step(probe, wavelength_, least, options_.tip_points);
        if (probe.is_foil()) return step;
        const double noise = std::pow(step * step / (8.0 * radius), 2) * step;
        return noise > much * line_density(0.5 * pi / step) ? std::max(finer * step, least) : step;
    }

    void simulate_tip(const Probe& probe, const spectra::SpectralDensity& line_density) {
        const bool uncertain = std::any_of(groups_.begin(), groups_.end(), [&](const ObservedGroup& g) {
            return read_with(g, probe.name) && g.probe->size_error > 0.0;
        });
        const double step = fine_step(probe, line_density);
        // the power added by a tip to waves longer than the width of features needs many of them
        const bool has_long_waves = step * static_cast<double>(options_.tip_points) > waves_per_patch * wavelength_;
        TipSimulation simulation{.probe = probe,
                                 .step = step,
                                 .points = options_.tip_points,
                                 .length = has_long_waves ? options_.tip_length : options_.tip_points,
                                 .size_response = uncertain,
                                 .correlation_length = 0.5 * wavelength_,
                                 .seed = options_.seed,
                                 .threads = options_.threads};
        const auto skewness = surface_skewness(simulation);
        const bool newly_skewed = skewness.uncertain() && !skewness_[probe.name].uncertain();
        skewness_[probe.name] = skewness;
        simulation.skewness = skewness.value;
        simulation.skewness_response = skewness.uncertain();
        if (rounds_ == 0 || newly_skewed) {
            simulation.repetitions = 1;
            responses_[probe.name] = tip_response(C_iso(), simulation);
        } else {
            simulation.repetitions = has_long_waves ? 4 : 2;
            responses_[probe.name] = tip_response(C_iso(), simulation, responses_.at(probe.name));
        }
    }

    /// Skewness of the heights of the surface: measured skewness minus that added by the tip. 0 and exact unless the
    /// readings of at least three measurements show that the heights are not Gaussian, and if the simulated patch lacks
    /// the longest waves.
    [[nodiscard]] Estimate surface_skewness(const TipSimulation& simulation) const {
        constexpr double significant = 4.0;
        const Estimate gaussian{0.0, 0.0}, measured = measured_skewness(simulation.probe.name);
        if (!measured.uncertain() ||
            simulation.step * static_cast<double>(simulation.points) < waves_per_patch * wavelength_)
            return gaussian;
        auto skewed = simulation;
        if (rounds_ > 0) skewed.skewness = skewness_.at(simulation.probe.name).value;
        const double excess = measured.value - added_skewness(C_iso(), skewed);
        if (std::abs(excess) < significant * measured.standard_error) return gaussian;
        return {std::clamp(excess, -max_skewness, max_skewness), measured.standard_error};
    }

    /// Skewness of the heights measured by one tip, over its measurements; no standard error for fewer than three.
    [[nodiscard]] Estimate measured_skewness(const std::string& probe) const {
        std::vector<double> values;
        for (const auto& g : groups_)
            if (read_with(g, probe)) values.insert(values.end(), g.skewness.begin(), g.skewness.end());
        const auto n = static_cast<double>(values.size());
        double mean = 0.0, squares = 0.0;
        for (const double v : values) mean += v / n;
        for (const double v : values) squares += (v - mean) * (v - mean);
        return {mean, values.size() < 3 ? undefined : std::sqrt(squares / (n * (n - 1.0)))};
    }

    /// A that determines T.
    [[nodiscard]] double amplitude(const ObservedGroup& g) const {
        return spline_moment(spline_, fit_.theta, g.data.amplitude_order, g.data.amplitude_end).value;
    }

    /// ln T used in the fit.
    [[nodiscard]] Array1D expected_transfer(const ObservedGroup& g) const {
        if (g.probe->is_foil() && g.tip.log_transfer.size() > 0) return g.tip.log_transfer;
        if (!(g.data.reference_amplitude > 0.0)) return Array1D::Zero(g.data.wavevector.size());
        return (with_tip(g) / without_tip(g)).log();
    }

    /// Response of the spectrum to relative changes of the periodograms of a group.
    [[nodiscard]] Eigen::MatrixXd answer(std::size_t c) const {
        return fit_.gain * fit_.jacobian[c].transpose() * groups_[c].data.freedom.matrix().asDiagonal();
    }

    /// Covariance of the fit, plus contributions of uncertain skewness and noise of the simulation for each tip, of
    /// differences between whole measurements, and of the uncertainty of the stretch.
    [[nodiscard]] Eigen::MatrixXd own_covariance(const Scatter& scatter) const {
        Eigen::MatrixXd covariance = fit_.covariance;
        for (std::size_t c = 0; c < groups_.size(); ++c) {
            const auto found = scatter.find(groups_[c].data.instrument);
            if (found == scatter.end() || found->second.variance == 0.0) continue;
            const Eigen::VectorXd together = answer(c).rowwise().sum();
            covariance += together * together.transpose() * (found->second.normal_variance() / groups_[c].measurements);
        }
        for (const auto& [probe, response] : responses_) {
            // one column per repetition, then that of the skewness
            const Index repetitions = response.simulation_errors.rows();
            const auto& skewness = skewness_.at(probe);
            Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(fit_.theta.size(), repetitions + 1);
            for (std::size_t c = 0; c < groups_.size(); ++c) {
                const auto& g = groups_[c];
                if (!read_with(g, probe)) continue;
                const Eigen::MatrixXd answers = answer(c);
                moved.leftCols(repetitions) += answers * g.tip.simulation_errors.matrix().transpose();
                moved.col(repetitions) += answers * (g.tip.skewness_response * std::sqrt(skewness.variance())).matrix();
            }
            covariance += moved * moved.transpose();
        }
        if (!stretch_.isotropic()) {
            const auto by_stretch = answers_to_stretch(groups_, spline_, fit_, stretch_);
            Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(fit_.theta.size(), stretch_covariance_.rows());
            for (std::size_t c = 0; c < groups_.size(); ++c) moved += answer(c) * by_stretch[c];
            covariance += moved * stretch_covariance_ * moved.transpose();
        }
        return covariance;
    }

    /// Wavevectors of C_iso with data: for stretched surfaces q/μ of lines along q, the whole C_iso to its end if lines
    /// reach it.
    [[nodiscard]] Band used_band() const {
        constexpr double nearly = 0.97;
        Band band{std::numeric_limits<double>::infinity(), 0.0};
        for (const auto& g : groups_)
            for (Index k = 0; k < g.data.wavevector.size(); ++k)
                if (inside(g, k)) {
                    const double q = g.data.wavevector[k],
                                 surface = q / std::sqrt(stretch_.at(q).length_square(g.direction));
                    band.lower = std::min(band.lower, surface);
                    band.upper = std::max(band.upper, surface);
                }
        const bool whole = band.upper > nearly * surface_end(stretch_, spline_.shortest());
        if (!stretch_.isotropic() && whole) band.upper = spline_.shortest();
        return band;
    }

    /// Warns if the contribution of the longest measured waves to the mean square height, q² C_iso per ln q, is about
    /// as large as the maximum.
    static void add_rolloff_alert(LikelihoodSpectrum& r) {
        constexpr double much = 0.5;
        const auto& q = r.C_iso.wavevector;
        const Array1D height = (q >= r.C_iso.band.lower).select(q.square() * r.C_iso.density, 0.0);
        const auto first = std::lower_bound(q.begin(), q.end(), r.C_iso.band.lower) - q.begin();
        if (first == q.size() || height[first] < much * height.maxCoeff()) return;
        r.alerts.push_back(
            {"ROLLOFF_NOT_SEEN", "spectrum",
             fmt::format("C1D still rises at the longest wavelength, {:.3g} um: rms height and stored energy contain "
                         "only shorter waves",
                         2.0e6 * pi / r.C_iso.band.lower),
             "scan longer until C1D is flat; the W_app predicted for a wider contact needs those waves"});
    }

    /// Errors of s and φ0 to first order in those of λ (cos 2φ0, sin 2φ0).
    void add_stretch(LikelihoodSpectrum& r) const {
        for (Index knot = 0; knot < stretch_.knots(); ++knot) {
            const double wavevector = std::exp(stretch_.log_wavevector(knot));
            const auto stretch = stretch_.at(wavevector);
            const Eigen::Matrix2d covariance = stretch_covariance_.block<2, 2>(2 * knot, 2 * knot);
            const double size = stretch.vector.norm();
            const Eigen::Vector2d along = stretch.vector / size, across(-along[1], along[0]);
            r.stretch.push_back({wavevector,
                                 {stretch.ratio(), stretch.ratio() * std::sqrt(along.dot(covariance * along))},
                                 {stretch.direction(), 0.5 / size * std::sqrt(across.dot(covariance * across))}});
        }
        if (r.stretch.empty()) return;
        std::string found;
        for (const auto& s : r.stretch)
            found += fmt::format("{}{:.3g} ± {:.2g} times along {:.0f} ± {:.0f} degrees{}", found.empty() ? "" : ", ",
                                 s.ratio.value, s.ratio.standard_error, s.direction.value * 180.0 / pi,
                                 s.direction.standard_error * 180.0 / pi,
                                 r.stretch.size() > 1 ? fmt::format(" at {:.2g} 1/m", s.wavevector) : "");
        r.alerts.push_back(
            {"STRETCHED", "spectrum",
             fmt::format(
                 "features are longer along one direction than across it: {}; the results are those of the mean "
                 "over directions",
                 found),
             "give the direction of each file (direction) if it is not x for all files"});
    }

    std::vector<ObservedGroup> groups_;
    StretchOfMaps maps_;
    KnownStretch known_stretch_;
    StretchLaw stretch_;  ///< used by the groups
    Eigen::MatrixXd stretch_covariance_;
    LikelihoodOptions options_;
    LogSpline spline_;
    Smoothness smoothness_;
    WhittleFit fit_;
    std::map<std::string, TipResponse> responses_;  ///< by probe
    std::map<std::string, Estimate> skewness_;      ///< of the heights of the surface, by the tip that measured them
    double wavelength_ = 0.0;                       ///< half of ∫ q C_iso dq is below it
    int rounds_ = 0;
};

StretchOfMaps stretch_of_maps(std::span<const ObservedSurface> observed, const LikelihoodOptions& options) {
    std::vector<ObservedStretch> all;
    for (const auto& o : observed) {
        const auto* map = std::get_if<topography::HeightMap>(&o.measurement);
        if (!map) continue;
        const auto reliable = spectra::reliable_band(*map, {.both_directions = true}, options.threads).band;
        const Band band{std::max(reliable.lower, o.untouched.lower), std::min(reliable.upper, o.untouched.upper)};
        const double turn = 2.0 * o.direction;
        const Eigen::Matrix2d turned{{std::cos(turn), -std::sin(turn)}, {std::sin(turn), std::cos(turn)}};
        for (auto& one : observed_stretch(*map, band, options.threads)) {
            one.stretch.vector = turned * one.stretch.vector;
            one.information = turned * one.information * turned.transpose();
            all.push_back(one);
        }
    }
    return combined_stretch(all);
}

}  // namespace

LikelihoodSpectrum likelihood_spectrum(std::span<const ObservedSurface> observed, const LikelihoodOptions& options) {
    const auto range = spectrum_range(observed, options);
    JointFit fit(observed_groups(observed, range, options), stretch_of_maps(observed, options), range, options);
    fit.run();
    return fit.result();
}

Eigen::MatrixXd LikelihoodSpectrum::total_covariance() const {
    Eigen::MatrixXd total = covariance;
    for (const auto& input : inputs) total += input.theta * input.theta.transpose();
    return total;
}

Array2D drawn_spectra(const LikelihoodSpectrum& spectrum, Index count, std::uint64_t seed) {
    const Index n = spectrum.theta.size();
    const auto lower = numerics::cholesky(0.5 * (spectrum.covariance + spectrum.covariance.transpose()));
    if (!lower) throw InternalError("the covariance of the spectrum is not positive definite");
    Array2D result(count, spectrum.C_iso.wavevector.size());
    Array1D normal(n);
    for (Index r = 0; r < count; ++r) {
        numerics::fill_normal({seed, 0}, static_cast<std::uint64_t>(r * n), normal);
        result.row(r) = spectrum.C_iso.density.transpose() *
                        (spectrum.design * (*lower * normal.matrix())).array().exp().transpose();
    }
    return result;
}

}  // namespace setae::spectral_fit
