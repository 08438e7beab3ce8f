// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/work_posterior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "drawn_inputs.hpp"
#include "pair_least_squares.hpp"
#include "setae/adhesion/marginal_scatter.hpp"
#include "setae/adhesion/scatter_effects.hpp"
#include "setae/core/component_rows.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/rectified.hpp"
#include "setae/core/statistics.hpp"

namespace setae::adhesion {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// Nodes while inputs are fitted; the density uses all of them.
constexpr ScatterNodes coarse_nodes{5, 4, 4};

std::vector<PairLabels> labels_of(const std::vector<PairPoint>& pairs) {
    std::vector<PairLabels> labels;
    for (const auto& pair : pairs) labels.push_back({pair.surface, pair.elastomer});
    return labels;
}

double prior_scale(const std::vector<PairPoint>& pairs) {
    std::vector<double> measured;
    double squares = 0.0;
    const double work = least_squares(pairs).x;
    for (const auto& pair : pairs) {
        measured.push_back(std::abs(pair.measured.value));
        squares += std::pow(pair.measured.value - pair.prediction(work), 2);
    }
    constexpr double of_median = 0.4, of_residual = 2.0, least = 1e-6;
    const double median = upper_median(measured), largest = *std::ranges::max_element(measured);
    const double residual = std::sqrt(squares / static_cast<double>(pairs.size()));
    return std::max(least * largest, std::min(of_median * median, of_residual * residual));
}

/// exp(change) of a number above 0; one that is 0 or below moves in a straight line.
double moved(double value, double change) { return value > 0.0 ? value * std::exp(change / value) : value + change; }

/// Change of moved() by `change`, from the present value.
double response(double value, double at) { return value > 0.0 ? at / value : 1.0; }

}  // namespace

/// Pairs with the inputs of their lines, standardised: four numbers per pair, all pairs of one kind in sequence.
class WorkPosterior::Balance {
public:
    enum Part : Index { slope, offset, measured, fitted, parts };

    explicit Balance(const std::vector<PairPoint>& of)
        : pairs(of),
          size(static_cast<Index>(of.size())),
          scatter(labels_of(of), prior_scale(of)),
          coarse(labels_of(of), prior_scale(of), coarse_nodes) {
        std::vector<const Components*> values;
        for (const auto part : {&PairPoint::slope_inputs, &PairPoint::offset_inputs, &PairPoint::in_unitputs,
                                &PairPoint::measured_noise})
            for (const auto& pair : pairs) values.push_back(&(pair.*part));
        const MatrixXd rows = component_rows(values);
        covariance.noalias() = rows * rows.transpose();
        samples = rows * normal_matrix({sample_seed, 0}, rows.cols());
        noise = normal_matrix({sample_seed, 1}, size);
        of_pairs = normal_matrix({sample_seed, 2}, size);
        of_surfaces = grouped(normal_matrix({sample_seed, 3}, size), &PairPoint::surface);
        of_elastomers = grouped(normal_matrix({sample_seed, 4}, size), &PairPoint::elastomer);
        own.resize(size);
        const double least = 1e-9 * largest();
        for (Index i = 0; i < size; ++i) own[i] = pairs[to(i)].own_variance() + least * least;
    }

    static std::size_t to(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] double largest() const {
        double most = 0.0;
        for (const auto& pair : pairs) most = std::max(most, std::abs(pair.measured.value));
        return most;
    }

    /// Residuals of the measured values at changes x, without the scatter and the own noise.
    [[nodiscard]] VectorXd residual_at(double work, const VectorXd& x) const {
        VectorXd result(size);
        for (Index i = 0; i < size; ++i) {
            const auto& pair = pairs[to(i)];
            const double raw = work * moved(pair.slope, x[slope * size + i]) - moved(pair.offset, x[offset * size + i]);
            const double predicted = pair.floored ? std::max(0.0, raw) : raw;
            const double relative = pair.measured.value > 0.0 ? predicted / pair.measured.value : 1.0;
            result[i] = pair.measured.value - predicted - relative * x[measured * size + i] - x[fitted * size + i];
        }
        return result;
    }

