// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/prediction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "setae/core/statistics.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::adhesion {
namespace {

using roughness::SpectralParameters;
using AreaRatio = double (*)(const SpectralParameters&);

double by_slopes(const SpectralParameters& p) { return p.area_ratio(); }
double by_small_slopes(const SpectralParameters& p) { return roughness::small_slope_area_ratio(p.rms_slope); }

/// prediction = W r − γ1 (r − 1) − E* u; its variance is quadratic in W − γ1
PairPoint point(const RoughSide& rough, const SoftSide& soft, AreaRatio area_ratio, const Estimate& surface_energy) {
    const double r = area_ratio(rough.parameters), u = rough.parameters.elastic_energy_per_modulus;
    const auto& modulus = soft.contact_modulus;
    const auto ratio = [area_ratio](const SpectralParameters& p) { return area_ratio(p); };
    const auto energy = [&modulus](const SpectralParameters& p) {
        return modulus.value * p.elastic_energy_per_modulus;
    };
    PairPoint pair;
    pair.surface = rough.name;
    pair.elastomer = soft.name;
    pair.slope = r;
    pair.offset = surface_energy.value * (r - 1.0) + modulus.value * u;
    pair.slope_centre = surface_energy.value;
    pair.slope_variance = rough.spread.covariance(ratio, ratio);
    pair.slope_offset_covariance = rough.spread.covariance(ratio, energy);
    pair.offset_variance = rough.spread.covariance(energy, energy) + u * u * modulus.variance() +
                           (r - 1.0) * (r - 1.0) * surface_energy.variance();
    return pair;
}

/// A term of a sum of variances from an input and how fast the sum's square root moves with it.
VarianceTerm term(const Estimate& input, double derivative) {
    return {derivative * derivative * input.variance(),
            input.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity())};
}

/// A value with the sum of its terms as variance: what is unknown of a spectrum without errors adds nothing. None where
/// no term is known.
Estimate with_terms(const RoughSide& rough, double value, std::span<const VarianceTerm> terms) {
    Estimate result{.value = value, .method = "delta"};
    double variance = 0.0;
    for (const auto& t : terms) variance += t.variance;
    const bool spectrum_known =
        !std::isnan(rough.spread.standard_error([](const SpectralParameters& p) { return p.rms_slope; }));
    if (!spectrum_known && variance == 0.0) return result;
    result.standard_error = std::sqrt(variance);
    const double freedom = satterthwaite_degrees_of_freedom(terms);
    if (std::isfinite(freedom)) result.degrees_of_freedom = freedom;
    return result;
}

/// Of W r − γ1 (r − 1) − E* u: spectrum, modulus, surface energy, W.
std::array<VarianceTerm, 4> balance_terms(const RoughSide& rough, const SoftSide& soft, const Estimate& work,
                                          AreaRatio area_ratio, const Estimate& surface_energy) {
    const double gain = work.value - surface_energy.value, modulus = soft.contact_modulus.value;
    const auto balance = [&](const SpectralParameters& p) {
        return gain * area_ratio(p) - modulus * p.elastic_energy_per_modulus;
    };
    const double ratio = area_ratio(rough.parameters);
    return {rough.spread.variance_term(balance),
            term(soft.contact_modulus, rough.parameters.elastic_energy_per_modulus), term(surface_energy, ratio - 1.0),
            term(work, ratio)};
}

}  // namespace

PairPoint modified_point(const RoughSide& rough, const SoftSide& soft) {
    return point(rough, soft, by_slopes, soft.surface_energy);
}
PairPoint persson_tosatti_point(const RoughSide& rough, const SoftSide& soft) {
    return point(rough, soft, by_small_slopes, {});
}
PairPoint point_without_area_change(const RoughSide& rough, const SoftSide& soft) {
    return point(rough, soft, by_slopes, {});
}

Prediction predict(const RoughSide& rough, const SoftSide& soft, const Estimate& work) {
    Prediction prediction{.area_ratio = rough.parameters.area_ratio()};
    const double modulus = soft.contact_modulus.value, energy = rough.parameters.elastic_energy_per_modulus;
    const auto stored =
        rough.spread.variance_term([&](const SpectralParameters& p) { return modulus * p.elastic_energy_per_modulus; });
    prediction.stored_energy =
        with_terms(rough, modulus * energy, std::array{stored, term(soft.contact_modulus, energy)});
    const ConformalState state{prediction.area_ratio, prediction.stored_energy.value};
    const auto predicted = [&](const ApparentWork& apparent, const std::array<VarianceTerm, 4>& terms) {
        return PredictedWork{apparent, with_terms(rough, apparent.raw, terms)};
    };
    const auto terms = balance_terms(rough, soft, work, by_slopes, soft.surface_energy);
    prediction.modified = predicted(modified_balance(work.value, soft.surface_energy.value, state), terms);
    prediction.persson_tosatti =
        predicted(persson_tosatti_balance(work.value, rough.parameters.rms_slope, state.stored_energy),
                  balance_terms(rough, soft, work, by_small_slopes, {}));
    prediction.without_area_change =
        predicted(balance_without_area_change(work.value, state), balance_terms(rough, soft, work, by_slopes, {}));
    prediction.budget = {std::sqrt(terms[0].variance), std::sqrt(terms[1].variance), std::sqrt(terms[2].variance),
                         std::sqrt(terms[3].variance)};
    return prediction;
}

Estimate predicted_loss(const RoughSide& rough, const Estimate& work, double contact_area) {
    const double true_area = rough.parameters.area_ratio() * contact_area;
    const auto spectrum = rough.spread.variance_term(
        [&](const SpectralParameters& p) { return work.value * p.area_ratio() * contact_area; });
    return with_terms(rough, work.value * true_area, std::array{spectrum, term(work, true_area)});
}

PredictionCurve prediction_curve(const RoughSide& rough, const Estimate& surface_energy,
                                 const Estimate& work_of_adhesion, const Array1D& contact_moduli) {
    PredictionCurve curve{contact_moduli, Array1D(contact_moduli.size()), Array1D(contact_moduli.size()),
                          Array1D(contact_moduli.size())};
    const double reach = normal_quantile(0.975);
    for (Index i = 0; i < contact_moduli.size(); ++i) {
        const auto at = modified_point(rough, {"", {.value = contact_moduli[i]}, surface_energy});
        const double raw = at.slope * work_of_adhesion.value - at.offset;
        const double error = std::sqrt(at.prediction_variance(work_of_adhesion.value) +
                                       at.slope * at.slope * work_of_adhesion.variance());
        curve.work_of_adhesion[i] = std::max(0.0, raw);
        curve.lower[i] = std::max(0.0, raw - reach * error);
        curve.upper[i] = std::max(0.0, raw + reach * error);
    }
    return curve;
}

}  // namespace setae::adhesion
