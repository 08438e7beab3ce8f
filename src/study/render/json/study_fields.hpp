// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A study as its JSON has it.

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pair_fields.hpp"
#include "setae/adhesion/input_profile.hpp"
#include "setae/adhesion/left_out.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/budget.hpp"
#include "setae/output/hysteresis_fields.hpp"
#include "setae/output/loop_model_fields.hpp"
#include "setae/output/replicate_fields.hpp"
#include "setae/output/verdict.hpp"
#include "setae/study/study_result.hpp"
#include "surface_fields.hpp"
#include "work_fit_fields.hpp"

namespace setae::output {

/// A row of a budget in the unit of its quantity.
struct BudgetEntry {
    BudgetRow row;
    std::string unit;
};

/// A fit with the spectra cut at a wavelength.
struct CutFit {
    const adhesion::WorkFit* fit;
};

/// Parameters of a surface with its spectrum cut at a wavelength.
struct CutSurface {
    const roughness::SpectralParameters* parameters;
};

/// Fits and surfaces with the spectra cut at a wavelength.
struct CutoffEntry {
    const study::CutoffPoint* point;
    const study::StudyResult* result;

    [[nodiscard]] std::vector<std::pair<std::string, CutSurface>> surfaces() const {
        std::vector<std::pair<std::string, CutSurface>> all;
        for (std::size_t i = 0; i < result->surfaces.size(); ++i)
            all.emplace_back(result->surfaces[i].name, CutSurface{&point->surfaces[i]});
        return all;
    }
};

/// A balance against the best of all.
struct BalanceEntry {
    const study::ComparedBalance* compared;
    double best_log_likelihood = 0.0;
};

/// Conclusions by one spectrum of each surface.
struct ConclusionsEntry {
    const study::Conclusions* of;
    const study::StudyResult* result;

    [[nodiscard]] study::Outcome<Quantity> work_of_adhesion() const {
        return outcome_of<Quantity>(of->work_of_adhesion, [this](const Estimate& work) {
            return Quantity{.estimate = work, .source = of->work_of_adhesion_source};
        });
    }
    [[nodiscard]] std::vector<PairEntry> pairs() const {
        std::vector<PairEntry> all;
        for (const auto& pair : of->pairs) all.push_back({&pair, &of->draws});
        return all;
    }
    [[nodiscard]] std::vector<CutoffEntry> cutoff_scan() const {
        std::vector<CutoffEntry> all;
        for (const auto& point : of->cutoff_scan) all.push_back({&point, result});
        return all;
    }
    [[nodiscard]] std::vector<BalanceEntry> balances() const {
        double best = -std::numeric_limits<double>::infinity();
        for (const auto& balance : of->balances) best = std::max(best, balance.score.log_likelihood);
        std::vector<BalanceEntry> all;
        for (const auto& balance : of->balances) all.push_back({&balance, best});
        return all;
    }
};

/// An elastomer of a study.
struct ElastomerEntry {
    const study::ElastomerResult* elastomer;
};

/// A loop, or why it failed.
struct ExperimentEntry {
    const study::ExperimentResult* experiment;
};

/// A published value beside the one of this study.
struct ReportedEntry {
    const study::ReportedValue* reported;
    const study::Conclusions* conclusions;

