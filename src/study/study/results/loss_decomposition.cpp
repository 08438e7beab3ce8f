// SPDX-License-Identifier: GPL-3.0-or-later
#include "loss_decomposition.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/statistics/conditioned_values.hpp"

namespace setae::study {
namespace {

using hysteresis::EnergyShares;
using hysteresis::FittedModel;
using hysteresis::Tip;
using statistics::ConditionedValues;

TracedValue difference(const TracedValue& a, const TracedValue& b) {
    return {a.value - b.value, combined({{1.0, a.components}, {-1.0, b.components}})};
}

/// E_loss of the measured works over the contact area, with the sphere's jumps in the pair's testing machine.
TracedValue loss_of_works(const PreparedPair& pair, const TracedValue& retraction) {
    const auto& measured = *pair.as_measured;
    enum Input : std::size_t { work_approach, work_retraction, radius, modulus, contact_area, stiffness };
    return setae::propagated(
        [&](const std::vector<double>& in) {
            const hysteresis::HystereticSphere sphere{
                .radius = in[radius],
                .contact_modulus = in[modulus],
                .work_approach = in[work_approach],
                .work_retraction = std::max(in[work_approach], in[work_retraction])};
            const auto pressing = measured.pressed(sphere.approach(), in[contact_area], in[stiffness]);
            return hysteresis::sphere_loop(sphere, pressing).energy_loss();
        },
        {*measured.approach, retraction, *measured.radius, measured.soft.contact_modulus,
         measured.contact_area.value_or(TracedValue()), measured.machine_stiffness.value_or(TracedValue())});
}

/// Effects that pairs of one model share, by surface and elastomer.
struct ScatterNames {
    std::string pair, surface, elastomer;

