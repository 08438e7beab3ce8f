// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "balances.hpp"
#include "pairs.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"

namespace setae::study {
namespace {

using roughness::SpectralParameters;

/// A term of a sum of variances from an input and how fast the sum's square root moves with it.
VarianceTerm term(const Estimate& input, double derivative) {
    return {derivative * derivative * input.variance(),
            input.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity())};
}

/// A value with the sum of its terms as variance; none where the spectrum's own share is unknown.
Estimate with_terms(double value, bool known_spread, std::span<const VarianceTerm> terms) {
    Estimate result{.value = value, .method = "delta"};
    if (!known_spread) return result;
    double variance = 0.0;
    for (const auto& t : terms) variance += t.variance;
    result.standard_error = std::sqrt(variance);
    const double freedom = satterthwaite_degrees_of_freedom(terms);
    if (std::isfinite(freedom)) result.degrees_of_freedom = freedom;
    return result;
}

/// Predictions of one pair at one W_int, linear in every uncertain input.
class Prediction {
public:
    Prediction(const SurfaceResult& surface, const ElastomerResult& elastomer, const Estimate& work)
        : spectrum_(surface.used()),
          elastomer_(elastomer),
          work_(work),
          known_spread_(
              !std::isnan(spectrum_.spread.standard_error([](const SpectralParameters& p) { return p.rms_slope; }))) {}

    using AreaRatio = double (*)(double);
    struct Terms {
        VarianceTerm spectrum, modulus, surface_energy, work;
    };

    /// Of W r − γ1 (r − 1) − E* u.
    [[nodiscard]] Terms terms(AreaRatio area_ratio, const Estimate& surface_energy) const {
        const double gain = work_.value - surface_energy.value, modulus = elastomer_.contact_modulus.value;
        const auto balance = [&](const SpectralParameters& p) {
            return gain * area_ratio(p.rms_slope) - modulus * p.elastic_energy_per_modulus;
        };
        const double ratio = area_ratio(spectrum_.parameters.rms_slope);
        return {spectrum_.spread.variance_term(balance),
                term(elastomer_.contact_modulus, spectrum_.parameters.elastic_energy_per_modulus),
                term(surface_energy, ratio - 1.0), term(work_, ratio)};
    }

    [[nodiscard]] PredictedWork work(const adhesion::ApparentWork& apparent, const Terms& t) const {
        return {apparent,
                with_terms(apparent.raw, known_spread_, std::array{t.spectrum, t.modulus, t.surface_energy, t.work})};
    }

    /// E* u.
    [[nodiscard]] Estimate stored_energy() const {
        const double modulus = elastomer_.contact_modulus.value,
                     energy = spectrum_.parameters.elastic_energy_per_modulus;
        const auto spectrum = spectrum_.spread.variance_term(
            [&](const SpectralParameters& p) { return modulus * p.elastic_energy_per_modulus; });
        return with_terms(modulus * energy, known_spread_,
                          std::array{spectrum, term(elastomer_.contact_modulus, energy)});
    }

    /// W r A, A the contact area at maximum preload.
    [[nodiscard]] Estimate loss(double contact_area) const {
        const double true_area = spectrum_.area_ratio() * contact_area;
        const auto spectrum = spectrum_.spread.variance_term([&](const SpectralParameters& p) {
            return work_.value * roughness::gaussian_area_ratio(p.rms_slope) * contact_area;
        });
        return with_terms(work_.value * true_area, known_spread_, std::array{spectrum, term(work_, true_area)});
    }

private:
    const SpectrumResult& spectrum_;
    const ElastomerResult& elastomer_;
    const Estimate& work_;
    bool known_spread_;
};

PredictionBudget budget(const Prediction::Terms& terms) {
    return {std::sqrt(terms.spectrum.variance), std::sqrt(terms.modulus.variance),
            std::sqrt(terms.surface_energy.variance), std::sqrt(terms.work.variance)};
}

void add_alerts(PairResult& pair) {
    const auto subject = pair.surface + " × " + pair.elastomer;
    if (!pair.modified->work.conforms)
        pair.alerts.push_back({"WILL_NOT_CONFORM", subject,
                               fmt::format("(7) gives {:.3g} mJ/m2, floored at 0", 1e3 * pair.modified->work.raw),
                               "conformal contact is not predicted; area and energy of full contact do not apply"});
    if (const auto& band = pair.scales->bridging)
        pair.alerts.push_back(
            {"CONFORMAL_INVALID", subject,
             fmt::format(
                 "the roughness above q stores more than it gains for q between {:.3g} and {:.3g} 1/m (wavelengths {:.3g} to {:.3g} m)",
                 band->lower, band->upper, 2.0 * pi / band->upper, 2.0 * pi / band->lower),
             "the solid would rather bridge these wavelengths than conform"});
}

void predict(PairResult& pair, const SurfaceResult& surface, const ElastomerResult& elastomer, const Estimate& work) {
    const Prediction prediction(surface, elastomer, work);
    const auto& surface_energy = elastomer.input.surface_energy;
    pair.area_ratio = surface.area_ratio();
    pair.stored_energy = prediction.stored_energy();
    const adhesion::ConformalState state{pair.area_ratio, pair.stored_energy.value};
    const auto terms = prediction.terms(roughness::gaussian_area_ratio, surface_energy);
    pair.modified = prediction.work(adhesion::modified_balance(work.value, surface_energy.value, state), terms);
    pair.persson_tosatti = prediction.work(
        adhesion::persson_tosatti_balance(work.value, surface.used().parameters.rms_slope, state.stored_energy),
        prediction.terms(roughness::small_slope_area_ratio, {}));
    pair.without_area_change = prediction.work(adhesion::balance_without_area_change(work.value, state),
                                               prediction.terms(roughness::gaussian_area_ratio, {}));
    if (const auto& law = elastomer.input.surface_energy_law)
        pair.general = adhesion::general_balance(work.value, *law, state);
    if (pair.contact_area) pair.predicted_loss = prediction.loss(*pair.contact_area);
    pair.budget = budget(terms);
    pair.scales = adhesion::scale_balance(roughness::cumulative_parameters(surface.used().curve),
                                          elastomer.contact_modulus.value, work.value, surface_energy.value);
    add_alerts(pair);
}

}  // namespace

void predict_pairs(StudyResult& result) {
    Estimate work;
    if (result.study.work_of_adhesion) {
        work = *result.study.work_of_adhesion;
        result.work_of_adhesion_source = "given in the study";
    } else if (result.modified) {
        work = result.modified->clustered;
        result.work_of_adhesion_source = "fit of (7) to the measured pairs";
    } else {
        result.work_of_adhesion =
            Outcome<Estimate>::missing("no work_of_adhesion in the study, and no fit: " + result.modified.reason);
        return;
    }
    result.work_of_adhesion = work;
    for (auto& pair : result.pairs) {
        const auto& surface = result.surface(pair.surface);
        const auto& elastomer = result.elastomer(pair.elastomer);
        if (predictable(surface, elastomer)) predict(pair, surface, elastomer, work);
    }
}

}  // namespace setae::study
