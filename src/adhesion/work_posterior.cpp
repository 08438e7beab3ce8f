// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/work_posterior.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "drawn_inputs.hpp"
#include "pair_least_squares.hpp"
#include "setae/adhesion/marginal_scatter.hpp"
#include "setae/core/component_rows.hpp"
#include "setae/core/errors.hpp"

namespace setae::adhesion {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// Of nodes while inputs are looked for; the density itself takes all of them.
constexpr ScatterNodes coarse_nodes{5, 4, 4};

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

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
    const double median = median_of(measured), largest = *std::ranges::max_element(measured);
    const double residual = std::sqrt(squares / static_cast<double>(pairs.size()));
    return std::max(least * largest, std::min(of_median * median, of_residual * residual));
}

/// exp(change) of a number above 0; one that is 0 or below moves in a straight line.
double moved(double value, double change) { return value > 0.0 ? value * std::exp(change / value) : value + change; }

/// What moved() changes by with `change`, from where it is.
double response(double value, double at) { return value > 0.0 ? at / value : 1.0; }

}  // namespace

/// Pairs with what their lines rest on, standardised: four numbers a pair, all pairs of one kind after the other.
class WorkPosterior::Balance {
public:
    enum Part : Index { slope, offset, measured, noise, parts };

    explicit Balance(const std::vector<PairPoint>& of)
        : pairs(of),
          size(static_cast<Index>(of.size())),
          scatter(labels_of(of), prior_scale(of)),
          coarse(labels_of(of), prior_scale(of), coarse_nodes) {
        std::vector<const Components*> values;
        for (const auto part : {&PairPoint::slope_inputs, &PairPoint::offset_inputs, &PairPoint::measured_inputs,
                                &PairPoint::measured_noise})
            for (const auto& pair : pairs) values.push_back(&(pair.*part));
        const MatrixXd rows = component_rows(values);
        covariance.noalias() = rows * rows.transpose();
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

    std::vector<PairPoint> pairs;
    Index size;
    MarginalScatter scatter, coarse;
    MatrixXd covariance;  ///< of changes of slopes, offsets and measured values, [as these]
    VectorXd own;         ///< variance of each pair's own noise
};

/// The balance at one W, a straight line in the changes x of slopes, offsets and measured values about where the pairs
/// put them:
///
///   y − f = residual − J x,  variance of J x: shared
struct WorkPosterior::At {
    MatrixXd jacobian;  ///< pairs × changes
    VectorXd residual;  ///< at x = 0
    MatrixXd shared;    ///< J cov Jᵀ and the own noise
};

namespace {

/// Share of a small change that the floor lets through, seen over one standard error to either side.
double secant_share(double raw, double deviation, bool floored) {
    if (!floored) return 1.0;
    if (!(deviation > 0.0)) return raw > 0.0 ? 1.0 : 0.0;
    return std::clamp(0.5 * (1.0 + raw / deviation), 0.0, 1.0);
}

}  // namespace

WorkPosterior::At WorkPosterior::at(double work) const {
    const auto& b = *balance_;
    const Index n = b.size;
    using B = Balance;
    VectorXd x = VectorXd::Zero(B::parts * n);
    At found;
    const auto look = [&] {
        found.jacobian = MatrixXd::Zero(n, B::parts * n);
        found.residual.resize(n);
        for (Index i = 0; i < n; ++i) {
            const auto& pair = b.pairs[B::to(i)];
            const Index s = B::slope * n + i, o = B::offset * n + i, m = B::measured * n + i, e = B::noise * n + i;
            const double slope = moved(pair.slope, x[s]), offset = moved(pair.offset, x[o]);
            const double raw = work * slope - offset;
            const double by_slope = work * response(pair.slope, slope), by_offset = -response(pair.offset, offset);
            const double variance = by_slope * by_slope * b.covariance(s, s) + by_offset * by_offset * b.covariance(o, o) +
                                    2.0 * by_slope * by_offset * b.covariance(s, o);
            const double share = secant_share(raw, std::sqrt(std::max(0.0, variance)), pair.floored);
            const double predicted = pair.floored ? std::max(0.0, raw) : raw;
            const double relative = pair.measured.value > 0.0 ? predicted / pair.measured.value : 1.0;
            found.jacobian(i, s) = share * by_slope;
            found.jacobian(i, o) = share * by_offset;
            // measured = truth + its errors: they count on the side of the prediction
            found.jacobian(i, m) = relative;
            found.jacobian(i, e) = 1.0;
            const double errors = relative * x[m] + x[e];
            found.residual[i] = pair.measured.value - predicted - errors + (found.jacobian.row(i) * x)(0);
        }
        found.shared = found.jacobian * b.covariance * found.jacobian.transpose();
        found.shared.diagonal() += b.own;
    };
    constexpr int steps = 6;
    constexpr double damping = 0.6;
    for (int step = 0; step < steps; ++step) {
        look();
        const auto scatter = b.coarse.posterior_scatter(found.shared, found.residual);
        const Eigen::LLT<MatrixXd> factor(b.coarse.with(found.shared, scatter));
        const VectorXd there = b.covariance * (found.jacobian.transpose() * factor.solve(found.residual));
        x += damping * (there - x);
    }
    look();
    return found;
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

/// Zooms in until the grid resolves the peak: densities e⁻¹⁰ of the highest end it.
void WorkPosterior::find_grid() {
    constexpr Index points = 41;
    constexpr int zooms = 12;
    constexpr double depth = 10.0;
    constexpr Index resolved = 25;
    const double start = std::max(least_squares(balance_->pairs).x, 1e-6 * balance_->largest());
    double lower = 0.02 * start, upper = 3.0 * start;
    Array1D logarithms;
    for (int zoom = 0; zoom < zooms; ++zoom) {
        grid_ = Array1D::LinSpaced(points, lower, upper);
        logarithms.resize(points);
        for (Index k = 0; k < points; ++k) {
            const auto there = at(grid_[k]);
            logarithms[k] = balance_->scatter.log_densities(there.shared, there.residual)[0];
        }
        const double highest = logarithms.maxCoeff();
        Index first = 0, last = points - 1;
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
        throw UndefinedDataError("no work of adhesion says the measured pairs better than another");
    density_ /= total;
    cumulative_ /= total;
    log_evidence_ = highest + std::log(total);
}

namespace {

/// Effects of surfaces, elastomers and pairs, as the pairs leave them.
class DrawnEffects {
public:
    DrawnEffects(const std::vector<PairPoint>& pairs, const ModelScatter& scatter, numerics::RandomKey key)
        : pairs_(pairs), scatter_(scatter), key_(key) {}

    /// Of a pair before its measurement has a say.
    [[nodiscard]] double prior(const PairPoint& pair) { return of_pair(pair) + of_surface(pair) + of_elastomer(pair); }

    /// pull: V⁻¹ (measured − drawn), one number a pair.
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
    double of_pair(const PairPoint& pair) { return scatter_.pair * one(pair.surface + '\n' + pair.elastomer); }
    double of_surface(const PairPoint& pair) { return scatter_.surface * one("s" + pair.surface); }
    double of_elastomer(const PairPoint& pair) { return scatter_.elastomer * one("e" + pair.elastomer); }
    double one(const std::string& name) {
        const auto [at, fresh] = known_.try_emplace(name, 0.0);
        if (fresh) at->second = numerics::normal_number(key_, known_.size());
        return at->second;
    }

    const std::vector<PairPoint>& pairs_;
    ModelScatter scatter_;
    numerics::RandomKey key_;
    std::map<std::string, double> known_;
    VectorXd pull_;
};

/// The scatter of a random node of the posterior.
ModelScatter drawn_scatter(const std::vector<std::pair<double, ModelScatter>>& cumulative, double uniform) {
    for (const auto& [below, scatter] : cumulative)
        if (uniform <= below) return scatter;
    return cumulative.back().second;
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
        std::vector<std::pair<double, ModelScatter>> scatters;
    };
    std::vector<std::optional<Place>> places(static_cast<std::size_t>(grid_.size()));
    const auto place_at = [&](Index k) -> const Place& {
        auto& place = places[B::to(k)];
        if (place) return *place;
        place.emplace(Place{at(grid_[k]), {}});
        LogSum all;
        b.coarse.visit(place->at.shared, [&](const MarginalScatter::Node& node) {
            const VectorXd whitened = node.factor.matrixL().solve(place->at.residual);
            const double log_density =
                -0.5 * whitened.squaredNorm() - node.factor.matrixLLT().diagonal().array().log().sum();
            all.add(log_density);
            place->scatters.emplace_back(log_density, node.scatter);
        });
        double sum = 0.0;
        for (auto& [density, scatter] : place->scatters) density = sum += std::exp(density - all.value());
        return *place;
    };
    std::vector<double> works;
    std::vector<std::vector<double>> predictions(lines.size());
    for (int d = 0; d < count; ++d) {
        const numerics::RandomKey key{seed, static_cast<std::uint64_t>(d)};
        const double p = numerics::uniform_number(substream(key, 3), 0);
        const auto k = std::clamp<Index>(
            std::upper_bound(cumulative_.begin(), cumulative_.end(), p) - cumulative_.begin(), 1, grid_.size() - 1);
        const double piece = cumulative_[k] - cumulative_[k - 1], way = piece > 0.0 ? (p - cumulative_[k - 1]) / piece : 0.0;
        const double work = grid_[k - 1] + way * (grid_[k] - grid_[k - 1]);
        const auto& place = place_at(way < 0.5 ? k - 1 : k);
        const auto scatter = drawn_scatter(place.scatters, numerics::uniform_number(substream(key, 3), 1));
        deviates.draw(substream(key, 0));
        DrawnEffects effects(b.pairs, scatter, substream(key, 1));
        const auto noise = numerics::normal_numbers(substream(key, 2), 0, b.size);
        // what would have been measured at the drawn inputs, and how far that is from what was
        VectorXd change(B::parts * b.size);
        for (Index i = 0; i < b.size; ++i) {
            const auto& pair = b.pairs[B::to(i)];
            change[B::slope * b.size + i] = deviates.moved(pair.slope_inputs);
            change[B::offset * b.size + i] = deviates.moved(pair.offset_inputs);
            change[B::measured * b.size + i] = deviates.moved(pair.measured_inputs);
            change[B::noise * b.size + i] = deviates.moved(pair.measured_noise);
        }
        VectorXd missing = place.at.residual - place.at.jacobian * change;
        for (Index i = 0; i < b.size; ++i)
            missing[i] -= effects.prior(b.pairs[B::to(i)]) + std::sqrt(b.own[i]) * noise[i];
        const VectorXd pull = Eigen::LLT<MatrixXd>(b.scatter.with(place.at.shared, scatter)).solve(missing);
        effects.take(pull);
        const VectorXd by_change = place.at.jacobian.transpose() * pull;
        for (Index i = 0; i < b.size; ++i) {
            const auto& pair = b.pairs[B::to(i)];
            deviates.pull(pair.slope_inputs, by_change[B::slope * b.size + i]);
            deviates.pull(pair.offset_inputs, by_change[B::offset * b.size + i]);
            deviates.pull(pair.measured_inputs, by_change[B::measured * b.size + i]);
            deviates.pull(pair.measured_noise, by_change[B::noise * b.size + i]);
        }
        deviates.take_pulls();
        works.push_back(work);
        for (std::size_t l = 0; l < lines.size(); ++l) {
            auto line = lines[l];
            line.slope = moved(line.slope, deviates.moved(line.slope_inputs));
            line.offset = moved(line.offset, deviates.moved(line.offset_inputs));
            double predicted = line.prediction(work);
            if (!line.departure.empty()) predicted += effects(line);
            predictions[l].push_back(line.floored ? std::max(0.0, predicted) : predicted);
        }
    }
    BalanceDraws result{.count = count, .seed = seed};
    result.work_of_adhesion = drawn_value(work_.value, std::move(works));
    for (std::size_t l = 0; l < lines.size(); ++l)
        result.predictions.push_back(drawn_value(lines[l].prediction(work_.value), std::move(predictions[l])));
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
