// SPDX-License-Identifier: GPL-3.0-or-later
#include "both_branches.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/component_rows.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::hysteresis {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// Limits the cost of stretching to the gain of full contact while inputs are fitted.
double bounded_surface_energy(double surface_energy, double work, double area_ratio) {
    constexpr double most = 0.999;
    return area_ratio > 1.0 ? std::min(surface_energy, most * work * area_ratio / (area_ratio - 1.0)) : surface_energy;
}

}  // namespace

BothBranches::BothBranches(const RetractionModel& model, const std::vector<RankedPair>& pairs,
                           const std::optional<Estimate>& known_work, WorkOfElastomers works)
    : model_(model) {
    const auto n = static_cast<Index>(pairs.size());
    for (auto* vector : {&approach_, &retraction_, &approach_noise_, &retraction_noise_}) vector->resize(n);
    without_approach_.reserve(pairs.size());
    const bool by_reference = works == WorkOfElastomers::by_reference;
    double mean_reference = 0.0;
    if (by_reference)
        for (const auto& [pair, approach, retraction] : pairs) {
            if (!pair.reference_work)
                throw InvalidArgument("W_int in proportion to references: no smooth reference on " + pair.soft.name);
            mean_reference += pair.reference_work->value / static_cast<double>(n);
        }
    std::vector<Components> held;
    held.reserve(static_cast<std::size_t>(n * number_count));
    for (Index i = 0; i < n; ++i) {
        const auto& [pair, approach, retraction] = pairs[static_cast<std::size_t>(i)];
        if (!pair.approach) throw InternalError("a ranked pair has no measured work of adhesion on approach");
        auto& without = without_approach_.emplace_back(pair);
        without.approach.reset();
        pairs_.push_back({PairFunctions(without), PairFunctions(pair), {}, Roughness(pair.rough.parameters), {}, 1.0});
        auto& own = pairs_.back();
        own.values = own.functions.values();
        approach_[i] = approach.value.value;
        approach_noise_[i] = std::sqrt(approach.value.variance());
        retraction_[i] = retraction.value.value;
        retraction_noise_[i] = std::sqrt(retraction.value.variance());
        const auto& in = own.functions.inputs();
        using F = PairFunctions;
        const bool by_speed = model.tip == Tip::speed;
        const Components* of[number_count] = {};
        const auto ratio = pair.rough.traced([](const roughness::SpectralParameters& p) { return p.area_ratio(); });
        const auto stored =
            pair.rough.traced([](const roughness::SpectralParameters& p) { return p.elastic_energy_per_modulus; });
        of[area_ratio] = &ratio.components;
        of[energy] = &stored.components;
        of[modulus] = &in[F::contact_modulus].components;
        of[surface_energy] = &in[F::surface_energy].components;
        of[measured_approach] = &approach.inputs;
        of[measured_retraction] = &retraction.inputs;
        of[tip] = &in[by_speed ? F::speed_factor_input : F::tip_factor].components;
        of[pinning] = &in[F::pinning_factor].components;
        of[patches] = &in[F::patches].components;
        of[radius] = &in[F::radius].components;
        of[contact_area] = &in[F::contact_area].components;
        of[stiffness] = &in[F::machine_stiffness].components;
        TracedValue relative(1.0);
        if (by_reference)
            relative = {pair.reference_work->value / mean_reference,
                        combined({{1.0 / mean_reference, pair.reference_work->components}})};
        own.reference_work = relative.value;
        of[reference] = &relative.components;
        for (Index k = 0; k < number_count; ++k) {
            own.deviations[k] = std::sqrt(covariance(*of[k], *of[k]));
            held.push_back(*of[k]);
        }
    }
    std::vector<const Components*> rows;
    for (const auto& components : held) rows.push_back(&components);
    factor_ = component_rows(rows);
    for (Index i = 0; i < n; ++i)
        for (Index k = 0; k < number_count; ++k)
            if (const double deviation = pairs_[static_cast<std::size_t>(i)].deviations[k]; deviation > 0.0)
                factor_.row(i * number_count + k) /= deviation;
    covariance_.noalias() = factor_ * factor_.transpose();
    constexpr double wide = 1.0;  // width of ln W_int
    const double start = known_work ? known_work->value : pairs.front().pair.work_of_adhesion.value;
    const double relative = known_work ? std::sqrt(known_work->variance()) / start : wide;
    work_ = {.value = start, .standard_error = relative};
    if (model.law == Law::fitted_pinning) number_ = {.value = 2.0, .standard_error = 3.0};
    else number_ = {.value = 2.0 * start, .standard_error = 3.0 * start};
    constant_ = upper_median(std::vector<double>(retraction_.begin(), retraction_.end()));
}