    std::vector<PairPoint> pairs;
    Index size;
    MarginalScatter scatter, coarse;
    MatrixXd covariance;  ///< covariance of changes of slopes, offsets and measured values, [as these]
    VectorXd own;         ///< variance of each pair's own noise
    /// Random numbers of the samples that correct the linearisation, one column per sample: changes, and standard
    /// normal noise and effects of the pairs. Equal at every W, so that their noise cancels in ratios of densities.
    MatrixXd samples, noise, of_pairs, of_surfaces, of_elastomers;

private:
    static constexpr std::uint64_t sample_seed = 1;
    static constexpr Index sample_count = 200;

    static MatrixXd normal_matrix(numerics::RandomKey key, Index rows) {
        return numerics::normal_numbers(key, 0, rows * sample_count).matrix().reshaped(rows, sample_count);
    }
    /// Replaces each number by that of the first pair of its group.
    [[nodiscard]] MatrixXd grouped(MatrixXd numbers, std::string PairPoint::*label) const {
        for (Index i = 0; i < size; ++i)
            for (Index j = 0; j < i; ++j)
                if (pairs[to(j)].*label == pairs[to(i)].*label) {
                    numbers.row(i) = numbers.row(j);
                    break;
                }
        return numbers;
    }
};

namespace {

/// Scatter at which a posterior has fallen below each of its nodes in turn, for draws.
using CumulativeScatter = std::vector<std::pair<double, ModelScatter>>;

const ModelScatter& drawn_scatter(const CumulativeScatter& cumulative, double uniform) {
    for (const auto& [below, scatter] : cumulative)
        if (uniform <= below) return scatter;
    return cumulative.back().second;
}

CumulativeScatter cumulative_scatter(const MarginalScatter& scatter, const MatrixXd& covariance,
                                     const VectorXd& residual) {
    CumulativeScatter found;
    LogSum all;
    scatter.visit(covariance, [&](const MarginalScatter::Node& node) {
        const VectorXd whitened = node.factor.matrixL().solve(residual);
        const double log_density =
            -0.5 * whitened.squaredNorm() - node.factor.matrixLLT().diagonal().array().log().sum();
        all.add(log_density);
        found.emplace_back(log_density, node.scatter);
    });
    double sum = 0.0;
    for (auto& [density, at] : found) density = sum += std::exp(density - all.value());
    return found;
}

}  // namespace

/// The balance at one W, a straight line in the changes x of slopes, offsets and measured values about where the pairs
/// put them:
///
///   y − f = residual − J x,  variance of J x: shared
struct WorkPosterior::At {
    MatrixXd jacobian;  ///< pairs × changes
    VectorXd residual;  ///< at x = 0
    VectorXd left;      ///< variance of the remainder of max(0, …) after linearisation
    MatrixXd shared;    ///< J cov Jᵀ, own noise and remainder after linearisation
    /// Variance of each pair's own noise, at least (1/20)² of the variance by the inputs: below that, the curvature of
    /// the inputs' effects would be treated as a deviation of the measurement.
    VectorXd own;

    /// At one scatter.
    struct Factors {
        /// Cholesky factors of all errors; of the own noise; and of the linearised model
        Eigen::LLT<MatrixXd> shared, own, straight;
    };
    [[nodiscard]] Factors factors(const Balance& balance, const ModelScatter& scatter) const {
        const VectorXd straight = own + left;
        return {Eigen::LLT<MatrixXd>(balance.scatter.with(shared, scatter)),
                Eigen::LLT<MatrixXd>(balance.scatter.with(own.asDiagonal(), scatter)),
                Eigen::LLT<MatrixXd>(balance.scatter.with(straight.asDiagonal(), scatter))};
    }

    /// ln of the density of the pairs over that by the straight line, at changes x and a scatter.
    [[nodiscard]] double log_weight(const Balance& balance, double work, const VectorXd& x,
                                    const Factors& at_scatter) const {
        const auto density = [&](const Eigen::LLT<MatrixXd>& factor, const VectorXd& missing) {
            const VectorXd whitened = factor.matrixL().solve(missing);
            return -0.5 * whitened.squaredNorm() - factor.matrixLLT().diagonal().array().log().sum();
        };
        return density(at_scatter.own, balance.residual_at(work, x)) -
               density(at_scatter.straight, residual - jacobian * x);
    }
};

