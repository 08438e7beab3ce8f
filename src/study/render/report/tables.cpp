// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.hpp"

#include <array>
#include <functional>
#include <map>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "markup.hpp"
#include "setae/core/units.hpp"
#include "setae/output/verdict.hpp"
#include "setae/study/contact_answers.hpp"

namespace setae::report {
namespace {

using output::Json;
using study::StudyResult;

using Row = std::vector<Cell>;

std::string text_of(const Json& json) { return json.is_string() ? json.get<std::string>() : std::string(); }

/// Pointers of the spectra of a surface, the one used first, each with its name.
std::vector<std::pair<std::string, std::string>> spectra_of(const study::SurfaceResult& surface, const Json& study) {
    const auto base = named("/surfaces", surface.name);
    std::vector<std::pair<std::string, std::string>> list{{study::method_name(surface, surface.method), base}};
    if (const auto& others = entry(study, joined(base, "spectra")); others.is_object())
        for (const auto& [method, spectrum] : others.items())
            if (method != list.front().first) list.emplace_back(method, named(joined(base, "spectra"), method));
    return list;
}

DataTable surfaces(const StudyResult& result, const Json& study) {
    DataTable table{
        "surfaces",
        "Surfaces",
        "Each row is one spectrum. All other results use the first spectrum of a surface. ± is one standard error, [ ] the 95 % interval, both by the method of the last column. "
        "Heights are unfiltered. The band gives the wavevectors of the numbers; <i>n</i> counts measurements.",
        {{"surface", ""},
         {"spectrum", ""},
         {"*h*_rms", "m"},
         {"*h*'_rms", "1"},
         {"*h*''_rms", "1/m"},
         {"*A*_true/*A*_app", "1"},
         {"*U*_el/(*A*_app *E*\\*)", "m"},
         {"band *q*", "1/m"},
         {"*n*", "1"},
         {"± and [ ] from", ""}},
        {}};
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) {
            Row row{TextCell{surface.name}, TextCell{"failed: " + surface.error}};
            row.resize(table.columns.size(), TextCell{"–"});
            table.rows.push_back(row);
            continue;
        }
        for (const auto& [method, base] : spectra_of(surface, study)) {
            const auto quantity = [&base](const char* name) { return QuantityCell{joined(base, name)}; };
            const auto& height = entry(study, joined(base, "rms_height"));
            table.rows.push_back({TextCell{surface.name}, TextCell{method}, quantity("rms_height"),
                                  quantity("rms_slope"), quantity("rms_curvature"), quantity("true_area_ratio"),
                                  quantity("elastic_energy_per_modulus"), BandCell{joined(base, "rms_height/band")},
                                  NumberCell{joined(base, "rms_height/n")},
                                  TextCell{height.contains("interval") ? text_of(height.at("method")) : "–"}});
        }
    }
    return table;
}

DataTable decades(const StudyResult& result, const Json& study) {
    DataTable table{"decades",
                    "Spectra by decade",
                    "Geometric mean of <i>C</i><sub>1D</sub> over ln <i>q</i> in each decade of wavevectors.",
                    {{"surface", ""}, {"spectrum", ""}, {"band *q*", "1/m"}, {"*C*_1D", "m3"}, {"± and [ ] from", ""}},
                    {}};
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) continue;
        for (const auto& [method, base] : spectra_of(surface, study)) {
            const auto& list = entry(study, joined(base, "decades"));
            for (std::size_t i = 0; i < list.size(); ++i) {
                const auto place = joined(base, fmt::format("decades/{}", i));
                table.rows.push_back({TextCell{surface.name}, TextCell{method}, BandCell{joined(place, "band")},
                                      QuantityCell{place}, TextCell{text_of(list[i].value("method", Json()))}});
            }
        }
    }
    return table;
}

DataTable agreement(const StudyResult& result, const Json& study) {
    DataTable table{
        "agreement",
        "Agreement of instruments with the fitted spectra",
        "Ratio of measured to expected periodograms of each instrument, the latter from the fitted spectrum. <i>p</i> is the probability of a χ² at least as large by chance.",
        {{"surface", ""},
         {"instrument", ""},
         {"band *q*", "1/m"},
         {"measured/expected", "1"},
         {"*χ*²", "1"},
         {"groups of modes *n*", "1"},
         {"*p*", "1"}},
        {}};
    for (const auto& surface : result.surfaces) {
        const auto base = joined(named("/surfaces", surface.name), "likelihood/agreement");
        const auto& list = entry(study, base);
        for (std::size_t i = 0; i < list.size(); ++i) {
            const auto place = joined(base, std::to_string(i));
            table.rows.push_back({TextCell{surface.name}, TextCell{text_of(list[i].at("instrument"))},
                                  BandCell{joined(place, "band")}, NumberCell{joined(place, "ratio")},
                                  NumberCell{joined(place, "chi_squared")}, NumberCell{joined(place, "groups")},
                                  NumberCell{joined(place, "probability")}});
        }
    }
    return table;
}