Knowledge BothBranches::prior(bool with_constant) const {
    const Index n = shared_count + size() * number_count;
    Knowledge known{VectorXd::Zero(n), MatrixXd::Zero(n, n)};
    known.covariance(work, work) = work_.standard_error > 0.0 ? 1.0 : 0.0;
    known.covariance(number, number) = model_.fitted() ? 1.0 : 0.0;
    known.covariance(constant, constant) = with_constant ? 1.0 : 0.0;
    known.covariance.bottomRightCorner(n - shared_count, n - shared_count) = covariance_;
    return known;
}

Estimate BothBranches::value_of(Shared input, const Knowledge& known) const {
    const double x = known.mean[input], deviation = std::sqrt(std::max(0.0, known.covariance(input, input)));
    if (input == work) {
        const double value = work_.value * std::exp(work_.standard_error * x);
        return {.value = value, .standard_error = value * work_.standard_error * deviation, .method = "posterior"};
    }
    const Estimate& prior = input == number ? number_ : Estimate{.value = 0.0, .standard_error = constant_};
    return {.value = prior.value + prior.standard_error * x,
            .standard_error = prior.standard_error * deviation,
            .method = "posterior"};
}

VectorXd BothBranches::at(double work_of_adhesion, double parameter) const {
    VectorXd x = VectorXd::Zero(shared_count + size() * number_count);
    if (work_.standard_error > 0.0) x[work] = std::log(work_of_adhesion / work_.value) / work_.standard_error;
    x[number] = (parameter - number_.value) / number_.standard_error;
    return x;
}

/// A number above 0 in its logarithm, another as it is.
double BothBranches::moved(Index pair, Number number, double value, const VectorXd& x) const {
    const double change = pairs_[static_cast<std::size_t>(pair)].deviations[number] * x[first_of(pair) + number];
    if (change == 0.0) return value;
    return value > 0.0 && number != measured_approach && number != measured_retraction
               ? value * std::exp(change / value)
               : value + change;
}

bool BothBranches::matters(Branch branch, Number of) const {
    const bool retraction = branch == Branch::retraction, of_fronts = is_of_simulated_fronts(model_.law);
    const bool jumps = retraction && counts_jumps(model_.law);
    switch (of) {
        case measured_retraction: return retraction;
        case tip: return retraction && model_.tip != Tip::none;
        case pinning: return of_fronts;
        case radius:
        case contact_area: return of_fronts || jumps;
        case stiffness: return jumps;
        default: return true;
    }
}

