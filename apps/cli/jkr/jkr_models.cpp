// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/jkr_models.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "program/messages.hpp"
#include "program/terminal.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli {
namespace {

std::string cell(const loops::Outcome<Estimate>& estimate, double unit) {
    return estimate ? uncertain_number(*estimate, unit) : "–";
}

void add_row(tables::TidyTable& table, const loops::ModelFit& fit, double akaike_difference) {
    table.rows.push_back({to_string(fit.model), cell(fit.contact_modulus, 1e6), cell(fit.work_of_adhesion, 1e-3),
                          cell(fit.transition_parameter, 1.0), fmt::format("{:.3g}", fit.chi2_reduced),
                          fmt::format("{}", fit.n), akaike_difference});
}

}  // namespace

void print_models(const std::string& loop, const study::LoopModels& models) {
    std::string text = loop.empty() ? "" : loop + "\n", reasons;
    tables::TidyTable table{"", {"model", "E* [MPa]", "W [mJ/m²]", "λ", "χ²_red", "n", "ΔAICc"}, {}};
    for (const auto& fit : models.fits) add_row(table, fit, undefined);
    if (models.comparison) {
        for (const auto& model : models.comparison->models)
            if (model.fit) add_row(table, *model.fit, model.akaike_difference);
            else reasons += fmt::format("  {}: {}\n", to_string(model.model), model.fit.reason);
    }
    if (!table.rows.empty()) text += tables::as_text_within(table, output_size().width);
    text += reasons;
    for (const auto& fit : models.fits) {
        for (const auto& sentence : fit.undetermined) text += "  " + sentence + '\n';
        if (fit.verdict) text += "  " + fit.verdict->sentence + '\n';
    }
    if (models.comparison) text += "  " + models.comparison->sentence + '\n';
    const auto interval = [](const Estimate& e, double factor, const char* unit) {
        return e.interval
                   ? fmt::format("{:.4g} … {:.4g} {}", factor * e.interval->lower, factor * e.interval->upper, unit)
                   : std::string("open");
    };
    if (models.profile)
        text +=
            fmt::format("  profile likelihood, 95 %     E* {}, W {} ({})\n",
                        interval(models.profile->contact_modulus.estimate, 1e-6, "MPa"),
                        interval(models.profile->work_of_adhesion.estimate, 1e3, "mJ/m²"), models.profile->fit.method);
    if (models.crack_speed)
        text += fmt::format(
            "  G(v) = G0 (1 + (v/v0)^n)     G0 {} mJ/m², v0 {} µm/s, n {}, E* {} MPa; {} frames, speeds over a factor "
            "{:.3g}\n",
            cell(models.crack_speed->threshold, 1e-3), cell(models.crack_speed->reference_speed, 1e-6),
            cell(models.crack_speed->exponent, 1.0), cell(models.crack_speed->contact_modulus, 1e6),
            models.crack_speed->n, models.crack_speed->speed_ratio);
    for (const auto& failure : models.failures) text += "  " + failure + '\n';
    print(text);
}

void print_shared(const loops::GlobalFit& fit) {
    tables::TidyTable table{
        fmt::format("{} loops in one fit, {}", fit.branches.size(), to_string(fit.options.fit.model)),
        {"loop", "E* [MPa]", "W [mJ/m²]", "E* own fit [MPa]", "W own fit [mJ/m²]", "n"},
        {}};
    for (const auto& branch : fit.branches)
        table.rows.push_back({branch.name, cell(branch.contact_modulus, 1e6), cell(branch.work_of_adhesion, 1e-3),
                              cell(branch.separate.contact_modulus, 1e6), cell(branch.separate.work_of_adhesion, 1e-3),
                              fmt::format("{}", branch.n)});
    print(tables::as_text_within(table, output_size().width) +
          fmt::format("  test of the shared fit: F = {:.3g}, p = {:.2g} (small p: the loops differ)\n",
                      fit.sharing.f_ratio, fit.sharing.p_value));
}

}  // namespace setae::cli
