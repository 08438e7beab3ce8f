// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Fits of the work of adhesion to the pairs of a study, as its JSON has them.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setae/adhesion/balance_comparison.hpp"
#include "setae/adhesion/free_energy_fit.hpp"
#include "setae/adhesion/generalised_fit.hpp"
#include "setae/adhesion/pair_fit.hpp"
#include "setae/fields/describe.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output {

/// A quantity whose unit depends on the result.
[[nodiscard]] inline Quantity in_unit(const Estimate& estimate, std::string_view unit) {
    return {.estimate = estimate, .unit = std::string(unit)};
}
[[nodiscard]] inline Quantity in_unit(double value, std::string_view unit) {
    return in_unit(Estimate{.value = value}, unit);
}

/// An estimate of W_int under one assumption on the errors, and the unit of what was measured.
struct WeightedWork {
    adhesion::WorkEstimate estimate;
    std::string_view unit;
};

/// Standard deviations of the scatter that no input explains, and their unit.
struct ScatterOfPairs {
    adhesion::ModelScatter scatter;
    std::string_view unit;
};

/// W_int by generalised least squares.
struct GeneralisedWork {
    Estimate work_of_adhesion;
    double r_squared = 0.0;
    int n = 0;
    ScatterOfPairs scatter;
};

/// A measured value beside the fit.
struct FitResidual {
    std::string_view surface, elastomer;
    Estimate measured;
    double predicted = 0.0;
    std::string_view unit;
};

/// A fit of W_int, the formula that was fitted and the unit of what was measured.
struct FittedWork {
    const adhesion::WorkFit* fit;
    std::string_view source, unit;

    [[nodiscard]] GeneralisedWork generalised() const {
        const auto& g = fit->generalised;
        return {g.estimate(), g.r_squared, g.n, {g.scatter, unit}};
    }
    [[nodiscard]] std::optional<WeightedWork> weighted(const std::optional<adhesion::WorkEstimate>& estimate) const {
        if (!estimate) return std::nullopt;
        return WeightedWork{*estimate, unit};
    }
    [[nodiscard]] std::vector<FitResidual> residuals() const {
        std::vector<FitResidual> all;
        for (const auto& pair : fit->pairs)
            all.push_back(
                {pair.surface, pair.elastomer, pair.measured, pair.prediction(fit->work_of_adhesion.value), unit});
        return all;
    }
};

/// Fits of energies lost in loops to E_loss = W_int A_true.
struct FittedLosses {
    const adhesion::LossFits* fits;
};

/// The factor c in W_int = c W_ref of each elastomer.
struct FittedFactor {
    const adhesion::WorkFit* fit;
};

/// All fits of W_int.
struct FitsOfWork {
    const study::Conclusions* of;
};

/// A part made of an outcome, or the reason why there is none.
template <class Part, class T, class Make>
[[nodiscard]] loops::Outcome<Part> outcome_of(const loops::Outcome<T>& outcome, Make make) {
    loops::Outcome<Part> part;
    if (outcome) part.value.emplace(make(*outcome));
    else part.reason = outcome.reason;
    return part;
}

/// Values by name with room for an error.
[[nodiscard]] inline std::vector<std::pair<std::string, Estimate>> estimates_of(
    const std::vector<std::pair<std::string, double>>& values) {
    std::vector<std::pair<std::string, Estimate>> all;
    for (const auto& [name, value] : values) all.emplace_back(name, Estimate{.value = value});
    return all;
}

}  // namespace setae::output