DataTable elastomers(const StudyResult& result, const Json& study) {
    DataTable table{"elastomers",
                    "Elastomers",
                    "",
                    {{"elastomer", ""},
                     {"*E*", "Pa"},
                     {"*E*\\*", "Pa"},
                     {"*γ*_1", "J/m2"},
                     {"*ρRT*/*M*_c", "Pa"},
                     {"*E* from", ""}},
                    {}};
    for (const auto& elastomer : result.elastomers) {
        const auto base = named("/elastomers", elastomer.input.name);
        table.rows.push_back({TextCell{elastomer.input.name}, QuantityCell{joined(base, "youngs_modulus")},
                              QuantityCell{joined(base, "contact_modulus")},
                              QuantityCell{joined(base, "surface_energy")},
                              QuantityCell{joined(base, "network_modulus")},
                              TextCell{text_of(entry(study, joined(base, "youngs_modulus/source")))}});
    }
    return table;
}

DataTable pairs_measured(const StudyResult& result) {
    DataTable table{
        "pairs-measured",
        "Pairs: measured",
        "Work of adhesion on approach, and at pull-off from the force (Eq. S1) and from the last points (Eq. S2). Energy loss of a loop and of an ideal smooth sphere. Contact area at the largest preload.",
        {{"surface", ""},
         {"elastomer", ""},
         {"loops *n*", "1"},
         {"*W*_app approach", "J/m2"},
         {"*W* at pull-off (Eq. S1)", "J/m2"},
         {"*W* at pull-off (Eq. S2)", "J/m2"},
         {"*E*_loss", "J"},
         {"*E*_loss of a smooth sphere", "J"},
         {"π*a*_max^2", "m2"},
         {"share of the smooth reference in *W*_ret − *W*_app", "1"}},
        {}};
    for (std::size_t i = 0; i < result.pairs.size(); ++i) {
        const auto& pair = result.pairs[i];
        if (!pair.approach && !pair.pull_off && !pair.retraction && !pair.loss && !pair.contact_area) continue;
        const auto base = fmt::format("/pairs/{}", i);
        const auto measured = [&](const char* name) { return QuantityCell{joined(base + "/measured", name)}; };
        table.rows.push_back({TextCell{pair.surface}, TextCell{pair.elastomer}, NumberCell{joined(base, "experiments")},
                              measured("work_of_adhesion_approach"), measured("work_of_adhesion_pull_off"),
                              measured("work_of_adhesion_retraction"), measured("energy_loss"),
                              measured("ideal_smooth_sphere_loss"), measured("contact_area"),
                              measured("reference_share")});
    }
    return table;
}

DataTable pairs_predicted(const StudyResult& result) {
    DataTable table{
        "pairs-predicted",
        "Pairs: predicted from roughness",
        "The first <i>W</i><sub>app</sub> is the recommended prediction for contact without load, from simulated patches; for full contact it equals the full-contact balance (Eq. 7). The following columns give the balances of Eqs. 7, S13 and 2, "
        "Eq. 7 also before it is set to 0. Half of the stored energy comes from wavelengths longer than <i>λ</i><sub>1/2</sub>.",
        {{"surface", ""},
         {"elastomer", ""},
         {"*W*_app", "J/m2"},
         {"*W*_app (Eq. 7)", "J/m2"},
         {"*W*_app (Eq. S13)", "J/m2"},
         {"*W*_app (Eq. 2)", "J/m2"},
         {"measured − max(0, Eq. 7)", "J/m2"},
         {"*U*_el/*A*_app", "J/m2"},
         {"*A*_true/*A*_app", "1"},
         {"*λ*_{1/2}", "m"},
         {"*E*_loss (Eq. 10)", "J"},
         {"note", ""}},
        {}};
    for (std::size_t i = 0; i < result.pairs.size(); ++i) {
        const auto& pair = result.pairs[i];
        if (!pair.modified) continue;
        const auto base = fmt::format("/pairs/{}", i);
        const auto quantity = [&](const char* name) { return QuantityCell{joined(base, name)}; };
        table.rows.push_back(
            {TextCell{pair.surface}, TextCell{pair.elastomer}, quantity("partial_contact/work_of_adhesion"),
             quantity("modified/work_of_adhesion"), quantity("persson_tosatti/work_of_adhesion"),
             quantity("without_area_change/work_of_adhesion"), quantity("residual"), quantity("stored_energy"),
             quantity("true_area_ratio"), quantity("wavelength_of_half_the_stored_energy"),
             quantity("predicted_energy_loss"), TextCell{pair.scales ? adhesion::name(pair.closing()) : ""}});
    }
    return table;
}

