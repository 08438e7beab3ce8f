// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/loop_tables.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/constants.hpp"
#include "setae/core/uncertain_text.hpp"

namespace setae::output {
namespace {

using loops::BranchAnalysis;
using loops::JkrFit;
using loops::Outcome;

std::string metadata(const Table& table, const char* key) {
    const auto entry = table.metadata.find(key);
    return entry == table.metadata.end() ? std::string() : entry->second;
}

/// Position of a fit in a loop.
struct Part {
    const LoopLabels& labels;
    double contact = 1.0, cycle = 1.0;  ///< from 1
    std::string branch;
};

std::vector<tables::TidyTable::Cell> beginning(const Part& part, const std::string& method) {
    return {part.labels.file, part.labels.surface, part.labels.elastomer,
            part.labels.lens, part.labels.spot,    part.contact,
            part.cycle,       part.branch,         method};
}

/// Columns of the results of a fit: values with standard errors, and measures of the agreement with the record.
auto results_of(const JkrFit& fit) {
    return std::array{fit.contact_modulus.value,
                      fit.contact_modulus.standard_error,
                      fit.youngs_modulus.value,
                      fit.youngs_modulus.standard_error,
                      fit.work_of_adhesion.value,
                      fit.work_of_adhesion.standard_error,
                      fit.contact_point.value,
                      fit.contact_point.standard_error,
                      fit.correlation,
                      fit.chi2_reduced,
                      fit.runs.p_value,
                      fit.relative_residual,
                      fit.correlated_samples};
}

/// The same where there is no fit.
auto no_results() {
    decltype(results_of(std::declval<JkrFit>())) results;
    results.fill(undefined);
    return results;
}

/// Ends a row with texts; missing numbers before them are unknown.
void end_row(tables::TidyTable& table, std::vector<tables::TidyTable::Cell> row,
             std::initializer_list<std::string> texts) {
    row.resize(table.columns.size() - texts.size(), undefined);
    for (const auto& text : texts) row.emplace_back(text);
    table.rows.push_back(std::move(row));
}

void add_fit(tables::TidyTable& table, const Part& part, const BranchAnalysis& branch, const char* method,
             const Outcome<JkrFit>& fit) {
    auto row = beginning(part, method);
    for (const double value : fit ? results_of(*fit) : no_results()) row.emplace_back(value);
    const auto& range = branch.range;
    for (const double value : {static_cast<double>(range.n), static_cast<double>(range.first),
                               static_cast<double>(range.last), range.force_first, range.force_last})
        row.emplace_back(value);
    const bool primary = fit && branch.primary().method == fit->method;
    const std::string note = !fit ? fit.reason : fit->converged ? "" : "not converged";
    end_row(table, std::move(row), {range.name, primary ? "yes" : "no", note});
}

void add_branch(tables::TidyTable& table, const Part& part, const Outcome<BranchAnalysis>& branch) {
    if (!branch) {
        end_row(table, beginning(part, ""), {"", "no", branch.reason});
        return;
    }
    for (const auto& route : loops::fit_routes) add_fit(table, part, *branch, route.name, (*branch).*route.fit);
}

std::vector<tables::TidyTable::Cell> energies_beginning(const LoopLabels& labels, std::size_t contact, double cycle) {
    return {labels.file, labels.surface, labels.elastomer, labels.lens, labels.spot, static_cast<double>(contact),
            cycle};
}

/// The energy budget of one contact: the first, which represents the record, or a further one.
template <class Contact>
void add_contact_energy(tables::TidyTable& table, const LoopLabels& labels, std::size_t number,
                        const Contact& contact) {
    auto row = energies_beginning(labels, number, undefined);
    if (!contact.budget) {
        end_row(table, std::move(row), {contact.budget.reason});
        return;
    }
    const auto& budget = *contact.budget;
    const auto estimate = budget.loop.estimate();
    const auto& errors = budget.loop.standard_error;
    const auto part = [](const std::optional<loops::WorkEntry>& entry) { return entry ? entry->energy : undefined; };
    const auto& loading = contact.loading.primary().work_of_adhesion;
    const Estimate unloading = contact.unloading ? contact.unloading->primary().work_of_adhesion : Estimate{undefined};
    for (const double value : {estimate.value,
                               estimate.standard_error,
                               estimate.interval ? estimate.interval->lower : undefined,
                               estimate.interval ? estimate.interval->upper : undefined,
                               errors.noise,
                               errors.drift,
                               errors.compliance,
                               errors.sampling,
                               errors.discretisation,
                               part(budget.jump_in),
                               budget.approach.energy,
                               budget.retraction.energy,
                               part(budget.jump_out),
                               budget.ideal_fixed_grips,
                               budget.ideal_this_machine,
                               budget.largest_contact_area,
                               budget.largest_true_area(),
                               budget.loss_per_apparent_area,
                               budget.loss_per_true_area,
                               loading.value,
                               loading.standard_error,
                               unloading.value,
                               unloading.standard_error,
                               contact.pull_off ? contact.pull_off->force.value : undefined})
        row.emplace_back(value);
    end_row(table, std::move(row), {""});
}

}  // namespace

LoopLabels labels_stated_in(const Table& loop, const std::string& file) {
    return {file, metadata(loop, "surface"), metadata(loop, "elastomer"), metadata(loop, "lens"),
            metadata(loop, "spot")};
}

tables::TidyTable fits_table() {
    return {"fits",
            {"file",
             "surface",
             "elastomer",
             "lens",
             "spot",
             "contact",
             "cycle",
             "branch",
             "method",
             "E_star [Pa]",
             "E_star standard_error [Pa]",
             "E [Pa]",
             "E standard_error [Pa]",
             "W [J/m2]",
             "W standard_error [J/m2]",
             "contact_point [m]",
             "contact_point standard_error [m]",
             "correlation",
             "chi2_reduced",
             "runs_p_value",
             "relative_residual",
             "correlated_samples",
             "n",
             "first_sample",
             "last_sample",
             "force_first [N]",
             "force_last [N]",
             "range",
             "primary",
             "reason"},
            {}};
}

void add_fits(tables::TidyTable& table, const LoopLabels& labels, const loops::LoopAnalysis& analysis) {
    if (analysis.cycles.size() < 2) {
        add_branch(table, {labels, 1.0, 1.0, "loading"}, {analysis.loading});
        add_branch(table, {labels, 1.0, 1.0, "unloading"}, analysis.unloading);
        return;
    }
    for (std::size_t i = 0; i < analysis.cycles.size(); ++i) {
        const auto& cycle = analysis.cycles[i];
        const auto contact = static_cast<double>(cycle.cycle.contact + 1), number = static_cast<double>(i + 1);
        add_branch(table, {labels, contact, number, "loading"}, cycle.loading);
        add_branch(table, {labels, contact, number, "unloading"}, cycle.unloading);
    }
}

tables::TidyTable energies_table() {
    return {"energies",
            {"file",
             "surface",
             "elastomer",
             "lens",
             "spot",
             "contact",
             "cycle",
             "E_loss [J]",
             "E_loss standard_error [J]",
             "E_loss_low [J]",
             "E_loss_high [J]",
             "se_noise [J]",
             "se_drift [J]",
             "se_compliance [J]",
             "se_sampling [J]",
             "se_discretisation [J]",
             "jump_in [J]",
             "approach [J]",
             "retraction [J]",
             "jump_out [J]",
             "ideal_fixed_grips [J]",
             "ideal_this_machine [J]",
             "contact_area [m2]",
             "true_area [m2]",
             "E_loss_per_contact_area [J/m2]",
             "E_loss_per_true_area [J/m2]",
             "W_loading [J/m2]",
             "W_loading standard_error [J/m2]",
             "W_unloading [J/m2]",
             "W_unloading standard_error [J/m2]",
             "F_pull_off [N]",
             "reason"},
            {}};
}

void add_energies(tables::TidyTable& table, const LoopLabels& labels, const loops::LoopAnalysis& analysis) {
    add_contact_energy(table, labels, 1, analysis);
    for (std::size_t i = 0; i < analysis.further_contacts.size(); ++i) {
        const auto& contact = analysis.further_contacts[i];
        if (contact) add_contact_energy(table, labels, i + 2, *contact);
        else end_row(table, energies_beginning(labels, i + 2, undefined), {contact.reason});
    }
    if (analysis.cycles.size() < 2) return;
    for (std::size_t i = 0; i < analysis.cycles.size(); ++i) {
        const auto& cycle = analysis.cycles[i];
        auto row =
            energies_beginning(labels, static_cast<std::size_t>(cycle.cycle.contact) + 1, static_cast<double>(i + 1));
        if (cycle.energy) {
            row.emplace_back(*cycle.energy);
            row.emplace_back(cycle.energy_standard_error);
        }
        end_row(table, std::move(row), {cycle.energy.reason});
    }
}

tables::TidyTable loop_rows_table() {
    return {"",
            {"loop", "E* [MPa]", "W loading [mJ/m²]", "W unloading [mJ/m²]", "W_ret at pull-off [mJ/m²]", "loss [nJ]",
             "warnings"},
            {}};
}

void add_loop_row(tables::TidyTable& table, const std::string& name, const loops::LoopAnalysis& analysis) {
    constexpr double mega = 1e6, milli = 1e-3, nano = 1e-9;
    const auto cell = [](const Estimate* estimate, double unit) {
        return estimate ? uncertain_number(*estimate, unit) : std::string("–");
    };
    const auto work = [&](const JkrFit& fit) { return cell(fit.converged ? &fit.work_of_adhesion : nullptr, milli); };
    const auto& loading = analysis.loading.primary();
    std::vector<std::string> codes;
    for (const auto& alert : analysis.alerts)
        if (std::find(codes.begin(), codes.end(), alert.code) == codes.end()) codes.push_back(alert.code);
    const auto loss = analysis.loop ? analysis.loop->estimate() : Estimate{undefined};
    table.rows.push_back({name, cell(loading.converged ? &loading.contact_modulus : nullptr, mega), work(loading),
                          analysis.unloading ? work(analysis.unloading->primary()) : "–",
                          cell(analysis.pull_off ? &analysis.pull_off->work_of_adhesion : nullptr, milli),
                          cell(analysis.loop ? &loss : nullptr, nano), fmt::format("{}", fmt::join(codes, ", "))});
}

}  // namespace setae::output