namespace setae::fields {

template <>
struct Described<output::WeightedWork> {
    using T = output::WeightedWork;
    static constexpr std::array rows{
        made<T>("work_of_adhesion", "W_int", "J/m2", "work of adhesion of the smooth interface",
                [](const T& of) { return of.estimate.work_of_adhesion; })
            .as("intrinsic_work_of_adhesion"),
        made<T>("chi_squared", "chi2", "1", "χ² of the pairs with the errors assumed",
                [](const T& of) { return of.estimate.chi_squared; }),
        made<T>("extra_scatter", "tau", "", "standard deviation that was added to the error of each pair",
                [](const T& of) { return output::in_unit(of.estimate.extra_scatter, of.unit); }),
    };
    static constexpr Description description{"weighted_fit", "W_int by weighted least squares", rows};
};

template <>
struct Described<output::ScatterOfPairs> {
    using T = output::ScatterOfPairs;
    static constexpr std::array rows{
        made<T>("pair", "tau", "", "standard deviation between single pairs",
                [](const T& of) { return output::in_unit(of.scatter.pair, of.unit); })
            .as("scatter"),
        made<T>("surface", "tau", "", "standard deviation between surfaces",
                [](const T& of) { return output::in_unit(of.scatter.surface, of.unit); })
            .as("scatter"),
        made<T>("elastomer", "tau", "", "standard deviation between elastomers",
                [](const T& of) { return output::in_unit(of.scatter.elastomer, of.unit); })
            .as("scatter"),
    };
    static constexpr Description description{"", "scatter of the pairs that no input explains", rows};
};

template <>
struct Described<output::GeneralisedWork> {
    using T = output::GeneralisedWork;
    static constexpr std::array rows{
        made<T>("work_of_adhesion", "W_int", "J/m2", "work of adhesion of the smooth interface",
                [](const T& of) { return with_count(of.n, of.work_of_adhesion); })
            .as("intrinsic_work_of_adhesion"),
        inner<&T::work_of_adhesion>(),
        inner<&T::n>(),
        quantity<&T::r_squared>("r_squared", "R2", "1", "1 − SS_res/SS_tot"),
        field<&T::scatter>("scatter", "scatter of the pairs that no input explains"),
    };
    static constexpr Description description{
        "generalised_fit", "W_int by generalised least squares, with the covariance of all errors", rows};
};
static_assert(complete<output::GeneralisedWork>);

template <>
struct Described<adhesion::GeneralisedFreeEnergies> {
    using T = adhesion::GeneralisedFreeEnergies;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) {
            return output::GeneralisedWork{of.work_of_adhesion, of.r_squared, of.n, {of.scatter, "J/m2"}};
        }),
        made<T>("elastic_energy_per_modulus", "U_el/(A_app E*)", "m", "U_el/(A E*) of each surface",
                [](const T& of) {
                    std::vector<std::pair<std::string, Estimate>> all;
                    for (const auto& [surface, energy] : of.energies) all.emplace_back(surface, energy);
                    return all;
                }),
        inner<&T::traced_work_of_adhesion>(),
        inner<&T::work_of_adhesion>(),
        inner<&T::energies>(),
        inner<&T::scatter>(),
        inner<&T::r_squared>(),
        inner<&T::log_likelihood>(),
        inner<&T::n>(),
        inner<&T::parameters>(),
    };
    static constexpr Description description{
        "generalised_energies", "W_int and the stored energies of all surfaces by generalised least squares", rows};
};
static_assert(complete<adhesion::GeneralisedFreeEnergies>);

template <>
struct Described<output::FitResidual> {
    using T = output::FitResidual;
    static constexpr std::array rows{
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        made<T>("measured", "y", "", "measured value",
                [](const T& of) { return output::in_unit(of.measured, of.unit); }),
        made<T>("predicted", "f", "", "value of the fit",
                [](const T& of) { return output::in_unit(of.predicted, of.unit); }),
        made<T>("residual", "y - f", "", "measured value minus value of the fit",
                [](const T& of) { return output::in_unit(of.measured.value - of.predicted, of.unit); }),
        inner<&T::measured>(),
        inner<&T::predicted>(),
        inner<&T::unit>(),
    };
    static constexpr Description description{"", "one pair beside the fit", rows};
};
static_assert(complete<output::FitResidual>);