DataTable budget(const StudyResult& result) {
    DataTable table{"budget",
                    "Contributions to the ± of the full-contact balance (Eq. 7)",
                    "Each column gives the ± from one uncertain input only.",
                    {{"surface", ""},
                     {"elastomer", ""},
                     {"spectrum", "J/m2"},
                     {"modulus", "J/m2"},
                     {"surface energy *γ*_1", "J/m2"},
                     {"*W*_int", "J/m2"}},
                    {}};
    for (std::size_t i = 0; i < result.pairs.size(); ++i) {
        if (!result.pairs[i].budget) continue;
        const auto base = fmt::format("/pairs/{}/modified/standard_error_budget", i);
        const auto number = [&base](const char* name) { return NumberCell{joined(base, name)}; };
        table.rows.push_back({TextCell{result.pairs[i].surface}, TextCell{result.pairs[i].elastomer},
                              number("spectrum"), number("modulus"), number("surface_energy"),
                              number("work_of_adhesion")});
    }
    return table;
}

/// Reported numbers against their inputs; small shares are only in budget.csv.
DataTable inputs_of_numbers(const Json& study) {
    constexpr double least = 0.01;
    DataTable table{
        "budget-inputs",
        "Contributions of inputs to the ± of each number",
        "Inputs have the names of the study file. The file budget.csv also contains inputs with less than 1 % of a variance. The last column gives the remaining ± if the ± of "
        "this input is halved.",
        {{"number", ""},
         {"surface", ""},
         {"elastomer", ""},
         {"input", ""},
         {"± from this input", ""},
         {"share of the variance", "1"},
         {"± if halved", ""}},
        {}};
    const auto& budgets = entry(study, "/budgets");
    for (std::size_t i = 0; i < budgets.size(); ++i) {
        const auto text = [&](const char* key) {
            return TextCell{budgets[i].contains(key) ? budgets[i].at(key).get<std::string>() : "–"};
        };
        const auto& inputs = budgets[i].at("inputs");
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            if (inputs[k].at("share_of_variance").get<double>() < least) continue;
            const auto base = fmt::format("/budgets/{}/inputs/{}", i, k);
            const auto error = [&](const char* key) {
                return TextCell{
                    format_value(inputs[k].at(key).get<double>(), budgets[i].at("unit").get<std::string>(), 2)};
            };
            table.rows.push_back({text("symbol"), text("surface"), text("elastomer"),
                                  TextCell{inputs[k].at("input").get<std::string>()}, error("standard_error"),
                                  NumberCell{joined(base, "share_of_variance")},
                                  error("standard_error_with_half_of_it")});
        }
    }
    return table;
}

/// Pairs predicted without their surface, then without their elastomer.
DataTable left_out(const Json& study) {
    DataTable table{
        "left-out",
        "Leave-one-out predictions of pairs",
        "The full-contact balance (Eq. 7) predicts every pair, with <i>W</i><sub>int</sub> from all pairs on other surfaces, then from all pairs on other elastomers. The ± "
        "include the scatter between the other pairs. The residuals estimate the error for a new surface or a new elastomer.",
        {{"left out", ""},
         {"surface", ""},
         {"elastomer", ""},
         {"measured *W*_app", "J/m2"},
         {"predicted", "J/m2"},
         {"residual", "J/m2"},
         {"within 95 %", ""}},
        {}};
    const auto& list = entry(study, "/left_out");
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto quantity = [&](const char* key) { return QuantityCell{fmt::format("/left_out/{}/{}", i, key)}; };
        const auto text = [&](const char* key) { return TextCell{list[i].at(key).get<std::string>()}; };
        table.rows.push_back({text("left_out"), text("surface"), text("elastomer"), quantity("measured"),
                              quantity("predicted"), quantity("residual"),
                              TextCell{list[i].at("held").get<bool>() ? "yes" : "no"}});
    }
    return table;
}

/// Stated inputs against their values from the pairs.
DataTable profiles(const Json& study) {
    DataTable table{
        "profiles",
        "Stated inputs against the pairs",
        "Each input is shifted by two of its ± and treated as exact. The last column gives the value of the input from the pairs only, as difference from the stated value in units of "
        "its ±. Check an input whose difference exceeds 2. A ± much larger than 1 means that the pairs do not determine the input.",
        {{"input", ""},
         {"*W*_int, input lower by 2 ±", "J/m2"},
         {"*W*_int, input higher by 2 ±", "J/m2"},
         {"input from the pairs, in its ±", "1"}},
        {}};
    const auto& list = entry(study, "/profiles");
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto at = fmt::format("/profiles/{}", i);
        const auto work = [&](std::size_t point) {
            return QuantityCell{fmt::format("{}/points/{}/work_of_adhesion", at, point)};
        };
        const bool told = list[i].at("by_pairs").contains("standard_error");
        table.rows.push_back({TextCell{list[i].at("input").get<std::string>()}, work(0),
                              work(list[i].at("points").size() - 1),
                              told ? Cell(QuantityCell{joined(at, "by_pairs")}) : Cell(TextCell{"not determined"})});
    }
    return table;
}