    [[nodiscard]] bool is_work() const { return reported->quantity == "work_of_adhesion"; }
    [[nodiscard]] Quantity in_its_unit(const Estimate& value) const {
        return {.quantity = is_work() ? "intrinsic_work_of_adhesion" : reported->quantity,
                .symbol = is_work() ? "W_int" : "R2",
                .estimate = value,
                .unit = is_work() ? "J/m2" : "1"};
    }
    [[nodiscard]] const adhesion::WorkFit* fit() const {
        const auto& c = *conclusions;
        if (reported->fit == "modified" && c.modified) return &*c.modified;
        if (reported->fit == "persson_tosatti" && c.persson_tosatti) return &*c.persson_tosatti;
        if (reported->fit == "loop" && c.loop) return &c.loop->through_origin;
        return nullptr;
    }
    [[nodiscard]] std::optional<Quantity> here() const {
        const auto* found = fit();
        if (!found) return std::nullopt;
        return in_its_unit(is_work() ? found->work_of_adhesion.value : found->r_squared);
    }

private:
    [[nodiscard]] Quantity in_its_unit(double value) const { return in_its_unit(Estimate{.value = value}); }
};

/// Size of a file.
struct FileSize {
    std::uintmax_t value = 0;
};

/// Program and files of a study.
struct Provenance {};

/// A study; what may have thousands of entries is added later.
struct StudyEntry {
    const study::StudyResult* result;

    [[nodiscard]] ConclusionsEntry conclusions() const { return {result, result}; }
};

}  // namespace setae::output

