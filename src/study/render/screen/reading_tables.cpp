// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading_tables.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>

#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/output/json.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/study/contact_answers.hpp"
#include "tables/table_support.hpp"
#include "verdict/answer.hpp"

namespace setae::output::reading {
namespace {

using study::StudyResult;

constexpr double mJ_per_m2 = 1e-3, nm = 1e-9, MPa = 1e6, nJ = 1e-9;

std::string optional_number(const std::optional<Estimate>& estimate, double unit) {
    return estimate ? uncertain_number(*estimate, unit) : "–";
}

std::string exact(double value, double unit = 1.0) { return uncertain_number({.value = value}, unit); }

/// A row whose cells after the second are empty.
std::vector<tables::TidyTable::Cell> row_of_reason(const tables::TidyTable& table, const std::string& name,
                                                   const std::string& reason) {
    std::vector<tables::TidyTable::Cell> row(table.columns.size(), std::string());
    row[0] = name;
    row[1] = reason;
    return row;
}

/// Deviation of the measured value of a pair from its prediction, in standard errors.
std::string deviation_of(const StudyResult& result, const study::PairResult& pair) {
    if (!result.prediction_test) return "–";
    for (const auto& tested : result.prediction_test->pairs)
        if (tested.surface == pair.surface && tested.elastomer == pair.elastomer)
            return fmt::format("{:.1f} σ", std::round(10.0 * tested.standardised()) / 10.0 + 0.0);  // −0.04 is 0.0
    return "–";
}

/// Formation of full contact, below the heading "full contact".
std::string full_contact_of(const study::PairResult& pair) {
    if (!pair.scales) return "";
    switch (pair.closing()) {
        case adhesion::Closing::spontaneous: return "spontaneous";
        case adhesion::Closing::under_pressure: return "under pressure";
        case adhesion::Closing::opens: return "opens";
    }
    return "";
}

/// A prediction that cannot be negative, with its error.
std::string work_by(const std::optional<adhesion::PredictedWork>& predicted) {
    if (!predicted) return "–";
    return uncertain_number(predicted->estimate, mJ_per_m2);
}

/// The recommended prediction for a pair, equal in all commands.
std::string answer_of(const study::PairResult& pair) {
    if (!pair.partial_contact) return "–";
    return uncertain_number(study::recommended_answer(pair).work_of_adhesion, mJ_per_m2);
}

/// A fit's row by a balance's name.
void add_fit(tables::TidyTable& table, const std::string& balance, const adhesion::WorkFit& fit,
             const char* unit = "J/m2") {
    const auto& tested = fit.errors_in_both;
    table.rows.push_back({balance, number_with_interval(work_of(fit), mJ_per_m2),
                          fmt::format("{:.3f}", fit.generalised.r_squared),
                          !tested                       ? "–"
                          : tested->extra_scatter > 0.0 ? format_value(tested->extra_scatter, unit, 2)
                                                        : "none",
                          fmt::format("{}", fit.n)});
}

}  // namespace

tables::TidyTable surfaces(const StudyResult& result, Spectra spectra) {
    const bool all = spectra == Spectra::all;
    tables::TidyTable table{"Surfaces",
                            {"surface", "h_rms [nm]", "h'_rms", "A_true/A_app", "U_el/(A E*) [nm]",
                             all ? "h''_rms [1/nm]" : "", "spectrum"},
                            {}};
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) {
            table.rows.push_back(row_of_reason(table, surface.name, "failed: " + surface.error));
            continue;
        }
        if (!surface.likelihood_error.empty()) {
            auto row = row_of_reason(table, surface.name, "–");
            std::fill(row.begin() + 1, row.end(), std::string("–"));
            row.back() = std::string("likelihood");
            table.rows.push_back(std::move(row));
        }
        for (const auto& [method, spectrum] : study::spectra_of(surface)) {
            if (!all && spectrum != &surface.used()) continue;
            const auto q = surface_quantities(surface, *spectrum, result.study.analysis.conversion);
            const auto cell = [&](std::size_t i, double unit) {
                return all ? full_number(q[i].estimate, unit) : uncertain_number(q[i].estimate, unit);
            };
            const auto by = interval_of(q[0].estimate) ? ", ± by " + q[0].estimate.method : std::string();
            table.rows.push_back({surface.name, cell(0, nm), cell(1, 1.0), cell(3, 1.0), cell(5, nm),
                                  all ? cell(2, 1.0 / nm) : "",
                                  method + (method == q[0].estimate.method || !all ? "" : by)});
        }
    }
    return table;
}

