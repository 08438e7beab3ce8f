// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setae/core/rectified.hpp"
#include "setae/core/statistics.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::adhesion {
namespace {

using roughness::SpectralParameters;
using AreaRatio = double (*)(const SpectralParameters&);

double by_slopes(const SpectralParameters& p) { return p.area_ratio(); }
double by_small_slopes(const SpectralParameters& p) { return roughness::small_slope_area_ratio(p.rms_slope); }

/// prediction = W r − γ1 (r − 1) − E* u.
PairPoint point(const RoughSide& rough, const SoftSide& soft, AreaRatio area_ratio, const TracedValue& surface_energy) {
    const auto r = rough.traced([area_ratio](const SpectralParameters& p) { return area_ratio(p); });
    const auto u = rough.traced([](const SpectralParameters& p) { return p.elastic_energy_per_modulus; });
    const auto& modulus = soft.contact_modulus;
    PairPoint pair;
    pair.surface = rough.name;
    pair.elastomer = soft.name;
    pair.slope = r.value;
    pair.slope_inputs = r.components;
    pair.offset = surface_energy.value * (r.value - 1.0) + modulus.value * u.value;
    pair.offset_inputs = combined({{surface_energy.value, r.components},
                                   {r.value - 1.0, surface_energy.components},
                                   {modulus.value, u.components},
                                   {u.value, modulus.components}});
    return pair;
}

double error_of(double derivative, const Components& inputs) {
    return std::abs(derivative) * std::sqrt(covariance(inputs, inputs));
}

}  // namespace

PairPoint modified_point(const RoughSide& rough, const SoftSide& soft) {
    return point(rough, soft, by_slopes, soft.surface_energy);
}
PairPoint point_without_stored_energy(const RoughSide& rough, const SoftSide& soft) {
    return point(rough, {soft.name, 0.0, soft.surface_energy}, by_slopes, soft.surface_energy);
}
PairPoint persson_tosatti_point(const RoughSide& rough, const SoftSide& soft) {
    return point(rough, soft, by_small_slopes, 0.0);
}
PairPoint point_without_area_change(const RoughSide& rough, const SoftSide& soft) {
    return point(rough, soft, by_slopes, 0.0);
}

PairPoint reference_scaled_point(PairPoint modified, const TracedValue& reference) {
    modified.slope_inputs =
        combined({{reference.value, modified.slope_inputs}, {modified.slope, reference.components}});
    modified.slope *= reference.value;
    return modified;
}

PairPoint pinned_point(PairPoint modified, const PairPoint& gained, double k) {
    modified.offset_inputs = combined({{1.0 + k, modified.offset_inputs}, {-k, gained.offset_inputs}});
    modified.offset += k * (modified.offset - gained.offset);
    return modified;
}

Prediction predict(const RoughSide& rough, const SoftSide& soft, const TracedValue& work) {
    Prediction prediction{.area_ratio = rough.parameters.area_ratio()};
    const auto& modulus = soft.contact_modulus;
    const auto energy = rough.traced([](const SpectralParameters& p) { return p.elastic_energy_per_modulus; });
    const TracedValue stored{modulus.value * energy.value,
                             combined({{modulus.value, energy.components}, {energy.value, modulus.components}})};
    prediction.stored_energy = stored.estimate();
    const ConformalState state{prediction.area_ratio, stored.value};
    const auto predicted = [&](const ApparentWork& apparent, const PairPoint& line) {
        auto traced = raw_prediction(line, work);
        auto estimate = rectified(traced.estimate());
        return PredictedWork{apparent, std::move(traced), std::move(estimate)};
    };
    prediction.modified =
        predicted(modified_balance(work.value, soft.surface_energy.value, state), modified_point(rough, soft));
    prediction.persson_tosatti =
        predicted(persson_tosatti_balance(work.value, rough.parameters.rms_slope, state.stored_energy),
                  persson_tosatti_point(rough, soft));
    prediction.without_area_change =
        predicted(balance_without_area_change(work.value, state), point_without_area_change(rough, soft));
    const SoftSide exact{soft.name, modulus.value, soft.surface_energy.value};
    prediction.budget = {.spectrum = error_of(1.0, modified_point(rough, exact).prediction_inputs(work.value)),
                         .modulus = error_of(energy.value, modulus.components),
                         .surface_energy = error_of(prediction.area_ratio - 1.0, soft.surface_energy.components),
                         .work_of_adhesion = error_of(prediction.area_ratio, work.components)};
    return prediction;
}

TracedValue predicted_loss(const RoughSide& rough, const TracedValue& work, const TracedValue& contact_area) {
    const auto ratio = rough.traced([](const SpectralParameters& p) { return p.area_ratio(); });
    const double w = work.value, r = ratio.value, area = contact_area.value;
    return {w * r * area,
            combined({{w * area, ratio.components}, {r * area, work.components}, {w * r, contact_area.components}})};
}

PredictionCurve prediction_curve(const RoughSide& rough, const TracedValue& surface_energy,
                                 const TracedValue& work_of_adhesion, const Array1D& contact_moduli) {
    PredictionCurve curve{contact_moduli, Array1D(contact_moduli.size()), Array1D(contact_moduli.size()),
                          Array1D(contact_moduli.size())};
    const double reach = normal_quantile(0.975);
    for (Index i = 0; i < contact_moduli.size(); ++i) {
        const auto at =
            raw_prediction(modified_point(rough, {"", contact_moduli[i], surface_energy}), work_of_adhesion);
        const double error = at.standard_error();
        curve.work_of_adhesion[i] = std::max(0.0, at.value);
        curve.lower[i] = std::max(0.0, at.value - reach * error);
        curve.upper[i] = std::max(0.0, at.value + reach * error);
    }
    return curve;
}

}  // namespace setae::adhesion