namespace setae::fields {

template <>
struct Described<output::Verdict> {
    using T = output::Verdict;
    static constexpr std::array rows{
        field<&T::answer>("answer", "sentences that answer the question of the study"),
        field<&T::findings>("findings", "sentences on what tests support"),
        field<&T::limits>("limits", "sentences on what cannot be concluded"),
        inner<&T::reservations>(),
    };
    static constexpr Description description{"", "the result in sentences", rows};
};
static_assert(complete<output::Verdict>);

template <>
struct Described<output::BudgetEntry> {
    using T = output::BudgetEntry;
    static constexpr std::array rows{
        made<T>("input", "name of the input", [](const T& of) -> const std::string& { return of.row.input; }),
        made<T>("standard_error", "standard error from this input only",
                [](const T& of) { return of.row.standard_error; }),
        made<T>("share_of_variance", "share of the variance of the quantity", [](const T& of) { return of.row.share; }),
        made<T>("standard_error_with_half_of_it", "standard error of the quantity with half the error of this input",
                [](const T& of) { return of.row.halved; }),
        inner<&T::row>(),
        field<&T::unit>("unit", "unit of both standard errors"),
    };
    static constexpr Description description{"", "the part of one input", rows};
};
static_assert(complete<output::BudgetEntry>);

template <>
struct Described<output::QuotedBudget> {
    using T = output::QuotedBudget;
    static constexpr std::array rows{
        field<&T::quantity>("quantity", "name of the quantity"),
        field<&T::symbol>("symbol", "symbol of the quantity"),
        field<&T::standard_error>("standard_error", "standard error of the quantity"),
        field<&T::unit>("unit", "unit of the standard error"),
        made<T>("inputs", "one entry per input, the largest share first",
                [](const T& of) {
                    std::vector<output::BudgetEntry> all;
                    for (const auto& row : of.rows) all.push_back({row, of.unit});
                    return all;
                }),
        made<T>("surface", "name of the surface, for a quantity of a pair",
                [](const T& of) { return output::where_given(of.surface); }),
        made<T>("elastomer", "name of the elastomer, for a quantity of a pair",
                [](const T& of) -> std::optional<std::string> {
                    if (of.surface.empty()) return std::nullopt;
                    return of.elastomer;
                }),
        inner<&T::surface>(),
        inner<&T::elastomer>(),
        inner<&T::rows>(),
    };
    static constexpr Description description{"budget", "parts of the standard error of a quoted quantity", rows};
};
static_assert(complete<output::QuotedBudget>);

template <>
struct Described<adhesion::LeftOutPrediction> {
    using T = adhesion::LeftOutPrediction;
    static constexpr std::array rows{
        made<T>("left_out", "`surface` or `elastomer`",
                [](const T& of) { return std::string_view(of.surface_left_out ? "surface" : "elastomer"); }),
        made<T>("name", "name of the surface or elastomer that was left out of the fit",
                [](const T& of) -> const std::string& { return of.surface_left_out ? of.surface : of.elastomer; }),
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        quantity<&T::predicted>("predicted", "W_app", "J/m2", "W_app predicted by the fit to the other pairs")
            .as("apparent_work_of_adhesion"),
        quantity<&T::measured>("measured", "W_app", "J/m2", "measured W_app").as("apparent_work_of_adhesion"),
        made<T>("residual", "W_app - W_app,predicted", "J/m2", "measured minus predicted value",
                [](const T& of) {
                    return Estimate{.value = of.residual, .standard_error = of.standard_error, .method = "delta"};
                })
            .as("residual_work_of_adhesion"),
        field<&T::within_interval>("held", "whether the 95 % interval of the residual covers 0"),
        inner<&T::surface_left_out>(),
        inner<&T::residual>(),
        inner<&T::standard_error>(),
    };
    static constexpr Description description{"left_out_prediction", "a pair predicted by the fit to the others", rows};
};
static_assert(complete<adhesion::LeftOutPrediction>);

template <>
struct Described<adhesion::ProfilePoint> {
    using T = adhesion::ProfilePoint;
    static constexpr std::array rows{
        field<&T::shift>("shift", "shift of the input from its stated value, in standard errors"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W_int", "J/m2", "W_int with this value of the input")
            .as("intrinsic_work_of_adhesion"),
        field<&T::log_likelihood>("log_likelihood", "log-likelihood of the pairs"),
    };
    static constexpr Description description{"", "the fit at one value of an input", rows};
};
static_assert(complete<adhesion::ProfilePoint>);

template <>
struct Described<adhesion::InputProfile> {
    using T = adhesion::InputProfile;
    static constexpr std::array rows{
        field<&T::input>("input", "name of the input"),
        field<&T::points>("points", "one entry per value of the input"),
        quantity<&T::by_pairs>("by_pairs", "(x - stated)/u(x)", "1",
                               "shift of the input at the largest likelihood of the pairs, in its standard errors")
            .as("input_shift"),
    };
    static constexpr Description description{"input_profile", "W_int against the value of one stated input", rows};
};
static_assert(complete<adhesion::InputProfile>);

template <>
struct Described<adhesion::PredictionResidual> {
    using T = adhesion::PredictionResidual;
    static constexpr std::array rows{
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        quantity<&T::measured>("measured", "W_app", "J/m2", "measured W_app").as("apparent_work_of_adhesion"),
        quantity<&T::predicted>("predicted", "max(0, W_app)", "J/m2",
                                "W_app by the full-contact balance (Eq. 7), floored at 0")
            .as("work_of_adhesion_floored"),
        made<T>("residual", "W_app - W_app,predicted", "J/m2", "measured minus predicted value",
                [](const T& of) {
                    return Estimate{.value = of.residual, .standard_error = of.standard_error, .method = "delta"};
                })
            .as("residual_work_of_adhesion"),
        made<T>("standardised_residual", "residual/standard error", "1", "residual over its standard error",
                [](const T& of) { return of.standardised(); }),
        inner<&T::residual>(),
        inner<&T::standard_error>(),
    };
    static constexpr Description description{"", "a measured value beside its prediction", rows};
};
static_assert(complete<adhesion::PredictionResidual>);

template <>
struct Described<adhesion::PredictionTest> {
    using T = adhesion::PredictionTest;
    static constexpr std::array rows{
        field<&T::work_fitted>("work_of_adhesion_fitted_to_them", "whether W_int was fitted to the same pairs"),
        field<&T::pairs>("pairs", "one entry per pair"),
        field<&T::left_out>("left_out", "pairs that were not compared, with the reason"),
        field<&T::n>("n", "number of pairs"),
        field<&T::degrees_of_freedom>("degrees_of_freedom", "degrees of freedom of χ²"),
        quantity<&T::chi_squared>("chi_squared", "chi2", "1", "χ² of the residuals")
            .from("r' C^-1 r with the covariance of measured and predicted values"),
        field<&T::probability>("probability", "probability of a χ² at least as large"),
        quantity<&T::extra_scatter>("extra_scatter", "tau", "J/m2",
                                    "scatter between pairs with which χ² equals its degrees of freedom")
            .from("scatter of the model with which chi2 is its degrees of freedom"),
        quantity<&T::chi_squared_with_scatter>("chi_squared_with_scatter", "chi2", "1", "χ² with this scatter"),
        field<&T::probability_with_scatter>("probability_with_scatter",
                                            "probability of a χ² at least as large with this scatter"),
    };
    static constexpr Description description{"prediction_test", "test of predicted against measured values", rows};
};
static_assert(complete<adhesion::PredictionTest>);

template <>
struct Described<output::CutFit> {
    using T = output::CutFit;
    static constexpr std::array rows{
        made<T>("work_of_adhesion", "W_int", "J/m2", "W_int by least squares",
                [](const T& of) { return of.fit->work_of_adhesion; })
            .as("intrinsic_work_of_adhesion"),
        made<T>("r_squared", "R2", "1", "1 − SS_res/SS_tot", [](const T& of) { return of.fit->r_squared; }),
        made<T>("generalised", "W_int", "J/m2", "W_int by generalised least squares",
                [](const T& of) { return of.fit->generalised.estimate(); })
            .as("intrinsic_work_of_adhesion"),
        made<T>("log_likelihood", "log-likelihood of the pairs",
                [](const T& of) { return of.fit->generalised.log_likelihood; }),
    };
    static constexpr Description description{"", "a fit with the spectra cut at a wavelength", rows};
};

template <>
struct Described<output::CutSurface> {
    using T = output::CutSurface;
    static constexpr std::array rows{
        made<T>("rms_slope", "h'_rms", "1", "rms slope", [](const T& of) { return of.parameters->rms_slope; }),
        made<T>("elastic_energy_per_modulus", "U_el/(A_app E*)", "m", "elastic energy per nominal area over E*",
                [](const T& of) { return of.parameters->elastic_energy_per_modulus; }),
    };
    static constexpr Description description{"", "parameters of a surface with its spectrum cut", rows};
};

template <>
struct Described<output::CutoffEntry> {
    using T = output::CutoffEntry;
    static constexpr std::array rows{
        made<T>("shortest_wavelength", "lambda_s", "m", "wavelength at which all spectra are cut",
                [](const T& of) { return of.point->shortest_wavelength; })
            .as("cutoff_wavelength"),
        made<T>("modified", "full-contact balance (Eq. 7)",
                [](const T& of) { return output::CutFit{&of.point->modified}; }),
        made<T>("persson_tosatti", "Persson–Tosatti balance (Eq. S13)",
                [](const T& of) { return output::CutFit{&of.point->persson_tosatti}; }),
        made<T>("surfaces", "parameters of each surface", [](const T& of) { return of.surfaces(); })
            .with(Missing::left_out),
    };
    static constexpr Description description{"cut_off", "fits with the spectra cut at a wavelength", rows};
};

template <>
struct Described<output::BalanceEntry> {
    using T = output::BalanceEntry;
    static constexpr std::array rows{
        made<T>("balance", "name of the balance",
                [](const T& of) -> const std::string& { return of.compared->balance; }),
        made<T>("n", "number of pairs", [](const T& of) { return of.compared->score.n; }),
        made<T>("parameters", "number of fitted parameters", [](const T& of) { return of.compared->score.parameters; }),
        made<T>("shortest_wavelength", "lambda_s", "m", "wavelength at which all spectra are cut, where they are",
                [](const T& of) -> std::optional<double> {
                    const double wavelength = of.compared->shortest_wavelength;
                    if (!(wavelength > 0.0)) return std::nullopt;
                    return wavelength;
                })
            .as("cutoff_wavelength"),
        made<T>("surface_energy_factor", "gamma1/gamma1", "1", "factor on γ1 of every elastomer",
                [](const T& of) { return of.compared->surface_energy_factor; }),
        made<T>("work_of_adhesion", "W_int", "J/m2", "W_int by least squares",
                [](const T& of) { return of.compared->score.work_of_adhesion; })
            .as("intrinsic_work_of_adhesion"),
        made<T>("r_squared", "R2", "1", "1 − SS_res/SS_tot", [](const T& of) { return of.compared->score.r_squared; }),
        made<T>("log_likelihood_difference", "ln L - max", "1", "log-likelihood minus that of the best balance",
                [](const T& of) { return of.compared->score.log_likelihood - of.best_log_likelihood; }),
        made<T>("left_out_deviation", "s_out", "J/m2", "leave-one-surface-out prediction error, rms",
                [](const T& of) { return of.compared->score.left_out_deviation; }),
    };
    static constexpr Description description{"balance", "an energy balance compared with the others", rows};
};

template <>
struct Described<study::ElastomerResult> {
    using T = study::ElastomerResult;
    static constexpr std::array rows{
        made<T>("youngs_modulus", "E", "Pa", "Young's modulus",
                [](const T& of) {
                    return Quantity{.estimate = of.youngs_modulus,
                                    .source = of.modulus_from_loops ? "mean of the loops on it" : "given"};
                }),
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "contact modulus against the rough solid"),
        made<T>("surface_energy", "gamma_1", "J/m2", "surface energy of the elastomer",
                [](const T& of) { return of.input.surface_energy; }),
        quantity<&T::network_modulus>("network_modulus", "rho R T/M_c", "Pa",
                                      "modulus from the density of the network: a check of plausibility")
            .from("plausibility, not a measurement"),
        field<&T::shared_fit>("shared_fit", "fit whose parameters the loops on the elastomer share"),
        field<&T::alerts>("alerts", "warnings on the elastomer"),
        inner<&T::input>(),
        inner<&T::youngs_modulus>(),
        inner<&T::modulus_from_loops>(),
        inner<&T::traced_youngs_modulus>(),
        inner<&T::traced_contact_modulus>(),
    };
    static constexpr Description description{"", "an elastomer", rows};
};
static_assert(complete<study::ElastomerResult>);

template <>
struct Described<output::ElastomerEntry> {
    using T = output::ElastomerEntry;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const study::ElastomerResult& { return *of.elastomer; }),
    };
    static constexpr Description description{"", "an elastomer", rows};
};