    ScatterNames(const std::string& law, const PreparedPair& of)
        : pair(fmt::format("pairs about {}: {} × {}", law, of.measured.surface, of.measured.elastomer)),
          surface(fmt::format("pairs about {}: {}", law, of.measured.surface)),
          elastomer(fmt::format("pairs about {}: {}", law, of.measured.elastomer)) {}
};

/// The model with a free parameter for the loops, and with effects of pairs in place of an error.
FittedModel freed(const PairModel& law) {
    auto fitted = law.fitted;
    const auto name = fitted.model.name();
    if (fitted.model.fitted() && fitted.parameter.value > 0.0) {
        constexpr double wide = 5.0, least = 0.05;
        const double value = fitted.parameter.value;
        const double free = std::max(wide * fitted.parameter.standard_error(), least * value);
        fitted.parameter = {Estimate{.value = value, .standard_error = free}, "number of " + name};
    }
    const ScatterNames names(name, law.pair);
    TracedValue scatter;
    const auto add = [&](const std::string& input, double error) {
        const TracedValue effect(Estimate{.value = 0.0, .standard_error = error}, input);
        scatter.components = combined({{1.0, scatter.components}, {1.0, effect.components}});
    };
    add(names.pair, law.scatter.pair);
    add(names.surface, law.scatter.surface);
    add(names.elastomer, law.scatter.elastomer);
    fitted.shared_scatter = scatter;
    return fitted;
}

/// One loop in the fit.
struct Prepared {
    const PairModel* law = nullptr;
    LossDecomposition loss;
    TracedValue computed;  ///< E_loss by the model, with effects of pairs among its inputs [J]
    TracedValue work_off;  ///< W_ret measured less computed [J/m²]
    double area = 0.0;     ///< π a_max² [m²]
};

/// Without the scatter of pairs about their model: that is unexplained.
TracedValue by_law_alone(TracedValue value, const ScatterNames& names) {
    for (const auto& name : {names.pair, names.surface, names.elastomer}) value.components.erase(name);
    return value;
}

Outcome<Prepared> prepared(const PairModel& law) {
    using Missing = Outcome<Prepared>;
    const auto& pair = law.pair;
    const auto retraction = pair.traced_retraction();
    if (!pair.ranked() || !retraction) return Missing::missing("the work of adhesion is not measured on both branches");
    auto measured = *pair.as_measured;
    if (!measured.radius || !(measured.contact_area || measured.pressing))
        return Missing::missing("the sphere radius, and the contact area or a preload, are not known");
    Prepared result{.law = &law};
    result.loss.model = law.fitted.model.name();
    const auto recorded = pair.measured.traced_loss();
    result.loss.of_works = !recorded;
    if (!recorded) measured.relaxation.clear();  // works contain no bulk relaxation
    const auto fitted = freed(law);
    const auto loop = hysteresis::predicted_retraction_loop(fitted, measured);
    if (!loop) return Missing::missing("W_app is 0");
    result.loss.measured = recorded ? *recorded : loss_of_works(pair, *retraction);
    result.computed = loop->energy_loss;
    result.area = pi * loop->contact_radius.value * loop->contact_radius.value;
    result.work_off = difference(*retraction, hysteresis::predicted_retraction(fitted, measured));
    const ScatterNames names(fitted.model.name(), pair);
    TracedValue sum;
    for (const auto& [name, share] : EnergyShares::all()) {
        result.loss.shares.*share = by_law_alone(loop->shares.*share, names);
        sum = {sum.value + (loop->shares.*share).value,
               combined({{1.0, sum.components}, {1.0, (result.loss.shares.*share).components}})};
    }
    result.loss.unexplained = difference(result.loss.measured, sum);
    return result;
}

/// Names of shares of which only the sum is known.
std::vector<std::string> indistinguishable(const EnergyShares& shares) {
    constexpr double better = 3.0;
    std::vector<std::string> pairs;
    const auto& all = EnergyShares::all();
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = i + 1; k < all.size(); ++k) {
            const auto &a = shares.*all[i].share, &b = shares.*all[k].share;
            const double together = std::sqrt(std::max(0.0, a.variance() + b.variance() + 2.0 * covariance(a, b)));
            const double each = std::min(a.standard_error(), b.standard_error());
            if (each > 0.0 && each > better * together)
                pairs.push_back(fmt::format("{} and {}", all[i].name, all[k].name));
        }
    return pairs;
}

/// Measured minus computed values; energies have an additional error per area.
std::vector<TracedValue> residuals_of(const std::vector<const Prepared*>& loops, double unexplained_per_area) {
    std::vector<TracedValue> residuals;
    for (const auto* loop : loops) {
        const auto& pair = loop->law->pair.measured;
        if (loop->law->ranked) residuals.push_back(loop->work_off);
        if (loop->loss.of_works) continue;
        auto off = difference(loop->loss.measured, loop->computed);
        const TracedValue own(Estimate{.value = 0.0, .standard_error = unexplained_per_area * loop->area},
                              fmt::format("unexplained on {} × {}", pair.surface, pair.elastomer));
        off.components = combined({{1.0, off.components}, {1.0, own.components}});
        residuals.push_back(std::move(off));
    }
    return residuals;
}

/// The scatter of energies that is likeliest, by golden sections of its logarithm.
double likeliest_scatter(const std::vector<const Prepared*>& loops) {
    double largest = 0.0;
    for (const auto* loop : loops)
        largest = std::max(largest, (std::abs(loop->loss.measured.value - loop->computed.value) +
                                     loop->loss.measured.standard_error()) /
                                        loop->area);
    constexpr double decades = 6.0;
    constexpr int rounds = 40;
    const auto unlikely = [&](double logarithm) {
        return -ConditionedValues(residuals_of(loops, std::exp(logarithm))).log_likelihood();
    };
    const double upper = std::log(10.0 * largest);
    return std::exp(numerics::golden_section(unlikely, upper - decades * std::log(10.0), upper, rounds));
}

/// Collects inputs of several pairs, each name once.
class JointInputs {
public:
    explicit JointInputs(const ConditionedValues& fit) : fit_(fit) {}