/// Rows of one set of fits; `spectra` names their spectra.
void add_fits(DataTable& table, const Json& study, const std::string& base, const std::string& spectra, bool reported) {
    const auto row = [&](const std::string& fit, const std::string& variant, const std::string& place,
                         const std::string& n) {
        std::string work, r_squared;
        const auto& list = entry(study, "/reported");
        for (std::size_t i = 0; i < list.size() && reported && variant == "least squares"; ++i)
            if (list[i].at("fit") == fit)
                (list[i].at("reported").at("quantity") == "r_squared" ? r_squared : work) =
                    fmt::format("/reported/{}/reported", i);
        const auto cell = [](const std::string& pointer) -> Cell {
            return pointer.empty() ? Cell(TextCell{"–"}) : Cell(QuantityCell{pointer});
        };
        const bool nested = entry(study, joined(place, "work_of_adhesion")).is_object();
        table.rows.push_back({TextCell{balance_name(fit)}, TextCell{variant}, TextCell{spectra},
                              QuantityCell{nested ? joined(place, "work_of_adhesion") : place},
                              nested ? Cell(QuantityCell{joined(place, "r_squared")}) : TextCell{"–"},
                              nested ? Cell(QuantityCell{joined(place, "chi_squared")}) : TextCell{"–"}, NumberCell{n},
                              cell(work), cell(r_squared)});
    };
    static constexpr std::array<std::pair<const char*, const char*>, 8> variants{
        {{"posterior", "scatter integrated out"},
         {"generalised", "all errors with their covariance"},
         {"", "least squares"},
         {"clustered", "errors clustered by surface and elastomer"},
         {"weighted", "weighted by the measured ±"},
         {"with_extra_scatter", "with extra scatter"},
         {"errors_in_both", "errors in both"},
         {"likelihood", "profile likelihood"}}};
    const auto whole = [&](const std::string& fit, const std::string& place, const std::string& prefix) {
        if (!entry(study, place).is_object()) return;
        for (const auto& [key, name] : variants) {
            const auto where = *key ? joined(place, key) : place;
            if (entry(study, where).is_object())
                row(fit, prefix.empty() ? name : prefix + ", " + name, where, joined(place, "n"));
        }
    };
    for (const char* fit : {"modified", "persson_tosatti", "without_area_change", "loop"})
        whole(fit, joined(base, fit), "");
    const auto loop = joined(base, "loop");
    whole("loop", joined(loop, "without_ideal_loss"), "loss of a smooth sphere subtracted");
    for (const auto& [key, name] :
         {std::pair{"with_intercept", "with intercept"},
          {"without_ideal_loss_with_intercept", "loss of a smooth sphere subtracted, with intercept"}})
        if (entry(study, joined(loop, key)).is_object())
            row("loop", name, joined(loop, key), joined(loop, std::string(key) + "/n"));
    if (entry(study, joined(base, "strained_interface")).is_object())
        row("modified", "interface energy changes with stretch, χ fitted", joined(base, "strained_interface"),
            joined(base, "strained_interface/n"));
    if (entry(study, joined(base, "free_energies")).is_object())
        row("modified", "stored energy free for each surface", joined(base, "free_energies"),
            joined(base, "modified/n"));
    if (entry(study, joined(base, "free_energies/generalised")).is_object())
        row("modified", "stored energy free for each surface, all errors with their covariance",
            joined(base, "free_energies/generalised"), joined(base, "modified/n"));
}

/// Means by the mixed model of quantities in one unit.
DataTable replicate_means(const StudyResult& result, const std::string& unit, const std::string& identifier,
                          const std::string& title) {
    DataTable table{
        identifier,
        title,
        "Means of a linear mixed model over lenses, spots and repeats, with the 95 % interval in [ ]. The prediction interval covers 95 % of further measurements with another lens. "
        "Variances are pooled over the surfaces of an elastomer. <i>n</i> counts the loops of a mean without the excluded ones. <i>I</i>² is the share of the scatter that the errors of "
        "the fits do not explain.",
        {{"surface", ""},
         {"elastomer", ""},
         {"quantity", ""},
         {"mean", unit},
         {"another lens, from", unit},
         {"another lens, to", unit},
         {"mean with excluded loops", unit},
         {"*n*", "1"},
         {"excluded", "1"},
         {"*I*²", "1"},
         {"note", ""}},
        {}};
    for (std::size_t i = 0; i < result.replicates.size(); ++i) {
        const auto& replicates = result.replicates[i];
        if (replicates.data.unit != unit || !replicates.model) continue;
        for (std::size_t k = 0; k < replicates.model->surfaces.size(); ++k) {
            const auto& surface = replicates.model->surfaces[k];
            const auto base = fmt::format("/replicates/{}/surfaces/{}", i, k);
            const auto or_none = [](bool there, Cell cell) { return there ? cell : Cell(TextCell{"–"}); };
            table.rows.push_back(
                {TextCell{surface.surface}, TextCell{replicates.elastomer}, TextCell{replicates.data.quantity},
                 QuantityCell{base + "/mean"},
                 or_none(surface.prediction.has_value(), NumberCell{base + "/prediction_interval/lower"}),
                 or_none(surface.prediction.has_value(), NumberCell{base + "/prediction_interval/upper"}),
                 or_none(surface.with_excluded.has_value(), QuantityCell{base + "/with_excluded"}),
                 NumberCell{base + "/n"}, NumberCell{base + "/excluded"},
                 or_none(surface.heterogeneity.has_value(), NumberCell{base + "/heterogeneity/I2"}),
                 TextCell{fmt::format("{}", fmt::join(surface.notes, "; "))}});
        }
    }
    return table;
}