template <>
struct Described<output::ConclusionsEntry> {
    using T = output::ConclusionsEntry;
    static constexpr std::array work_rows{
        made<T>("work_of_adhesion", "W_int", "J/m2", "W_int of the predictions",
                [](const T& of) { return of.work_of_adhesion(); })
            .as("intrinsic_work_of_adhesion"),
        made<T>("work_of_adhesion_draws", "W_int from draws of all inputs",
                [](const T& of) -> std::optional<output::DrawnWork> {
                    if (!of.of->work_of_adhesion) return std::nullopt;
                    return output::drawn_work(of.of->draws.work_of_adhesion, of.of->draws);
                }),
        made<T>("budgets", "parts of the standard error of each quoted quantity",
                [](const T& of) { return output::budgets_of(*of.of); }),
        made<T>("left_out", "each pair predicted by the fit to the others",
                [](const T& of) -> const auto& { return of.of->left_out; }),
        made<T>("profiles", "W_int against the value of each stated input",
                [](const T& of) -> const auto& { return of.of->profiles; }),
        made<T>("fits", "fits of W_int to the pairs", [](const T& of) { return output::FitsOfWork{of.of}; }),
    };
    static constexpr Description work{"", "W_int and its fits", work_rows};
    static constexpr std::array test_rows{
        made<T>("prediction_test", "test of predicted against measured values",
                [](const T& of) -> const auto& { return of.of->prediction_test; }),
    };
    static constexpr Description test{"", "test of the predictions", test_rows};
    static constexpr std::array comparison_rows{
        made<T>("cutoff_scan", "fits with the spectra cut at several wavelengths",
                [](const T& of) { return of.cutoff_scan(); }),
        made<T>("balances", "energy balances compared", [](const T& of) { return of.balances(); }),
    };
    static constexpr Description comparison{"", "comparison of cut-offs and balances", comparison_rows};