tables::TidyTable agreement(const StudyResult& result) {
    tables::TidyTable table{
        "Measured periodograms against those expected from the fitted spectra",
        {"surface", "instrument", "q [1/m]", "χ²", "groups of modes", "smallest p", "at q [1/m]", "measured/expected"},
        {}};
    const auto decades = [](int first, int last) { return fmt::format("1e{} … 1e{}", first, last + 1); };
    for (const auto& surface : result.surfaces) {
        if (surface.failed() || !surface.fitted) continue;
        const auto& rows = surface.fitted->agreement;  // by instrument, then by decade
        for (auto first = rows.begin(); first != rows.end();) {
            const auto end =
                std::find_if(first, rows.end(), [&](const auto& row) { return row.instrument != first->instrument; });
            const auto& worst = *std::min_element(
                first, end, [](const auto& a, const auto& b) { return a.probability < b.probability; });
            double chi_squared = 0.0;
            int groups = 0;
            for (auto row = first; row != end; ++row) {
                chi_squared += row->chi_squared;
                groups += row->groups;
            }
            table.rows.push_back({surface.name, first->instrument.empty() ? "not stated" : first->instrument,
                                  decades(first->decade, std::prev(end)->decade), fmt::format("{:.0f}", chi_squared),
                                  fmt::format("{}", groups), probability_text(worst.probability),
                                  decades(worst.decade, worst.decade), fmt::format("{:.2f}", worst.ratio)});
            first = end;
        }
    }
    return table;
}

tables::TidyTable elastomers(const StudyResult& result) {
    tables::TidyTable table{
        "Elastomers", {"elastomer", "E [MPa]", "E* [MPa]", "γ1 [mJ/m²]", "ρRT/M_c [MPa]", "E/(ρRT/M_c)"}, {}};
    for (const auto& e : result.elastomers) {
        const double network = e.network_modulus.value_or(undefined);
        table.rows.push_back({e.input.name, uncertain_number(e.youngs_modulus, MPa),
                              uncertain_number(e.contact_modulus, MPa),
                              uncertain_number(e.input.surface_energy, mJ_per_m2), exact(network, MPa),
                              exact(e.youngs_modulus.value / network)});
    }
    return table;
}

tables::TidyTable loops(const StudyResult& result) {
    tables::TidyTable table{
        "Loops",
        {"file", "surface", "elastomer", "E* [MPa]", "W loading [mJ/m²]", "W_ret at pull-off (Eq. S1) [mJ/m²]",
         "W_ret at pull-off (Eq. S2) [mJ/m²]", "E_loss [nJ]", ""},
        {}};
    for (const auto& e : result.experiments) {
        const auto file = std::filesystem::path(e.input.file).filename().string();
        if (e.failed()) {
            table.rows.push_back({file, e.input.surface, e.input.elastomer, "", "", "", "", "", "failed"});
            continue;
        }
        const auto& a = *e.analysis;
        std::string note = e.input.excluded() ? "excluded: " + e.input.exclusion : "";
        if (!e.alerts.empty())
            note += fmt::format("{}{}", note.empty() ? "" : ", ", counted(e.alerts.size(), "warning", "warnings"));
        table.rows.push_back({file, e.input.reference ? "(reference)" : e.input.surface, e.input.elastomer,
                              uncertain_number(a.loading.primary().contact_modulus, MPa),
                              uncertain_number(a.loading.primary().work_of_adhesion, mJ_per_m2),
                              a.pull_off ? uncertain_number(a.pull_off->work_of_adhesion, mJ_per_m2) : "–",
                              a.retraction ? uncertain_number(a.retraction->work_of_adhesion, mJ_per_m2) : "–",
                              a.loop ? uncertain_number(a.loop->estimate(), nJ) : "–", note});
    }
    return table;
}

tables::TidyTable references(const StudyResult& result) {
    tables::TidyTable table{"Smooth references",
                            {"elastomer", "stage", "W loading [mJ/m²]", "W_ret at pull-off [mJ/m²]",
                             "excess energy [nJ]", "ideal sphere [nJ]"},
                            {}};
    for (const auto& r : result.references)
        table.rows.push_back({r.elastomer, r.stage, uncertain_number(r.approach, mJ_per_m2),
                              uncertain_number(r.retraction, mJ_per_m2), optional_number(r.excess_energy, nJ),
                              exact(r.ideal_loss.value_or(undefined), nJ)});
    return table;
}

tables::TidyTable work_along(const StudyResult& result) {
    tables::TidyTable table{"W_ret along the retraction of recorded loops",
                            {"surface", "elastomer", "at the largest contact [mJ/m²]", "at pull-off [mJ/m²]",
                             "slope [mJ/m² per µm]", "E_loss from W_ret [nJ]", "recorded [nJ]"},
                            {}};
    constexpr double per_um = 1e3;  // mJ/m² per µm in J/m³
    for (const auto& pair : result.pairs)
        if (const auto& along = pair.work_along_retraction)
            table.rows.push_back({pair.surface, pair.elastomer, uncertain_number(along->at_largest_contact, mJ_per_m2),
                                  uncertain_number(along->at_pull_off, mJ_per_m2),
                                  uncertain_number(along->slope, per_um), uncertain_number(along->energy_loss, nJ),
                                  uncertain_number(along->energy_recorded, nJ)});
    return table;
}

