// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pairs of a surface and an elastomer, and references, as the JSON of a study has them.

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/adhesion/prediction_test.hpp"
#include "setae/core/constants.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/contact_answer_fields.hpp"
#include "setae/output/json.hpp"
#include "setae/output/predicted_quantities.hpp"
#include "setae/output/quantity_rows.hpp"
#include "setae/statistics/equivalence.hpp"
#include "setae/study/study_result.hpp"
#include "work_fit_fields.hpp"

namespace setae::output {

/// A value from draws of all inputs, in J/m².
struct DrawnWork {
    adhesion::DrawnValue drawn;
    int count = 0;
    std::uint64_t seed = 0;
};
[[nodiscard]] inline std::optional<DrawnWork> drawn_work(const std::optional<adhesion::DrawnValue>& drawn,
                                                         const adhesion::BalanceDraws& draws) {
    if (!drawn) return std::nullopt;
    return DrawnWork{*drawn, draws.count, draws.seed};
}

/// Parts of the standard error of a measured value.
struct MeasuredError {
    double own_noise = 0.0, shared_inputs = 0.0;
    std::string_view unit;
};

/// A measured value and the parts of its standard error.
struct MeasuredValue {
    Quantity value;
    MeasuredError error;
};
[[nodiscard]] inline std::optional<MeasuredValue> measured_value(const char* name, const char* symbol,
                                                                 const std::optional<Estimate>& value,
                                                                 const Components& inputs, std::string_view unit) {
    if (!value) return std::nullopt;
    return MeasuredValue{quantity(name, symbol, *value, std::string(unit)),
                         {value->standard_error, std::sqrt(covariance(inputs, inputs)), unit}};
}

/// What loops measured on a pair.
struct MeasuredPair {
    const study::PairResult* pair;
};

/// W_app by one balance.
struct BalanceOfPair {
    const adhesion::PredictedWork* predicted;
    Estimate floored;
    std::string_view source;
    std::optional<DrawnWork> draws{};
    std::optional<adhesion::PredictionBudget> budget{};

    [[nodiscard]] Quantity quoted(const Estimate& estimate) const {
        auto quoted = in_unit(estimate, "J/m2");
        quoted.source = source;
        return quoted;
    }
};

/// Contact of simulated patches without load.
struct PartialContact {
    double area_fraction = 0.0;
    Estimate work_of_adhesion;
};

/// What the balances predict for a pair.
struct PredictedPair {
    const study::PairResult* pair;
    const adhesion::BalanceDraws* draws;

    /// Wavelength at which the cumulative share of the stored energy first reaches one half.
    [[nodiscard]] double half_wavelength() const {
        const auto& scales = *pair->scales;
        for (Index i = 0; i < scales.wavevector.size(); ++i)
            if (scales.stored_share[i] >= 0.5) return 2.0 * pi / scales.wavevector[i];
        return undefined;
    }
    [[nodiscard]] std::optional<double> residual() const {
        if (!pair->approach) return std::nullopt;
        return pair->approach->value - pair->modified->work.floored;
    }
};

/// The loop that is predicted for a pair.
struct LoopOfPair {
    const adhesion::PredictedLoop* loop;
};

/// A pair with the draws of its study.
struct PairEntry {
    const study::PairResult* pair;
    const adhesion::BalanceDraws* draws;
};

}  // namespace setae::output