    static constexpr std::array rows{
        fields_of<T>(work, [](const T& of) { return of; }),
        made<T>("pairs", "one entry per surface and elastomer", [](const T& of) { return of.pairs(); }),
        fields_of<T>(test, [](const T& of) { return of; }),
        fields_of<T>(comparison, [](const T& of) { return of; }),
    };
    static constexpr Description description{"conclusions", "conclusions by one spectrum of each surface", rows};
};

template <>
struct Described<output::ExperimentEntry> {
    using T = output::ExperimentEntry;
    static constexpr std::array rows{
        made<T>("file", "path of the file as named in the study",
                [](const T& of) -> const std::string& { return of.experiment->input.file; }),
        made<T>("surface", "name of the surface",
                [](const T& of) -> const std::string& { return of.experiment->input.surface; }),
        made<T>("elastomer", "name of the elastomer",
                [](const T& of) -> const std::string& { return of.experiment->input.elastomer; }),
        made<T>("role", "`rough` or `reference`",
                [](const T& of) { return std::string_view(of.experiment->input.reference ? "reference" : "rough"); }),
        made<T>("lens", "name of the lens", [](const T& of) { return output::where_given(of.experiment->input.lens); }),
        made<T>("spot", "name of the spot", [](const T& of) { return output::where_given(of.experiment->input.spot); }),
        made<T>("excluded", "the reason why its numbers are left out of means",
                [](const T& of) { return output::where_given(of.experiment->input.exclusion); }),
        made<T>("error", "the reason for the failure",
                [](const T& of) { return output::where_given(of.experiment->error); }),
        made<T>("analysis", "analysis of the loop; null where it failed",
                [](const T& of) -> const auto& { return of.experiment->analysis; })
            .or_null(),
        made<T>("models", "contact models fitted beside JKR",
                [](const T& of) -> const auto& { return of.experiment->models; }),
    };
    static constexpr Description description{"experiment", "a loop of the study", rows};
};