DataTable replicate_variances(const StudyResult& result, const std::string& unit, const std::string& identifier,
                              const std::string& title) {
    DataTable table{
        identifier,
        title,
        "Standard deviations from restricted maximum likelihood, pooled over the surfaces of an elastomer. Levels with identical groups are combined.",
        {{"elastomer", ""},
         {"quantity", ""},
         {"between", ""},
         {"standard deviation", unit},
         {"degrees of freedom", "1"},
         {"note", ""}},
        {}};
    for (std::size_t i = 0; i < result.replicates.size(); ++i) {
        const auto& replicates = result.replicates[i];
        if (replicates.data.unit != unit || !replicates.model) continue;
        const auto& fit = replicates.model->fits.front();
        for (std::size_t k = 0; k < fit.components.size(); ++k) {
            const auto base = fmt::format("/replicates/{}/variances/0/components/{}", i, k);
            table.rows.push_back({TextCell{replicates.elastomer}, TextCell{replicates.data.quantity},
                                  TextCell{fmt::format("{}", fmt::join(fit.components[k].includes, " and "))},
                                  QuantityCell{base + "/standard_deviation"}, NumberCell{base + "/degrees_of_freedom"},
                                  TextCell{fit.components[k].at_bound ? "at its bound" : ""}});
        }
        for (const auto& sentence : fit.not_estimable)
            table.rows.push_back({TextCell{replicates.elastomer}, TextCell{replicates.data.quantity}, TextCell{"–"},
                                  TextCell{"–"}, TextCell{"–"}, TextCell{sentence}});
    }
    return table;
}

DataTable prediction_test(const StudyResult& result, const Json& study) {
    DataTable table{"prediction-test",
                    "Measured against predicted, with the errors of both",
                    "",
                    {{"surface", ""},
                     {"elastomer", ""},
                     {"measured *W*_app", "J/m2"},
                     {"max(0, Eq. 7)", "J/m2"},
                     {"difference", "J/m2"},
                     {"in standard errors", "1"}},
                    {}};
    if (!result.prediction_test) return table;
    const auto number = [&study](const std::string& name, int decimals) {
        return number_html(study, "/prediction_test/" + name, {}, decimals);
    };
    table.note = fmt::format(
        "<i>χ</i>² = {} for {} degrees of freedom, <i>p</i> = {}. The test uses the covariance of measured values and predictions: pairs on one surface share a spectrum, and pairs on "
        "one elastomer share a modulus and a surface energy{}. With an additional scatter of the model of {}, <i>χ</i>² = {}. {}",
        number("chi_squared/value", 2), number("degrees_of_freedom", 0), number("probability", 4),
        result.prediction_test->work_fitted ? ". <i>W</i><sub>int</sub> is fitted to these pairs" : "",
        quantity_html(study, "/prediction_test/extra_scatter"), number("chi_squared_with_scatter/value", 2),
        prose(output::deviation_note(*result.prediction_test)));
    for (std::size_t i = 0; i < result.prediction_test->pairs.size(); ++i) {
        const auto base = fmt::format("/prediction_test/pairs/{}", i);
        table.rows.push_back({TextCell{result.prediction_test->pairs[i].surface},
                              TextCell{result.prediction_test->pairs[i].elastomer}, QuantityCell{base + "/measured"},
                              QuantityCell{base + "/predicted"}, QuantityCell{base + "/residual"},
                              QuantityCell{base + "/standardised_residual"}});
    }
    return table;
}