    void add(const std::string& name, const char* unit, const TracedValue& before) {
        if (!(before.standard_error() > 0.0) || !known_.insert(name).second) return;
        inputs_.push_back({name, unit, before.estimate(), fit_.updated(before).estimate("joint fit")});
    }

    void add_of(const PairModel& law) {
        const auto& pair = *law.pair.as_measured;
        const auto& elastomer = pair.soft.name;
        const auto fitted = freed(law);
        if (fitted.model.fitted()) {
            const auto parameter = fitted.model.parameter();
            add(fmt::format("{} of {}", parameter.symbol, fitted.model.name()), parameter.unit.c_str(),
                fitted.parameter);
        }
        add("W_int", "J/m2", pair.work_of_adhesion);
        add("E* of " + elastomer, "Pa", pair.soft.contact_modulus);
        if (fitted.model.tip == Tip::reference) add("φ of " + elastomer, "1", *pair.tip_factor);
        if (fitted.model.tip == Tip::speed) {
            add("φ(0) of " + elastomer, "1", pair.edge_speed->rest_factor);
            add("v0 of " + elastomer, "m/s", pair.edge_speed->reference_speed);
            add("n of " + elastomer, "1", pair.edge_speed->exponent);
        }
    }

    [[nodiscard]] std::vector<JointInput> take() { return std::move(inputs_); }

private:
    const ConditionedValues& fit_;
    std::set<std::string> known_;
    std::vector<JointInput> inputs_;
};

JointLossFit joint_fit(const std::vector<Prepared*>& loops) {
    const std::vector<const Prepared*> seen(loops.begin(), loops.end());
    JointLossFit joint;
    for (const auto* loop : loops) {
        joint.works += loop->law->ranked ? 1 : 0;
        joint.energies += loop->loss.of_works ? 0 : 1;
    }
    constexpr int fewest = 3;
    if (joint.energies + joint.works < fewest)
        throw UndefinedDataError(fmt::format("{} energies and {} works of retraction; expected {} or more together",
                                             joint.energies, joint.works, fewest));
    if (joint.energies > 0) joint.unexplained_per_area = likeliest_scatter(seen);
    const ConditionedValues fit(residuals_of(seen, joint.unexplained_per_area));
    joint.chi2 = fit.chi2();
    for (auto* loop : loops) {
        auto& loss = loop->loss;
        loss.unexplained = fit.updated(loss.unexplained);
        loss.unexplained.value = loss.measured.value;  // which stays as measured: its noise is not explained either
        for (const auto& [name, share] : EnergyShares::all()) {
            loss.shares.*share = fit.updated(loss.shares.*share);
            loss.unexplained.value -= (loss.shares.*share).value;
        }
    }
    JointInputs inputs(fit);
    for (const auto* loop : loops) inputs.add_of(*loop->law);
    joint.inputs = inputs.take();
    return joint;
}

}  // namespace

DecomposedLosses decomposed_losses(const std::vector<PairModel>& pairs) {
    std::vector<Outcome<Prepared>> losses;
    for (const auto& law : pairs) losses.push_back(prepared(law));
    std::vector<Prepared*> found;
    for (auto& loss : losses)
        if (loss) found.push_back(&*loss.value);
    DecomposedLosses result;
    try {
        result.joint = joint_fit(found);
    } catch (const UndefinedDataError& error) {
        result.joint = Outcome<JointLossFit>::missing(error.what());
    }
    for (auto& loss : losses) {
        if (!loss) {
            result.pairs.push_back(Outcome<LossDecomposition>::missing(loss.reason));
            continue;
        }
        loss.value->loss.indistinguishable = indistinguishable(loss.value->loss.shares);
        result.pairs.emplace_back(std::move(loss.value->loss));
    }
    return result;
}

}  // namespace setae::study