template <>
struct Described<output::ReportedEntry> {
    using T = output::ReportedEntry;
    static constexpr std::array rows{
        made<T>("fit", "name of the fit", [](const T& of) -> const std::string& { return of.reported->fit; }),
        made<T>("reported", "published value",
                [](const T& of) {
                    auto value = of.in_its_unit(of.reported->value);
                    value.source = of.reported->source;
                    return value;
                }),
        made<T>("here", "value of this study; null where it was not fitted", [](const T& of) { return of.here(); })
            .or_null(),
    };
    static constexpr Description description{"", "a published value beside the value of this study", rows};
};

template <>
struct Described<output::FileSize> {
    using T = output::FileSize;
    static constexpr std::array rows{
        field<&T::value>("value", "number of bytes"),
        made<T>("unit", "unit of the value", [](const T&) { return std::string_view("byte"); }),
    };
    static constexpr Description description{"", "size of a file", rows};
};
static_assert(complete<output::FileSize>);

template <>
struct Described<study::InputFile> {
    using T = study::InputFile;
    static constexpr std::array rows{
        field<&T::path>("file", "path of the file as named in the study"),
        made<T>("size", "size of the file", [](const T& of) { return output::FileSize{of.size}; }),
        made<T>("sha256", "digest of its bytes; null for a folder or a file that could not be read",
                [](const T& of) { return output::where_given(of.sha256); })
            .or_null(),
        inner<&T::size>(),
        inner<&T::sha256>(),
        inner<&T::state>(),
        inner<&T::settled>(),
        inner<&T::changed>(),
    };
    static constexpr Description description{"", "a file that the study names", rows};
};
static_assert(complete<study::InputFile>);