template <>
struct Described<output::FittedWork> {
    using T = output::FittedWork;
    static constexpr std::array rows{
        made<T>("work_of_adhesion", "W_int", "J/m2", "W_int by least squares, each pair with the same weight",
                [](const T& of) {
                    auto work = with_count(of.fit->n, of.fit->work_of_adhesion);
                    work.source = of.source;
                    return work;
                })
            .as("intrinsic_work_of_adhesion"),
        made<T>("r_squared", "R2", "1", "1 − SS_res/SS_tot", [](const T& of) { return of.fit->r_squared; }),
        made<T>("clustered_standard_error", "SE", "J/m2",
                "standard error of W_int with pairs of one surface and of one elastomer correlated",
                [](const T& of) { return of.fit->clustered.standard_error; }),
        made<T>("clustered", "W_int", "J/m2", "least-squares value with that standard error",
                [](const T& of) { return of.fit->clustered; })
            .as("intrinsic_work_of_adhesion"),
        made<T>("generalised", "W_int by generalised least squares, with the covariance of all errors",
                [](const T& of) { return of.generalised(); }),
        made<T>("posterior", "W_int", "J/m2", "W_int with the scatter between pairs integrated out: the value to quote",
                [](const T& of) { return of.fit->posterior; })
            .as("intrinsic_work_of_adhesion")
            .or_null(),
        made<T>("likelihood", "W_int", "J/m2", "W_int with the 95 % interval of its profile likelihood",
                [](const T& of) { return of.fit->likelihood; })
            .as("intrinsic_work_of_adhesion")
            .or_null(),
        made<T>("residual_standard_deviation", "s", "", "standard deviation of the residuals",
                [](const T& of) { return output::in_unit(of.fit->residual_standard_deviation, of.unit); }),
        made<T>("n", "number of pairs", [](const T& of) { return of.fit->n; }),
        made<T>("degrees_of_freedom", "number of pairs minus number of fitted parameters",
                [](const T& of) { return of.fit->degrees_of_freedom; }),
        made<T>("weighted", "weighted by the measured standard errors; null where a pair has none",
                [](const T& of) { return of.weighted(of.fit->weighted); })
            .or_null(),
        made<T>("with_extra_scatter",
                "weighted by the measured standard errors and a scatter that makes χ² the degrees of freedom",
                [](const T& of) { return of.weighted(of.fit->with_extra_scatter); })
            .or_null(),
        made<T>("errors_in_both", "weighted by the standard errors of measured and predicted values",
                [](const T& of) { return of.weighted(of.fit->errors_in_both); })
            .or_null(),
        made<T>("residuals", "measured and fitted value of each pair", [](const T& of) { return of.residuals(); }),
    };
    static constexpr Description description{"work_fit", "a fit of W_int to the pairs", rows};
};

template <>
struct Described<adhesion::LineFit> {
    using T = adhesion::LineFit;
    static constexpr std::array rows{
        quantity<&T::slope>("work_of_adhesion", "W_int", "J/m2", "slope of the line").as("intrinsic_work_of_adhesion"),
        quantity<&T::intercept>("intercept", "E_0", "J", "loss at no true area"),
        quantity<&T::r_squared>("r_squared", "R2", "1", "1 − SS_res/SS_tot"),
        field<&T::n>("n", "number of pairs"),
    };
    static constexpr Description description{"line_fit", "a straight line with an intercept", rows};
};
static_assert(complete<adhesion::LineFit>);

template <>
struct Described<output::FittedLosses> {
    using T = output::FittedLosses;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) {
            return output::FittedWork{&of.fits->through_origin, "E_loss = W_int A_true; [D19], Eq. 10", "J"};
        }),
        made<T>("with_intercept", "the same losses against a line with an intercept",
                [](const T& of) { return of.fits->with_intercept; })
            .or_null(),
        made<T>("without_ideal_loss", "losses minus the loss of an ideal smooth sphere, through the origin",
                [](const T& of) -> std::optional<output::FittedWork> {
                    const auto& fit = of.fits->through_origin_without_ideal_loss;
                    if (!fit) return std::nullopt;
                    return output::FittedWork{&*fit, "E_loss minus the loss of the smooth sphere = W_int A_true", "J"};
                })
            .or_null(),
        made<T>("without_ideal_loss_with_intercept", "the same losses against a line with an intercept",
                [](const T& of) { return of.fits->with_intercept_without_ideal_loss; })
            .or_null(),
    };
    static constexpr Description description{"loss_fit", "W_int from the energy that loops lose per true area", rows};
};

template <>
struct Described<adhesion::FreeEnergyFit> {
    using T = adhesion::FreeEnergyFit;
    static constexpr std::array rows{
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W_int", "J/m2",
                                       "W_int by least squares, each pair with the same weight")
            .as("intrinsic_work_of_adhesion")
            .from("Eq. 7 with U_el/(A E*) free for each surface: best possible fit for any power spectrum"),
        quantity<&T::r_squared>("r_squared", "R2", "1", "1 − SS_res/SS_tot"),
        made<T>("elastic_energy_per_modulus", "U_el/(A_app E*)", "m", "U_el/(A E*) of each surface",
                [](const T& of) { return output::estimates_of(of.energy_per_modulus); }),
        inner<&T::energy_per_modulus>(),
        field<&T::generalised>("generalised", "by generalised least squares, with the covariance of all errors")
            .or_null(),
    };
    static constexpr Description description{
        "", "full-contact balance (Eq. 7) with the stored energy of each surface as a free parameter", rows};
};
static_assert(complete<adhesion::FreeEnergyFit>);