namespace {

/// max(0, x) as a straight line in x, x normal: its mean, its slope, and the variance that the line leaves.
struct StraightFloor {
    double mean = 0.0, slope = 0.0, left = 0.0;
};

StraightFloor straight_floor(double raw, double deviation, bool floored) {
    if (!floored) return {raw, 1.0, 0.0};
    if (!(deviation > 0.0)) return {std::max(0.0, raw), raw > 0.0 ? 1.0 : 0.0, 0.0};
    const double z = raw / deviation, above = normal_probability(z),
                 density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * pi);
    const double share = rectified_share(raw, deviation);
    return {deviation * (z * above + density), above,
            deviation * deviation * std::max(0.0, share * share - above * above)};
}

}  // namespace

WorkPosterior::At WorkPosterior::at(double work) const {
    constexpr double resolved = 0.05;
    const auto& b = *balance_;
    const Index n = b.size;
    using B = Balance;
    VectorXd x = VectorXd::Zero(B::parts * n);
    VectorXd variance;  // variance of slope · W − offset, in the posterior
    At found;
    const auto look = [&] {
        MatrixXd raw_jacobian = MatrixXd::Zero(n, B::parts * n);
        VectorXd raw(n);
        for (Index i = 0; i < n; ++i) {
            const auto& pair = b.pairs[B::to(i)];
            const Index s = B::slope * n + i, o = B::offset * n + i;
            const double slope = moved(pair.slope, x[s]), offset = moved(pair.offset, x[o]);
            raw[i] = work * slope - offset;
            raw_jacobian(i, s) = work * response(pair.slope, slope);
            raw_jacobian(i, o) = -response(pair.offset, offset);
        }
        const MatrixXd shared_raw = b.covariance * raw_jacobian.transpose();
        const VectorXd prior = (raw_jacobian * shared_raw).diagonal();
        if (variance.size() == 0) variance = prior;
        found.jacobian = MatrixXd::Zero(n, B::parts * n);
        found.residual.resize(n);
        found.left.resize(n);
        for (Index i = 0; i < n; ++i) {
            const auto& pair = b.pairs[B::to(i)];
            const Index m = B::measured * n + i, e = B::fitted * n + i;
            const auto line = straight_floor(raw[i], std::sqrt(std::max(0.0, variance[i])), pair.floored);
            const double relative = pair.measured.value > 0.0 ? line.mean / pair.measured.value : 1.0;
            found.jacobian.row(i) = line.slope * raw_jacobian.row(i);
            // errors of the measured value are included in the prediction
            found.jacobian(i, m) = relative;
            found.jacobian(i, e) = 1.0;
            const double errors = relative * x[m] + x[e];
            found.residual[i] = pair.measured.value - line.mean - errors + found.jacobian.row(i).dot(x);
            found.left[i] = line.left;
        }
        found.shared = found.jacobian * b.covariance * found.jacobian.transpose();
        found.own = b.own.cwiseMax(resolved * resolved * found.shared.diagonal());
        found.shared.diagonal() += found.own + found.left;
        const auto scatter = b.coarse.posterior_scatter(found.shared, found.residual);
        const Eigen::LLT<MatrixXd> factor(b.coarse.with(found.shared, scatter));
        const MatrixXd known = factor.matrixL().solve(found.jacobian * shared_raw);
        variance = prior - known.colwise().squaredNorm().transpose();
        return VectorXd(b.covariance * (found.jacobian.transpose() * factor.solve(found.residual)));
    };
    constexpr int steps = 8;
    constexpr double damping = 0.6;
    for (int step = 0; step < steps; ++step) x += damping * (look() - x);
    (void)look();
    return found;
}

