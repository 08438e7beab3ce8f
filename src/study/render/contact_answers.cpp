// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/contact_answers.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "json/pair_fields.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"

namespace setae::output {
namespace {

constexpr double millijoule = 1e-3, hundredth = 1e-2;

/// "1.67 times JKR" of a force, or "JKR".
std::string against_jkr(double force, double jkr) {
    constexpr double rounding = 1e-3;
    const double ratio = force / jkr;
    return std::abs(ratio - 1.0) < rounding ? "JKR" : fmt::format("{:.2f} × JKR (no smooth limit)", ratio);
}

}  // namespace

Quantity recommended_quantity(const study::ContactAnswer& answer) {
    auto work = quantity("work_of_adhesion", "W_app", answer.work_of_adhesion, "J/m2");
    work.source = fmt::format("contact without load, {}", study::text_of(answer.theory).title);
    return work;
}

Json to_json(const study::ContactAnswers& answers) { return described(answers); }

tables::TidyTable theory_table(const study::ContactAnswers& answers) {
    tables::TidyTable table{"Contact without load, by theory", {"theory", "W_app [mJ/m²]", "area [%]", "assumes"}, {}};
    for (const auto& answer : answers.answers) {
        const auto text = study::text_of(answer.theory);
        table.rows.push_back({std::string(text.title) + (answer.recommended ? " (recommended)" : ""),
                              uncertain_number(answer.work_of_adhesion, millijoule),
                              uncertain_number(answer.area_fraction, hundredth), std::string(text.assumes)});
    }
    return table;
}

tables::TidyTable retraction_table(const adhesion::PredictedLoop& loop) {
    tables::TidyTable table{
        "Retraction, by model",
        {"model", "W_ret at pull-off [mJ/m²]", "pull-off force", "energy loss", "pull-off of a smooth sphere"},
        {}};
    const double jkr = loop.reversible.smooth_pull_off_force;
    const auto add = [&](const char* name, const adhesion::RetractionPrediction& model) {
        table.rows.push_back({std::string(name), uncertain_number(model.work_retraction, millijoule),
                              format_uncertain(model.pull_off_force, "N"),
                              format_uncertain(model.energy_loss.estimate(), "J"),
                              against_jkr(model.smooth_pull_off_force, jkr)});
    };
    add("reversible (recommended)", loop.reversible);
    add("true-area loss (Eq. 10)", loop.conformal_loss);
    return table;
}

}  // namespace setae::output