DataTable fits(const StudyResult& result, const Json& study) {
    DataTable table{
        "fits",
        "Intrinsic work of adhesion from all pairs",
        "Fits of the full-contact balance (Eq. 7), the small-slope balance (Eq. 2), the Persson–Tosatti balance (Eq. S13) and the true-area loss (Eq. 10). Reported values come from the literature.",
        {{"fit", ""},
         {"variant", ""},
         {"spectra", ""},
         {"*W*_int", "J/m2"},
         {"*R*²", "1"},
         {"*χ*²", "1"},
         {"*n*", "1"},
         {"reported *W*_int", "J/m2"},
         {"reported *R*²", "1"}},
        {}};
    add_fits(table, study, "/fits", result.by_average ? "likelihood" : "as given", true);
    if (result.by_average) add_fits(table, study, "/by_average/fits", "average", false);
    if (result.study.reported.empty()) {
        table.columns.resize(table.columns.size() - 2);
        for (auto& row : table.rows) row.resize(table.columns.size());
    }
    return table;
}

TextCell verdict(const statistics::Equivalence& test) {
    switch (test.verdict) {
        case statistics::Verdict::equivalent: return {"yes"};
        case statistics::Verdict::different: return {"no"};
        case statistics::Verdict::undecided: break;
    }
    return {"not shown"};
}

DataTable references(const StudyResult& result) {
    DataTable table{
        "references",
        "Smooth references",
        fmt::format(
            "Without roughness, both branches should give one <i>W</i>, and a loop should lose only the energy of "
            "the jumps of an ideal smooth sphere. Two one-sided tests compare each difference with a margin of {}.",
            format_value(result.study.comparison.margin, "J/m2")),
        {{"elastomer", ""},
         {"stage", ""},
         {"*W* approach", "J/m2"},
         {"*W* at pull-off (Eq. S2)", "J/m2"},
         {"excess energy", "J"},
         {"loss of a smooth sphere", "J"},
         {"rough loss/excess", "1"},
         {"*W*_ret − *W*_app", "J/m2"},
         {"within the margin?", ""},
         {"loss per area beyond a smooth sphere", "J/m2"},
         {"within the margin?", ""}},
        {}};
    for (std::size_t i = 0; i < result.references.size(); ++i) {
        const auto base = fmt::format("/references/{}", i);
        const auto quantity = [&base](const char* name) { return QuantityCell{joined(base, name)}; };
        table.rows.push_back(
            {TextCell{result.references[i].elastomer}, TextCell{result.references[i].stage},
             quantity("work_of_adhesion_approach"), quantity("work_of_adhesion_retraction"), quantity("excess_energy"),
             quantity("ideal_smooth_sphere_loss"), quantity("loss_ratio"), quantity("hysteresis"),
             verdict(result.references[i].hysteresis), quantity("loss_per_area"),
             result.references[i].loss_per_area ? verdict(*result.references[i].loss_per_area) : TextCell{""}});
    }
    return table;
}

DataTable reference_changes(const StudyResult& result) {
    DataTable table{
        "reference-changes",
        "Smooth references after the rough loops minus before",
        "",
        {{"elastomer", ""}, {"Δ*W* approach", "J/m2"}, {"Δ*W* at pull-off", "J/m2"}, {"Δ excess energy", "J"}},
        {}};
    for (std::size_t i = 0; i < result.reference_drifts.size(); ++i) {
        const auto base = fmt::format("/reference_changes/{}", i);
        const auto quantity = [&base](const char* name) { return QuantityCell{joined(base, name)}; };
        table.rows.push_back({TextCell{result.reference_drifts[i].elastomer},
                              quantity("work_of_adhesion_approach_change"),
                              quantity("work_of_adhesion_retraction_change"), quantity("excess_energy_change")});
    }
    return table;
}

DataTable balances(const StudyResult& result, const Json&) {
    DataTable table{
        "balances",
        "Comparison of balances",
        "Every balance is fitted to all pairs with its own <i>W</i><sub>int</sub>: with the spectra of the study, with every spectrum cut, and with <i>γ</i><sub>1</sub> scaled. "
        "ln <i>L</i> is given relative to the best; a difference of 2 is within chance. Left out: rms residual of leave-one-surface-out predictions.",
        {{"balance", ""},
         {"spectra", ""},
         {"cut at", "m"},
         {"γ1 ×", "1"},
         {"fitted", "1"},
         {"*W*_int", "J/m2"},
         {"*R*²", "1"},
         {"ln *L*", "1"},
         {"left out", "J/m2"}},
        {}};
    const auto add = [&](const std::string& base, const std::vector<study::ComparedBalance>& compared,
                         const char* spectra) {
        for (std::size_t i = 0; i < compared.size(); ++i) {
            const auto place = joined(base, std::to_string(i));
            const auto quantity = [&place](const char* name) { return QuantityCell{joined(place, name)}; };
            const auto& b = compared[i];
            table.rows.push_back({TextCell{b.balance == "free_energies"        ? "Eq. 7, U_el free"
                                           : b.balance == "strained_interface" ? "Eq. 7, χ fitted"
                                           : b.balance == "reference_scaled"   ? "Eq. 7, W_int from references"
                                           : b.balance == "pinned_1"           ? "Eq. 7 with 2 U_el"
                                           : b.balance == "pinned_2"           ? "Eq. 7 with 3 U_el"
                                                                               : balance_name(b.balance)},
                                  TextCell{spectra},
                                  b.shortest_wavelength > 0.0 ? Cell(quantity("shortest_wavelength")) : TextCell{"–"},
                                  quantity("surface_energy_factor"), NumberCell{joined(place, "parameters")},
                                  quantity("work_of_adhesion"), quantity("r_squared"),
                                  quantity("log_likelihood_difference"), quantity("left_out_deviation")});
        }
    };
    add("/balances", result.balances, result.by_average ? "likelihood" : "as given");
    if (result.by_average) add("/by_average/balances", result.by_average->balances, "average");
    return table;
}