/// ln of the density of the pairs at a W: of the straight line, scatter integrated out, times the mean weight of
/// samples drawn from it.
WorkPosterior::LogDensity WorkPosterior::log_density(double work) const {
    const auto& b = *balance_;
    const auto there = at(work);
    const double straight = b.scatter.log_densities(there.shared, there.residual)[0];
    const auto scatters = cumulative_scatter(b.coarse, there.shared, there.residual);
    const MatrixXd gain = b.covariance * there.jacobian.transpose();
    const auto count = b.samples.cols();
    const VectorXd own_errors = VectorXd(there.own + there.left).cwiseSqrt();
    LogSum weights;
    const ModelScatter* factored = nullptr;  // draws of one scatter come after each other
    At::Factors factors;
    for (Index d = 0; d < count; ++d) {
        const auto& scatter = drawn_scatter(scatters, (static_cast<double>(d) + 0.5) / static_cast<double>(count));
        if (&scatter != factored) factors = there.factors(b, scatter);
        factored = &scatter;
        const VectorXd missing = there.residual - there.jacobian * b.samples.col(d) -
                                 own_errors.cwiseProduct(b.noise.col(d)) - scatter.pair * b.of_pairs.col(d) -
                                 scatter.surface * b.of_surfaces.col(d) - scatter.elastomer * b.of_elastomers.col(d);
        const VectorXd x = b.samples.col(d) + gain * factors.shared.solve(missing);
        weights.add(there.log_weight(b, work, x, factors));
    }
    return {straight, weights.value() - std::log(static_cast<double>(count))};
}

WorkPosterior::WorkPosterior(const std::vector<PairPoint>& pairs) {
    require_pairs(pairs);
    balance_ = std::make_unique<Balance>(pairs);
    find_grid();
    const auto quantile = [this](double p) {
        const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end(), p) - cumulative_.begin();
        const auto k = std::clamp<Index>(above, 1, grid_.size() - 1);
        const double piece = cumulative_[k] - cumulative_[k - 1];
        return grid_[k - 1] + (piece > 0.0 ? (p - cumulative_[k - 1]) / piece : 0.0) * (grid_[k] - grid_[k - 1]);
    };
    const Index n = grid_.size();
    double mean = 0.0, square = 0.0;
    for (Index k = 1; k < n; ++k) {
        const double p = cumulative_[k] - cumulative_[k - 1], x = 0.5 * (grid_[k] + grid_[k - 1]);
        mean += p * x;
        square += p * x * x;
    }
    constexpr double tail = 0.025;
    work_ = {.value = quantile(0.5),
             .standard_error = std::sqrt(std::max(0.0, square - mean * mean)),
             .method = "posterior",
             .interval = Interval{quantile(tail), quantile(1.0 - tail), 1.0 - 2.0 * tail}};
    const auto median = at(work_.value);
    scatter_ = balance_->scatter.posterior_scatter(median.shared, median.residual);
}

WorkPosterior::~WorkPosterior() = default;
WorkPosterior::WorkPosterior(WorkPosterior&&) noexcept = default;
WorkPosterior& WorkPosterior::operator=(WorkPosterior&&) noexcept = default;

/// ln densities on the grid, outward from the point nearest to the maximum: the search stops beyond a W that the pairs
/// exclude, because the linearisation is meaningless far from the pairs.
Array1D WorkPosterior::log_densities_about(double likeliest) {
    constexpr double refused = 50.0;
    const Index points = grid_.size();
    Array1D logarithms = Array1D::Constant(points, -std::numeric_limits<double>::infinity());
    correction_ = Array1D::Zero(points);
    double highest = -std::numeric_limits<double>::infinity();
    const auto look = [&](Index k) {
        const auto there = log_density(grid_[k]);
        correction_[k] = there.correction;
        logarithms[k] = there.straight + there.correction;
        highest = std::max(highest, logarithms[k]);
        return logarithms[k] > highest - refused;
    };
    Index nearest = 0;
    (grid_ - likeliest).abs().minCoeff(&nearest);
    (void)look(nearest);
    for (Index k = nearest + 1; k < points && look(k); ++k) {
    }
    for (Index k = nearest - 1; k >= 0 && look(k); --k) {
    }
    return logarithms;
}