template <>
struct Described<output::Provenance> {
    using T = output::Provenance;
    static constexpr std::array rows{
        made<T>("program", "name of the program: `setae`", [](const T&) { return std::string_view("setae"); }),
        made<T>("version", "version of the program", [](const T&) { return study::version(); }),
        list_filled_later<study::InputFile>("inputs", "files that the study names"),
    };
    static constexpr Description description{"", "program and files of the results", rows};
};

template <>
struct Described<output::StudyEntry> {
    using T = output::StudyEntry;
    using Conclusions = Described<output::ConclusionsEntry>;
    static constexpr std::array rows{
        made<T>("title", "title of the study",
                [](const T& of) -> const std::string& { return of.result->study.title; }),
        made<T>("description", "description of the study",
                [](const T& of) -> const std::string& { return of.result->study.description; }),
        made<T>("verdict", "the result in sentences", [](const T& of) { return output::verdict(*of.result); }),
        fields_of<T>(Conclusions::work, [](const T& of) { return of.conclusions(); }),
        objects_filled_later<output::SurfaceEntry>("surfaces", "surfaces by name"),
        made<T>("elastomers", "elastomers by name",
                [](const T& of) {
                    std::vector<std::pair<std::string, output::ElastomerEntry>> all;
                    for (const auto& elastomer : of.result->elastomers)
                        all.emplace_back(elastomer.input.name, output::ElastomerEntry{&elastomer});
                    return all;
                }),
        list_filled_later<output::PairEntry>("pairs", "one entry per surface and elastomer"),
        fields_of<T>(Conclusions::test, [](const T& of) { return of.conclusions(); }),
        made<T>("hysteresis", "retraction of all pairs, as `setae predict` gives it",
                [](const T& of) {
                    return output::outcome_of<output::HysteresisEntry>(
                        of.result->hysteresis, [](const study::Hysteresis& h) { return output::HysteresisEntry{&h}; });
                }),
        made<T>("replicates", "means over loops, one entry per elastomer and quantity",
                [](const T& of) {
                    std::vector<output::ElastomerMeans> all;
                    for (const auto& replicates : of.result->replicates) all.push_back({&replicates});
                    return all;
                }),
        made<T>("by_average", "conclusions from averaged spectra, where fitted spectra are used",
                [](const T& of) -> std::optional<output::ConclusionsEntry> {
                    if (!of.result->by_average) return std::nullopt;
                    return output::ConclusionsEntry{&*of.result->by_average, of.result};
                }),
        list_filled_later<output::ExperimentEntry>("experiments", "one entry per loop"),
        made<T>("references", "smooth spheres on smooth references",
                [](const T& of) -> const auto& { return of.result->references; }),
        made<T>("reference_changes", "change of the smooth references during the study",
                [](const T& of) -> const auto& { return of.result->reference_drifts; }),
        fields_of<T>(Conclusions::comparison, [](const T& of) { return of.conclusions(); }),
        made<T>("loss_slope_of_works", "E_loss/A_true", "J/m2",
                "loss per true area of loops with the measured W_app and W_ret",
                [](const T& of) -> std::optional<Quantity> {
                    const auto& slope = of.result->loss_slope_of_works;
                    if (!slope) return std::nullopt;
                    return with_count(slope->pairs, slope->work_per_true_area);
                })
            .as("loss_per_true_area")
            .from("loops with the measured W_app and W_ret, through the origin")
            .or_null(),
        made<T>("reported", "published values beside those of this study",
                [](const T& of) {
                    std::vector<output::ReportedEntry> all;
                    for (const auto& reported : of.result->study.reported) all.push_back({&reported, of.result});
                    return all;
                }),
        list_filled_later<Alert>("alerts", "warnings of the study"),
        made<T>("provenance", "program and files of the results", [](const T&) { return output::Provenance{}; }),
    };
    static constexpr Description description{"study_results", "results of a study, as in study.json", rows};
};

}  // namespace setae::fields