DataTable cutoff_scan(const StudyResult& result, const Json& study) {
    DataTable table{"cutoff-scan",
                    "Intrinsic work of adhesion against the short cutoff",
                    "Every spectrum is cut at the shortest wavelength of the row.",
                    {{"shortest wavelength", "m"},
                     {"spectra", ""},
                     {"*W*_int (Eq. 7)", "J/m2"},
                     {"*R*² (Eq. 7)", "1"},
                     {"*W*_int (Eq. S13)", "J/m2"},
                     {"*R*² (Eq. S13)", "1"},
                     {"*W*_int (Eq. 7), all errors", "J/m2"},
                     {"ln *L* (Eq. 7)", "1"}},
                    {}};
    const auto add = [&](const std::string& base, const char* spectra) {
        for (std::size_t i = 0; i < entry(study, base).size(); ++i) {
            const auto place = joined(base, std::to_string(i));
            const auto quantity = [&place](const char* name) { return QuantityCell{joined(place, name)}; };
            table.rows.push_back({quantity("shortest_wavelength"), TextCell{spectra},
                                  quantity("modified/work_of_adhesion"), quantity("modified/r_squared"),
                                  quantity("persson_tosatti/work_of_adhesion"), quantity("persson_tosatti/r_squared"),
                                  quantity("modified/generalised"),
                                  NumberCell{joined(place, "modified/log_likelihood")}});
        }
    };
    add("/cutoff_scan", result.by_average ? "likelihood" : "as given");
    if (result.by_average) add("/by_average/cutoff_scan", "average");
    return table;
}

}  // namespace

std::string balance_name(const std::string& fit) {
    if (fit == "modified") return "full-contact balance (Eq. 7)";
    if (fit == "persson_tosatti") return "Persson–Tosatti balance (Eq. S13)";
    if (fit == "without_area_change") return "small-slope balance (Eq. 2)";
    if (fit == "partial_contact") return "Eq. 7, partial contact";
    return fit == "loop" ? "true-area loss of loops (Eq. 10)" : fit;
}

DataTable measurement_table(const StudyResult& result) {
    DataTable table{
        "measurements",
        "Measurements",
        "Heights are as measured, unfiltered: root mean square and mean height (<i>Sq</i>, <i>Sa</i> of maps, <i>Rq</i>, <i>Ra</i> of lines). Slope and curvature are finite differences "
        "at the resolution of the data. The spectrum is reliable within the band; <i>n</i> counts points.",
        {{"surface", ""},
         {"file", ""},
         {"measurement", ""},
         {"instrument", ""},
         {"Rq or Sq", "m"},
         {"Ra or Sa", "m"},
         {"Rdq or Sdq", "1"},
         {"curvature", "1/m"},
         {"band *q*", "1/m"},
         {"*n*", "1"},
         {"status", ""}},
        {}};
    for (const auto& surface : result.surfaces)
        for (std::size_t i = 0; i < surface.measurements.size(); ++i) {
            const auto& m = surface.measurements[i];
            const auto base = joined(named("/surfaces", surface.name), fmt::format("measurements/{}", i));
            const auto quantity = [&base](const char* name) { return QuantityCell{joined(base, name)}; };
            table.rows.push_back({TextCell{surface.name}, TextCell{m.file}, TextCell{m.name},
                                  TextCell{m.spectrum.metadata.instrument.type}, quantity("rms_height"),
                                  quantity("arithmetic_height"), quantity("rms_slope"), quantity("rms_curvature"),
                                  BandCell{joined(base, "band")}, NumberCell{joined(base, "rms_height/n")},
                                  TextCell{m.failed() ? "failed" : ""}});
        }
    return table;
}