/// Zooms in until the grid resolves the peak: densities e⁻¹⁰ of the highest end it.
void WorkPosterior::find_grid() {
    constexpr Index points = 41;
    constexpr int zooms = 12;
    constexpr double depth = 10.0;
    constexpr Index resolved = 25;
    double likeliest = std::max(fit_generalised(balance_->pairs).work_of_adhesion.value, 1e-6 * balance_->largest());
    double lower = 0.02 * likeliest, upper = 3.0 * likeliest;
    Array1D logarithms;
    for (int zoom = 0; zoom < zooms; ++zoom) {
        grid_ = Array1D::LinSpaced(points, lower, upper);
        logarithms = log_densities_about(likeliest);
        Index peak = 0, first = 0, last = points - 1;
        const double highest = logarithms.maxCoeff(&peak);
        likeliest = grid_[peak];
        while (logarithms[first] < highest - depth) ++first;
        while (logarithms[last] < highest - depth) --last;
        const double step = grid_[1] - grid_[0];
        const bool beyond = last == points - 1 && logarithms[last] > highest - depth + 2.0;
        if (!beyond && last - first + 1 >= resolved) break;
        lower = first == 0 ? lower : grid_[first] - step;
        upper = beyond ? upper + 0.5 * (upper - lower) : std::min(upper, grid_[last] + step);
    }
    const double highest = logarithms.maxCoeff();
    density_ = (logarithms - highest).exp();
    cumulative_ = Array1D::Zero(points);
    for (Index k = 1; k < points; ++k)
        cumulative_[k] = cumulative_[k - 1] + 0.5 * (density_[k] + density_[k - 1]) * (grid_[k] - grid_[k - 1]);
    const double total = cumulative_[points - 1];
    if (!(total > 0.0) || !std::isfinite(total))
        throw UndefinedDataError("the likelihood of the measured pairs has no maximum over W_int");
    density_ /= total;
    cumulative_ /= total;
    log_evidence_ = highest + std::log(total);
}

namespace {

/// Effects of surfaces, elastomers and pairs, as the pairs leave them.
class DrawnEffects {
public:
    DrawnEffects(const std::vector<PairPoint>& pairs, const ModelScatter& scatter, numerics::RandomKey key)
        : pairs_(pairs), scatter_(scatter), drawn_(scatter, key) {}

    /// Draw of a pair before it is conditioned on its measurement.
    [[nodiscard]] double prior(const PairPoint& pair) { return drawn_.of(pair.surface, pair.elastomer); }

    /// pull: V⁻¹ (measured − drawn), one number per pair.
    void take(const VectorXd& pull) { pull_ = pull; }

    [[nodiscard]] double operator()(const PairPoint& pair) {
        double sum = prior(pair);
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            const bool surface = pairs_[i].surface == pair.surface, elastomer = pairs_[i].elastomer == pair.elastomer;
            const double variance = (surface ? scatter_.surface * scatter_.surface : 0.0) +
                                    (elastomer ? scatter_.elastomer * scatter_.elastomer : 0.0) +
                                    (surface && elastomer ? scatter_.pair * scatter_.pair : 0.0);
            sum += variance * pull_[static_cast<Index>(i)];
        }
        return sum;
    }

private:
    const std::vector<PairPoint>& pairs_;
    ModelScatter scatter_;
    ScatterEffects drawn_;
    VectorXd pull_;
};

/// Systematic resampling by weights: draws `count` indices.
std::vector<std::size_t> resampled(const std::vector<double>& log_weights) {
    LogSum all;
    for (const double weight : log_weights) all.add(weight);
    std::vector<std::size_t> chosen;
    const auto count = static_cast<double>(log_weights.size());
    double sum = 0.0;
    for (std::size_t d = 0; d < log_weights.size(); ++d) {
        sum += std::exp(log_weights[d] - all.value());
        while (static_cast<double>(chosen.size()) + 0.5 < sum * count) chosen.push_back(d);
    }
    while (chosen.size() < log_weights.size()) chosen.push_back(log_weights.size() - 1);
    return chosen;
}

}  // namespace