double BothBranches::predicted(Branch branch, Index i, const VectorXd& x, double approach_error) const {
    const auto& own = pairs_[static_cast<std::size_t>(i)];
    using F = PairFunctions;
    auto in = own.values;
    const auto set = [&](F::Input input, Number number) { in[input] = moved(i, number, in[input], x); };
    const Roughness rough(1.0 + moved(i, area_ratio, own.rough.area_ratio - 1.0, x),
                          moved(i, energy, own.rough.elastic_energy_per_modulus, x), own.rough.mean_wavelength);
    set(F::contact_modulus, modulus);
    set(F::surface_energy, surface_energy);
    set(model_.tip == Tip::speed ? F::speed_factor_input : F::tip_factor, tip);
    set(F::pinning_factor, pinning);
    set(F::patches, patches);
    set(F::radius, radius);
    set(F::contact_area, contact_area);
    set(F::machine_stiffness, stiffness);
    in[F::work_of_adhesion] =
        moved(i, reference, own.reference_work, x) * work_.value * std::exp(work_.standard_error * x[work]);
    in[F::surface_energy] = bounded_surface_energy(in[F::surface_energy], in[F::work_of_adhesion], rough.area_ratio);
    in[F::parameter] = model_.fitted() ? number_.value + number_.standard_error * x[number] : 0.0;
    // measured values include the errors of their inputs: the true value is the measured value minus these
    const auto error = [&](Number of) { return own.deviations[of] * x[first_of(i) + of]; };
    if (branch == Branch::approach) {
        const double work_approach = own.by_roughness.predicted_approach(model_, rough, in);
        const double relative = approach_[i] > 0.0 ? work_approach / approach_[i] : 1.0;
        return work_approach + relative * error(measured_approach);
    }
    in[F::approach] = std::max(0.0, approach_[i] - error(measured_approach) + approach_error);
    const auto line = own.functions.line(model_, rough, in);
    const double work_retraction = line.slope * in[F::parameter] + line.constant + constant_ * x[constant];
    const double relative = retraction_[i] > 0.0 ? std::max(0.0, work_retraction) / retraction_[i] : 1.0;
    return work_retraction + relative * error(measured_retraction);
}

BranchLines BothBranches::lines_at(Branch branch, const VectorXd& x, const Knowledge& known) const {
    const Index n = size(), inputs = x.size();
    BranchLines lines{VectorXd(n), MatrixXd::Zero(n, inputs), VectorXd(n), VectorXd::Zero(n), {}, {}};
    // secants over one standard error to either side; W_int, known to nothing at first, over a tenth of that
    constexpr double max_of_work = 0.1;
    const auto step_of = [&](Index k) {
        const double deviation = std::sqrt(std::max(0.0, known.covariance(k, k)));
        return k == work ? std::min(max_of_work, deviation) : deviation;
    };
    const double largest = std::max(approach_.cwiseAbs().maxCoeff(), retraction_.cwiseAbs().maxCoeff());
    const double least = 1e-9 * largest;
    VectorXd there = x;
    for (Index i = 0; i < n; ++i) {
        const auto secant = [&](Index k) {
            const double step = step_of(k);
            if (!(step > 0.0)) return 0.0;
            there[k] = x[k] + step;
            const double above = predicted(branch, i, there);
            there[k] = x[k] - step;
            const double below = predicted(branch, i, there);
            there[k] = x[k];
            return (above - below) / (2.0 * step);
        };
        for (Index k = 0; k < shared_count; ++k) lines.jacobian(i, k) = secant(k);
        for (Index k = 0; k < number_count; ++k)
            if (matters(branch, static_cast<Number>(k))) lines.jacobian(i, first_of(i) + k) = secant(first_of(i) + k);
        const double noise = this->noise(branch)[i];
        lines.own_variance[i] = noise * noise + least * least;
        if (branch == Branch::retraction && approach_noise_[i] > 0.0) {
            const double step = approach_noise_[i];
            lines.by_approach[i] = (predicted(branch, i, x, step) - predicted(branch, i, x, -step)) / (2.0 * step);
            lines.own_variance[i] += std::pow(lines.by_approach[i] * approach_noise_[i], 2);
        }
        lines.residual[i] = measured(branch)[i] - predicted(branch, i, x) + lines.jacobian.row(i).dot(x - known.mean);
    }
    lines.covariance_with.resize(inputs, n);
    for (Index i = 0; i < n; ++i)
        lines.covariance_with.col(i) =
            known.covariance.leftCols(shared_count) * lines.jacobian.row(i).head(shared_count).transpose() +
            known.covariance.middleCols(first_of(i), number_count) *
                lines.jacobian.row(i).segment(first_of(i), number_count).transpose();
    lines.covariance.resize(n, n);
    for (Index i = 0; i < n; ++i)
        lines.covariance.row(i) =
            lines.jacobian.row(i).head(shared_count) * lines.covariance_with.topRows(shared_count) +
            lines.jacobian.row(i).segment(first_of(i), number_count) *
                lines.covariance_with.middleRows(first_of(i), number_count);
    lines.covariance.diagonal() += lines.own_variance;
    return lines;
}

}  // namespace setae::hysteresis