template <>
struct Described<adhesion::StrainedInterfaceFit> {
    using T = adhesion::StrainedInterfaceFit;
    static constexpr std::array rows{
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W_int", "J/m2", "work of adhesion of the smooth interface")
            .as("intrinsic_work_of_adhesion"),
        quantity<&T::interface_change>("interface_change", "chi", "J/m2",
                                       "change of the interfacial energy per relative change of area"),
        quantity<&T::correlation>("correlation", "rho", "1", "correlation of the two parameters"),
        quantity<&T::r_squared>("r_squared", "R2", "1", "1 − SS_res/SS_tot"),
        field<&T::n>("n", "number of pairs"),
        inner<&T::residual_squares>(),
    };
    static constexpr Description description{"", "balance with an interfacial energy that depends on strain (Eq. 6)",
                                             rows};
};
static_assert(complete<adhesion::StrainedInterfaceFit>);

template <>
struct Described<output::FittedFactor> {
    using T = output::FittedFactor;
    static constexpr std::array rows{
        made<T>("reference_factor", "c", "1", "factor with the scatter between pairs integrated out",
                [](const T& of) { return of.fit->stated(); }),
        made<T>("least_squares", "c", "1", "factor by least squares",
                [](const T& of) { return of.fit->work_of_adhesion; })
            .as("reference_factor"),
        made<T>("generalised", "c", "1", "factor by generalised least squares",
                [](const T& of) { return of.fit->generalised.estimate(); })
            .as("reference_factor"),
        made<T>("r_squared", "R2", "1", "1 − SS_res/SS_tot", [](const T& of) { return of.fit->r_squared; }),
        made<T>("n", "number of pairs", [](const T& of) { return of.fit->n; }),
    };
    static constexpr Description description{
        "", "full-contact balance (Eq. 7) with W_int of each elastomer c times W_app of its smooth reference", rows};
};

template <>
struct Described<output::FitsOfWork> {
    using T = output::FitsOfWork;
    static constexpr std::array rows{
        made<T>("modified", "full-contact balance (Eq. 7)",
                [](const T& of) {
                    return output::outcome_of<output::FittedWork>(of.of->modified, [](const adhesion::WorkFit& fit) {
                        return output::FittedWork{&fit, "[D19], Eq. 7, floored at 0", "J/m2"};
                    });
                }),
        made<T>("persson_tosatti", "Persson–Tosatti balance (Eq. S13)",
                [](const T& of) {
                    return output::outcome_of<output::FittedWork>(
                        of.of->persson_tosatti, [](const adhesion::WorkFit& fit) {
                            return output::FittedWork{&fit, "[D19], Eq. S13, floored at 0", "J/m2"};
                        });
                }),
        made<T>("without_area_change", "small-slope balance (Eq. 2)",
                [](const T& of) {
                    return output::outcome_of<output::FittedWork>(
                        of.of->without_area_change, [](const adhesion::WorkFit& fit) {
                            return output::FittedWork{&fit, "[D19], Eq. 2, floored at 0", "J/m2"};
                        });
                }),
        made<T>("loop", "W_int from the energies that loops lose: true-area loss (Eq. 10)",
                [](const T& of) {
                    return output::outcome_of<output::FittedLosses>(
                        of.of->loop, [](const adhesion::LossFits& fits) { return output::FittedLosses{&fits}; });
                }),
        made<T>("free_energies",
                "full-contact balance (Eq. 7) with the stored energy of each surface free: the best fit that any "
                "power spectral density allows",
                [](const T& of) { return of.of->free_energies; }),
        made<T>("strained_interface", "balance with an interfacial energy that depends on strain (Eq. 6)",
                [](const T& of) { return of.of->strained_interface; }),
        made<T>("reference_scaled",
                "full-contact balance (Eq. 7) with W_int of each elastomer c times W_app of its smooth reference",
                [](const T& of) {
                    return output::outcome_of<output::FittedFactor>(
                        of.of->reference_scaled,
                        [](const adhesion::WorkFit& fit) { return output::FittedFactor{&fit}; });
                }),
    };
    static constexpr Description description{"fits", "fits of W_int to the pairs", rows};
};

}  // namespace setae::fields