BalanceDraws WorkPosterior::draw(const std::vector<PairPoint>& lines, int count, std::uint64_t seed) const {
    const auto& b = *balance_;
    using B = Balance;
    Deviates deviates;
    for (const auto* list : {&b.pairs, &lines})
        for (const auto& pair : *list) deviates.add_inputs_of(pair);
    struct Place {
        At at;
        CumulativeScatter scatters;
    };
    std::vector<std::optional<Place>> places(static_cast<std::size_t>(grid_.size()));
    const auto place_at = [&](Index k) -> const Place& {
        auto& place = places[B::to(k)];
        if (!place) {
            auto there = at(grid_[k]);
            auto scatters = cumulative_scatter(b.coarse, there.shared, there.residual);
            place.emplace(Place{std::move(there), std::move(scatters)});
        }
        return *place;
    };
    std::vector<double> works, log_weights;
    std::vector<std::vector<double>> predictions(lines.size());
    for (int d = 0; d < count; ++d) {
        const numerics::RandomKey key{seed, static_cast<std::uint64_t>(d)};
        const double p = numerics::uniform_number(substream(key, 3), 0);
        const auto k = std::clamp<Index>(
            std::upper_bound(cumulative_.begin(), cumulative_.end(), p) - cumulative_.begin(), 1, grid_.size() - 1);
        const double piece = cumulative_[k] - cumulative_[k - 1],
                     way = piece > 0.0 ? (p - cumulative_[k - 1]) / piece : 0.0;
        const double work = grid_[k - 1] + way * (grid_[k] - grid_[k - 1]);
        const Index nearest = way < 0.5 ? k - 1 : k;
        const auto& place = place_at(nearest);
        const auto& scatter = drawn_scatter(place.scatters, numerics::uniform_number(substream(key, 3), 1));
        deviates.draw(substream(key, 0));
        DrawnEffects effects(b.pairs, scatter, substream(key, 1));
        const auto noise = numerics::normal_numbers(substream(key, 2), 0, b.size);
        // simulated measurements at the drawn inputs, and their difference from the measured values
        VectorXd change(B::parts * b.size);
        for (Index i = 0; i < b.size; ++i) {
            const auto& pair = b.pairs[B::to(i)];
            change[B::slope * b.size + i] = deviates.moved(pair.slope_inputs);
            change[B::offset * b.size + i] = deviates.moved(pair.offset_inputs);
            change[B::measured * b.size + i] = deviates.moved(pair.in_unitputs);
            change[B::fitted * b.size + i] = deviates.moved(pair.measured_noise);
        }
        VectorXd missing = place.at.residual - place.at.jacobian * change;
        for (Index i = 0; i < b.size; ++i)
            missing[i] -= effects.prior(b.pairs[B::to(i)]) + std::sqrt(place.at.own[i] + place.at.left[i]) * noise[i];
        const auto factors = place.at.factors(b, scatter);
        const VectorXd pull = factors.shared.solve(missing);
        effects.take(pull);
        const VectorXd by_change = place.at.jacobian.transpose() * pull;
        for (Index i = 0; i < b.size; ++i) {
            const auto& pair = b.pairs[B::to(i)];
            deviates.pull(pair.slope_inputs, by_change[B::slope * b.size + i]);
            deviates.pull(pair.offset_inputs, by_change[B::offset * b.size + i]);
            deviates.pull(pair.in_unitputs, by_change[B::measured * b.size + i]);
            deviates.pull(pair.measured_noise, by_change[B::fitted * b.size + i]);
        }
        deviates.take_pulls();
        works.push_back(work);
        // about its mean at this W, which the density of W has in it
        log_weights.push_back(place.at.log_weight(b, work, change + b.covariance * by_change, factors) -
                              correction_[nearest]);
        for (std::size_t l = 0; l < lines.size(); ++l) {
            auto line = lines[l];
            line.slope = moved(line.slope, deviates.moved(line.slope_inputs));
            line.offset = moved(line.offset, deviates.moved(line.offset_inputs));
            double predicted = line.prediction(work);
            if (!line.departure.empty()) predicted += effects(line);
            predictions[l].push_back(line.floored ? std::max(0.0, predicted) : predicted);
        }
    }
    const auto chosen = resampled(log_weights);
    const auto value_of = [&](double value, const std::vector<double>& drawn) {
        std::vector<double> kept;
        for (const auto d : chosen) kept.push_back(drawn[d]);
        return drawn_value(value, std::move(kept));
    };
    BalanceDraws result{.count = count, .seed = seed};
    result.work_of_adhesion = value_of(work_.value, works);
    for (std::size_t l = 0; l < lines.size(); ++l)
        result.predictions.push_back(value_of(lines[l].prediction(work_.value), predictions[l]));
    return result;
}

TracedValue traced_work(const WorkPosterior& posterior, const std::vector<PairPoint>& pairs) {
    const auto& work = posterior.work_of_adhesion();
    auto traced = generalised_at(pairs, work.value, posterior.scatter()).work_of_adhesion;
    const double error = traced.standard_error(), scale = error > 0.0 ? work.standard_error / error : 1.0;
    for (auto& [name, component] : traced.components) component.directions *= scale;
    return traced;
}

}  // namespace setae::adhesion