DataTable loop_table(const StudyResult& result) {
    DataTable table{
        "loops",
        "Loops",
        "Contact modulus and work of adhesion from the JKR fit of loading. Work of adhesion at pull-off from the force (Eq. S1) and from the last points (Eq. S2). <i>n</i> counts the samples of the loading fit.",
        {{"file", ""},
         {"surface", ""},
         {"elastomer", ""},
         {"*E*\\*", "Pa"},
         {"*W* approach", "J/m2"},
         {"*W* at pull-off (Eq. S1)", "J/m2"},
         {"*W* at pull-off (Eq. S2)", "J/m2"},
         {"*E*_loss", "J"},
         {"*a*_max", "m"},
         {"*n*", "1"},
         {"status", ""}},
        {}};
    for (std::size_t i = 0; i < result.experiments.size(); ++i) {
        const auto& e = result.experiments[i];
        const auto base = fmt::format("/experiments/{}/analysis", i);
        const auto quantity = [&base](const char* name) { return QuantityCell{joined(base, name)}; };
        table.rows.push_back(
            {TextCell{e.input.file}, TextCell{e.input.reference ? "reference" : e.input.surface},
             TextCell{e.input.elastomer}, quantity("loading/contact_modulus"), quantity("loading/work_of_adhesion"),
             quantity("pull_off/work_of_adhesion"), quantity("retraction/work_of_adhesion"), quantity("loop/energy"),
             quantity("largest_contact_radius"), NumberCell{joined(base, "loading/work_of_adhesion/n")},
             TextCell{e.failed()           ? "failed"
                      : e.input.excluded() ? "excluded: " + e.input.exclusion
                                           : ""}});
    }
    return table;
}

DataTable loop_check_table(const StudyResult& result) {
    DataTable table{
        "loop-checks",
        "Loops: other fits, contact point and energy",
        "Joint fit of force, displacement and contact radius. <i>E</i>* without assuming <i>W</i>. Point of first contact with the spread of its estimates. "
        "Loss of an ideal smooth sphere in this machine, and recovered share of the work of approach. The file loop_fits.csv contains every fit, loop_energies.csv every part of "
        "the energy.",
        {{"file", ""},
         {"*E*\\* joint", "Pa"},
         {"*W* joint", "J/m2"},
         {"*E*\\* without *W*", "Pa"},
         {"*W* unloading", "J/m2"},
         {"contact point", "m"},
         {"spread of contact point", "m"},
         {"*E*_ideal", "J"},
         {"recovered", "1"}},
        {}};
    for (std::size_t i = 0; i < result.experiments.size(); ++i) {
        const auto& e = result.experiments[i];
        if (e.failed()) continue;
        const auto base = fmt::format("/experiments/{}/analysis", i);
        const auto quantity = [&base](const char* name) { return QuantityCell{joined(base, name)}; };
        table.rows.push_back({TextCell{e.input.file}, quantity("loading/fits/joint/contact_modulus"),
                              quantity("loading/fits/joint/work_of_adhesion"),
                              quantity("loading/fits/pointwise/contact_modulus"),
                              quantity("unloading/work_of_adhesion"), quantity("contact_points/contact_point"),
                              quantity("contact_points/spread"), quantity("ledger/ideal_loss_this_machine"),
                              quantity("ledger/recovered_share")});
    }
    return table;
}

namespace {

/// Names the files with all rows of tables that have too many.
void name_files(std::vector<DataTable>& tables) {
    static const std::map<std::string_view, const char*> files{
        {"surfaces", "surfaces.csv"},      {"decades", "decades.csv"},       {"measurements", "measurements.csv"},
        {"agreement", "agreement.csv"},    {"pairs-measured", "pairs.csv"},  {"pairs-predicted", "pairs.csv"},
        {"budget-inputs", "budget.csv"},   {"left-out", "left_out.csv"},     {"profiles", "profiles.csv"},
        {"loops", "loop_fits.csv"},        {"loop-checks", "loop_fits.csv"}, {"balances", "balances.csv"},
        {"cutoff-scan", "cutoff_scan.csv"}};
    for (auto& table : tables) {
        if (const auto file = files.find(table.identifier); file != files.end()) table.file = file->second;
        if (table.identifier.starts_with("loop")) table.most = max_experiments;
    }
}

}  // namespace

std::vector<DataTable> parameter_tables(const StudyResult& result, const Json& study) {
    std::vector<DataTable> tables{
        fits(result, study),
        pairs_measured(result),
        pairs_predicted(result),
        prediction_test(result, study),
        budget(result),
        inputs_of_numbers(study),
        left_out(study),
        profiles(study),
        replicate_means(result, "J/m2", "replicates-work", "Work of adhesion over lenses, spots and repeats"),
        replicate_means(result, "J", "replicates-loss", "Energy loss over lenses, spots and repeats"),
        replicate_variances(result, "J/m2", "variances-work", "Scatter of the work of adhesion"),
        replicate_variances(result, "J", "variances-loss", "Scatter of the energy loss"),
        surfaces(result, study),
        decades(result, study),
        measurement_table(result),
        agreement(result, study),
        elastomers(result, study),
        loop_table(result),
        loop_check_table(result),
        references(result),
        reference_changes(result),
        balances(result, study),
        cutoff_scan(result, study)};
    std::erase_if(tables, [](const DataTable& table) { return table.rows.empty(); });
    name_files(tables);
    return tables;
}

}  // namespace setae::report