namespace setae::fields {

template <>
struct Described<output::DrawnWork> {
    using T = output::DrawnWork;
    static constexpr std::array rows{
        field<&T::count>("draws", "number of draws"),
        field<&T::seed>("seed", "seed of the random numbers"),
        made<T>("standard_error", "standard deviation of the draws",
                [](const T& of) { return of.drawn.standard_error; }),
        made<T>("interval", "interval that covers the value with the probability `level`",
                [](const T& of) { return of.drawn.interval; }),
        made<T>("unit", "unit of standard error and interval", [](const T&) { return std::string_view("J/m2"); }),
        inner<&T::drawn>(),
    };
    static constexpr Description description{"draws", "a value from draws of all inputs", rows};
};
static_assert(complete<output::DrawnWork>);

template <>
struct Described<output::MeasuredError> {
    using T = output::MeasuredError;
    static constexpr std::array rows{
        field<&T::own_noise>("own_noise", "standard error from noise and scatter of the loops"),
        field<&T::shared_inputs>("shared_inputs", "standard error from inputs that loops share"),
        made<T>("all", "both parts, added in squares",
                [](const T& of) { return std::hypot(of.own_noise, of.shared_inputs); }),
        field<&T::unit>("unit", "unit of the three numbers"),
    };
    static constexpr Description description{"measured_error_budget", "parts of the standard error of a measured value",
                                             rows};
};
static_assert(complete<output::MeasuredError>);

template <>
struct Described<output::MeasuredValue> {
    using T = output::MeasuredValue;
    static constexpr std::array rows{
        quantity_fields<T>([](const T& of) -> const Quantity& { return of.value; }),
        field<&T::error>("standard_error_budget", "parts of the standard error"),
        inner<&T::value>(),
    };
    static constexpr Description description{
        "measured_quantity", "a measured quantity; its standard error is that of noise and scatter of the loops", rows};
};
static_assert(complete<output::MeasuredValue>);

template <>
struct Described<study::PairWorkAlong> {
    using T = study::PairWorkAlong;
    static constexpr std::array rows{
        field<&T::loops>("loops", "number of loops with W_ret along the retraction"),
        quantity<&T::at_pull_off>("work_at_pull_off", "W_ret(a_po)", "J/m2", "W_ret at the smallest contact radius"),
        quantity<&T::at_largest_contact>("work_at_largest_contact", "W_ret(a_max)", "J/m2",
                                         "W_ret at the largest contact radius"),
        quantity<&T::slope>("slope", "dW_ret/da", "J/m3",
                            "dW_ret/da; above 0, W_ret decreases while the contact shrinks")
            .as("retraction_work_slope"),
        quantity<&T::energy_loss>("energy_loss", "E_loss", "J",
                                  "loss of loops with W_app on approach and this W_ret on retraction"),
        quantity<&T::energy_recorded>("energy_loss_recorded", "E_loss", "J", "loss of the same loops as recorded"),
    };
    static constexpr Description description{
        "pair_work_along_retraction",
        "W_ret(a): a line from the largest contact to pull-off, mean over the loops of a pair", rows};
};
static_assert(complete<study::PairWorkAlong>);

template <>
struct Described<output::MeasuredPair> {
    using T = output::MeasuredPair;
    static constexpr std::array rows{
        made<T>("work_of_adhesion_approach", "W_app of the approach",
                [](const T& of) {
                    return output::measured_value("work_of_adhesion_approach", "W_app", of.pair->approach,
                                                  of.pair->approach_inputs, "J/m2");
                })
            .or_null(),
        made<T>("work_of_adhesion_pull_off", "W from the pull-off force (Eq. S1)",
                [](const T& of) {
                    return output::measured_value("work_of_adhesion_pull_off", "W_po", of.pair->pull_off,
                                                  of.pair->pull_off_inputs, "J/m2");
                })
            .or_null(),
        made<T>("work_of_adhesion_retraction", "W_ret at pull-off (Eq. S2)",
                [](const T& of) {
                    return output::measured_value("work_of_adhesion_retraction", "W_ret", of.pair->retraction,
                                                  of.pair->retraction_inputs, "J/m2");
                })
            .or_null(),
        made<T>("energy_loss", "energy lost in a loop",
                [](const T& of) {
                    return output::measured_value("energy_loss", "E_loss", of.pair->loss, of.pair->loss_inputs, "J");
                })
            .or_null(),
        made<T>("contact_area", "pi a_max^2", "m2", "contact area at maximum preload",
                [](const T& of) { return of.pair->contact_area; })
            .or_null(),
        made<T>("ideal_smooth_sphere_loss", "E_ideal", "J", "loss of an ideal smooth sphere with this W_app and E*",
                [](const T& of) { return of.pair->ideal_loss; })
            .or_null(),
        made<T>("reference_share", "(W_ret - W_app)_smooth/(W_ret - W_app)", "1",
                "share of the hysteresis that the smooth reference has, too",
                [](const T& of) { return of.pair->reference_share; })
            .from("share of the hysteresis that the smooth reference has, too"),
        made<T>("work_along_retraction", "W_ret against the contact radius during retraction",
                [](const T& of) -> const auto& { return of.pair->work_along_retraction; }),
    };
    static constexpr Description description{"", "values measured on the pair; null where not measured", rows};
};

template <>
struct Described<adhesion::PredictionBudget> {
    using T = adhesion::PredictionBudget;
    static constexpr std::array rows{
        field<&T::spectrum>("spectrum", "standard error from the spectrum"),
        field<&T::modulus>("modulus", "standard error from the modulus"),
        field<&T::surface_energy>("surface_energy", "standard error from γ1"),
        field<&T::work_of_adhesion>("work_of_adhesion", "standard error from W_int"),
        made<T>("unit", "unit of the four numbers", [](const T&) { return std::string_view("J/m2"); }),
    };
    static constexpr Description description{"prediction_error_budget", "parts of the standard error of a prediction",
                                             rows};
};
static_assert(complete<adhesion::PredictionBudget>);

template <>
struct Described<output::BalanceOfPair> {
    using T = output::BalanceOfPair;
    static constexpr std::array rows{
        made<T>("work_of_adhesion", "W_app", "J/m2", "W_app of the balance; negative where full contact costs energy",
                [](const T& of) { return of.quoted(of.predicted->estimate); })
            .as("apparent_work_of_adhesion"),
        made<T>("work_of_adhesion_floored", "max(0, W_app)", "J/m2", "max(0, W_app)",
                [](const T& of) { return of.quoted(of.floored); }),
        made<T>("conforms", "whether W_app > 0: the balance allows full contact",
                [](const T& of) { return of.predicted->work.conforms; }),
        field<&T::draws>("draws", "the same value from draws of all inputs"),
        field<&T::budget>("standard_error_budget", "parts of the standard error"),
        inner<&T::predicted>(),
        inner<&T::floored>(),
        inner<&T::source>(),
    };
    static constexpr Description description{"predicted_work", "W_app on approach by one balance", rows};
};
static_assert(complete<output::BalanceOfPair>);

template <>
struct Described<output::PartialContact> {
    using T = output::PartialContact;
    static constexpr std::array rows{
        field<&T::area_fraction>("area_fraction", "area in contact over nominal area"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W_app", "J/m2", "W_app of this contact")
            .as("apparent_work_of_adhesion"),
    };
    static constexpr Description description{
        "", "contact without load of simulated patches with the same stored energy", rows};
};
static_assert(complete<output::PartialContact>);

template <>
struct Described<output::PredictedPair> {
    using T = output::PredictedPair;
    static constexpr std::array rows{
        made<T>("true_area_ratio", "A_true/A_app", "1", "true area over nominal area",
                [](const T& of) { return of.pair->area_ratio; })
            .from("[D19], Eq. 9"),
        made<T>("stored_energy", "U_el/A_app", "J/m2", "elastic energy stored in full contact per nominal area",
                [](const T& of) { return of.pair->stored_energy; })
            .as("stored_energy_per_area"),
        made<T>("modified", "full-contact balance (Eq. 7)",
                [](const T& of) {
                    const auto& pair = *of.pair;
                    return output::BalanceOfPair{&*pair.modified, pair.modified->estimate, "[D19], Eq. 7",
                                                 output::drawn_work(pair.drawn, *of.draws), *pair.budget};
                }),
        made<T>("predicted_energy_loss", "E_loss (10)", "J", "loss by the true-area balance (Eq. 10)",
                [](const T& of) { return of.pair->predicted_loss; })
            .from("[D19], Eq. 10 at W_int of the predictions and the contact area at maximum preload")
            .or_null(),
        made<T>("persson_tosatti", "Persson–Tosatti balance (Eq. S13)",
                [](const T& of) {
                    const auto& work = *of.pair->persson_tosatti;
                    return output::BalanceOfPair{&work, {.value = work.work.floored}, "[D19], Eq. S13"};
                }),
        made<T>("without_area_change", "small-slope balance (Eq. 2)",
                [](const T& of) {
                    const auto& work = *of.pair->without_area_change;
                    return output::BalanceOfPair{&work, {.value = work.work.floored}, "[D19], Eq. 2"};
                }),
        made<T>("answers", "contact without load by each theory",
                [](const T& of) { return study::contact_answers(*of.pair); }),
        made<T>("partial_contact", "contact without load of simulated patches",
                [](const T& of) {
                    return output::PartialContact{of.pair->contact.area_fraction, of.pair->partial_contact->estimate()};
                }),
        made<T>("general", "W_app", "J/m2", "W_app with a surface energy that depends on strain",
                [](const T& of) -> std::optional<double> {
                    if (!of.pair->general) return std::nullopt;
                    return of.pair->general->raw;
                })
            .as("apparent_work_of_adhesion")
            .from("of end states, or [D19], Eqs. 5 and 6 where form = printed"),
        made<T>("residual", "W_app - W_app,predicted", "J/m2",
                "measured W_app minus that of the full-contact balance (Eq. 7)",
                [](const T& of) { return of.residual(); })
            .as("residual_work_of_adhesion")
            .from("measured minus predicted"),
        made<T>("wavelength_of_half_the_stored_energy", "lambda_1/2", "m",
                "wavelength above which half of the energy is stored", [](const T& of) { return of.half_wavelength(); })
            .from("longer wavelengths store half of U_el"),
        made<T>("bridging", "wavevectors whose roughness opens spontaneously; null: none",
                [](const T& of) { return of.pair->scales->bridging; })
            .or_null(),
        made<T>("pressed", "wavevectors whose roughness is not in full contact without pressure; null: none",
                [](const T& of) { return of.pair->scales->pressed; })
            .or_null(),
        made<T>("closing", "`spontaneous full contact`, `full contact only under pressure` or `opens spontaneously`",
                [](const T& of) { return adhesion::name(of.pair->closing()); }),
        made<T>("closing_pressure", "p", "Pa", "mean pressure that brings 99 % of the area into contact",
                [](const T& of) { return of.pair->scales->closing_pressure[0]; })
            .from("closes 99 % of patches of the same energies and rms height"),
        made<T>("energy_in_contact", "U/U_el", "1",
                "stored energy of the waves within the contact over that of all waves on a half-space",
                [](const T& of) { return of.pair->seen.energy; })
            .from("stored energy of the waves within the contact, in a layer, over that of all on a half-space"),
    };
    static constexpr Description description{"", "predictions for a pair", rows};
};

template <>
struct Described<output::LoopOfPair> {
    using T = output::LoopOfPair;
    static constexpr Description possible_quantities{"", "quantities of a predicted loop", output::loop_quantity_rows};
    static constexpr std::array rows{
        quantities_among<T>(possible_quantities, [](const T& of) { return output::loop_quantities(*of.loop); }),
    };
    static constexpr Description description{"", "predicted loop, where sphere and preload are given", rows};
};

template <>
struct Described<output::PairEntry> {
    using T = output::PairEntry;
    static constexpr std::array rows{
        made<T>("surface", "name of the surface", [](const T& of) -> const std::string& { return of.pair->surface; }),
        made<T>("elastomer", "name of the elastomer",
                [](const T& of) -> const std::string& { return of.pair->elastomer; }),
        made<T>("experiments", "number of loops; 0 for published values",
                [](const T& of) { return of.pair->experiments; }),
        made<T>("measured", "values measured on the pair", [](const T& of) { return output::MeasuredPair{of.pair}; }),
        fields_of<T>([](const T& of) -> std::optional<output::PredictedPair> {
            if (!of.pair->modified) return std::nullopt;
            return output::PredictedPair{of.pair, of.draws};
        }),
        made<T>("work_of_adhesion_with_unmeasured_waves", "W_app", "J/m2",
                "W_app by the full-contact balance (Eq. 7) with waves beyond both ends of the data",
                [](const T& of) -> std::optional<Quantity> {
                    if (!of.pair->with_unmeasured_waves) return std::nullopt;
                    return output::unmeasured_quantity(*of.pair->with_unmeasured_waves);
                }),
        made<T>("loop", "predicted loop, where sphere and preload are given",
                [](const T& of) -> std::optional<output::LoopOfPair> {
                    if (!of.pair->loop) return std::nullopt;
                    return output::LoopOfPair{&*of.pair->loop};
                }),
        made<T>("alerts", "warnings on the pair", [](const T& of) -> const auto& { return of.pair->alerts; }),
    };
    static constexpr Description description{"pair", "a surface and an elastomer: measured and predicted", rows};
};

template <>
struct Described<statistics::Equivalence> {
    using T = statistics::Equivalence;
    static constexpr std::array rows{
        field<&T::margin>("margin", "margin within which a difference is of no importance"),
        field<&T::probability>("probability", "larger p-value of the two one-sided tests"),
        made<T>("verdict", "`equivalent`, `different` or `undecided`",
                [](const T& of) { return statistics::name(of.verdict); }),
        made<T>("source", "method of the test",
                [](const T&) { return std::string_view("two one-sided tests, Schuirmann 1987"); }),
        made<T>("unit", "unit of margin and interval", [](const T&) { return std::string_view("J/m2"); }),
        field<&T::interval>("interval", "interval of the difference; null where the difference has no standard error")
            .or_null(),
        inner<&T::difference>(),
        inner<&T::verdict>(),
    };
    static constexpr Description description{"equivalence", "test of a difference against a margin", rows};
};
static_assert(complete<statistics::Equivalence>);

template <>
struct Described<study::ReferenceResult> {
    using T = study::ReferenceResult;
    static constexpr std::array rows{
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        field<&T::stage>("stage", "before or after the rough loops"),
        quantity<&T::approach>("work_of_adhesion_approach", "W_app", "J/m2", "W_app of the approach")
            .as("apparent_work_of_adhesion"),
        quantity<&T::retraction>("work_of_adhesion_retraction", "W_ret", "J/m2", "W_ret at pull-off"),
        quantity<&T::excess_energy>("excess_energy", "E_excess", "J", "work of the loop above 0"),
        quantity<&T::ideal_loss>("ideal_smooth_sphere_loss", "E_ideal", "J",
                                 "loss of an ideal smooth JKR sphere under fixed grips"),
        quantity<&T::loss_ratio>("loss_ratio", "E_loss/E_excess", "1",
                                 "mean loss of rough loops on this elastomer over the excess energy"),
        quantity<&T::contact_area>("contact_area", "pi a_max^2", "m2", "contact area at the largest preload"),
        made<T>("hysteresis", "W_ret - W_app", "J/m2", "W_ret at pull-off minus W_app",
                [](const T& of) { return of.hysteresis.difference; }),
        field<&T::hysteresis>("hysteresis_test", "test of this hysteresis against the margin of the study"),
        made<T>("loss_per_area", "(E_excess - E_ideal)/(pi a_max^2)", "J/m2",
                "excess energy beyond the ideal loss per contact area",
                [](const T& of) -> std::optional<Estimate> {
                    if (!of.loss_per_area) return std::nullopt;
                    return of.loss_per_area->difference;
                }),
        field<&T::loss_per_area>("loss_per_area_test", "test of this loss against the margin of the study"),
    };
    static constexpr Description description{"", "a smooth sphere on a smooth reference", rows};
};
static_assert(complete<study::ReferenceResult>);

template <>
struct Described<study::ReferenceDrift> {
    using T = study::ReferenceDrift;
    static constexpr std::array rows{
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        made<T>("work_of_adhesion_approach_change", "dW_app", "J/m2", "W_app after the rough loops minus before",
                [](const T& of) { return of.change.work_of_adhesion_loading; }),
        made<T>("work_of_adhesion_retraction_change", "dW_ret", "J/m2", "W_ret after the rough loops minus before",
                [](const T& of) { return of.change.work_of_adhesion_retraction; }),
        made<T>("excess_energy_change", "dE_excess", "J", "excess energy after the rough loops minus before",
                [](const T& of) { return of.change.excess_energy; }),
        inner<&T::change>(),
    };
    static constexpr Description description{"", "change of the smooth reference during the study", rows};
};
static_assert(complete<study::ReferenceDrift>);

}  // namespace setae::fields