tables::TidyTable pairs(const StudyResult& result) {
    tables::TidyTable table{"Work of adhesion on approach [mJ/m²]",
                            {"surface", "elastomer", "measured", "predicted", "Eq. 7", "deviation", "full contact"},
                            {}};
    for (const auto& p : result.pairs)
        if (p.modified || p.approach)
            table.rows.push_back({p.surface, p.elastomer, optional_number(p.approach, mJ_per_m2), answer_of(p),
                                  work_by(p.modified), deviation_of(result, p), full_contact_of(p)});
    return table;
}

tables::TidyTable all_pairs(const StudyResult& result) {
    tables::TidyTable table{"Work of adhesion on approach [mJ/m²]",
                            {"surface", "elastomer", "method", "E* [MPa]", "measured", "Eq. 7", "Eq. 7, raw", "Eq. S13",
                             "residual", "full contact"},
                            {}};
    for (const auto* conclusions : by_method(result))
        for (const auto& p : conclusions->pairs) {
            const auto& surface = result.surface(p.surface);
            if ((!p.modified && !p.approach) || (conclusions->of_averages && !surface.likelihood)) continue;
            table.rows.push_back({p.surface, p.elastomer, method_name(surface, conclusions->method_of(surface)),
                                  exact(result.elastomer(p.elastomer).contact_modulus.value, MPa),
                                  optional_number(p.approach, mJ_per_m2), work_by(p.modified),
                                  p.modified ? exact(p.modified->work.raw, mJ_per_m2) : "–", work_by(p.persson_tosatti),
                                  p.modified && p.approach
                                      ? uncertain_number(difference(*p.approach, p.modified->estimate), mJ_per_m2)
                                      : "–",
                                  full_contact_of(p)});
        }
    return table;
}

tables::TidyTable fits(const StudyResult& result) {
    tables::TidyTable table{"W_int from all pairs [mJ/m²]", {"from", "W_int", "R²", "additional scatter", "pairs"}, {}};
    if (result.modified) add_fit(table, "approach, Eq. 7", *result.modified);
    if (result.loop) add_fit(table, "loss, Eq. 10", result.loop->through_origin, "J");
    if (result.persson_tosatti) add_fit(table, "approach, Eq. S13", *result.persson_tosatti);
    if (result.without_area_change) add_fit(table, "approach, Eq. 2", *result.without_area_change);
    return table;
}

tables::TidyTable all_fits(const StudyResult& result) {
    tables::TidyTable table{
        "Intrinsic work of adhesion from all pairs",
        {"fit", "variant", "method", "W_int [mJ/m²]", "R²", "χ²", "n", "reported W_int", "reported R²"},
        {}};
    const auto rows = fit_table(result);
    const auto column = [&rows](const char* name) {
        return static_cast<std::size_t>(std::find(rows.columns.begin(), rows.columns.end(), name) -
                                        rows.columns.begin());
    };
    for (const auto& row : rows.rows) {
        const auto at = [&](const char* name) { return std::get<double>(row[column(name)]); };
        Estimate work{at("W_int [J/m2]"), at("W_int standard_error [J/m2]")};
        if (const double lower = at("W_int interval_low [J/m2]"); !std::isnan(lower))
            work.interval = Interval{lower, at("W_int interval_high [J/m2]"), at("W_int level")};
        table.rows.push_back(
            {row[0], row[1], row[2], full_number(work, mJ_per_m2), exact(at("R2")), exact(at("chi2")),
             fmt::format("{:.0f}", at("n")),
             uncertain_number({at("reported W_int [J/m2]"), at("reported W_int standard_error [J/m2]")}, mJ_per_m2),
             exact(at("reported R2"))});
    }
    return table;
}

tables::TidyTable cutoffs(const StudyResult& result) {
    tables::TidyTable table{
        "W_int against the short cutoff",
        {"shortest wavelength", "method", "Eq. 7 [mJ/m²]", "R² Eq. 7", "Eq. S13 [mJ/m²]", "R² Eq. S13"},
        {}};
    for (const auto* conclusions : by_method(result))
        for (const auto& p : conclusions->cutoff_scan)
            table.rows.push_back({format_value(p.shortest_wavelength, "m"), method_name(result, *conclusions),
                                  uncertain_number(p.modified.work_of_adhesion, mJ_per_m2),
                                  fmt::format("{:.3f}", p.modified.r_squared),
                                  uncertain_number(p.persson_tosatti.work_of_adhesion, mJ_per_m2),
                                  fmt::format("{:.3f}", p.persson_tosatti.r_squared)});
    return table;
}

}  // namespace setae::output::reading
