// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_keys.hpp"

#include <limits>
#include <utility>

namespace setae::study {
namespace {

using bytes::TomlReader;

constexpr std::int64_t max_samples = 1'000'000;

/// A field of how a loop is analysed.
template <class Field>
auto analysis(Field field) {
    return [field](auto& e) -> auto& { return std::invoke(field, e.options); };
}

/// A field of what is fitted to it.
template <class Field>
auto fitted(Field field) {
    return [field](auto& e) -> auto& { return std::invoke(field, e.models); };
}

void read_machine_stiffness(TomlReader& reader, ExperimentInput& e) {
    auto stiffness = reader.uncertain("machine_stiffness", positive(dimension::stiffness));
    if (!stiffness) return;
    remark_implausible(reader, "machine_stiffness", stiffness->value, 1e-6, 1e12, si_unit(dimension::stiffness));
    e.options.machine_stiffness = stiffness->value;
    e.machine_stiffness = std::move(*stiffness);
}

void read_models(TomlReader& reader, ExperimentInput& e) {
    auto models = reader.texts("models");
    for (const auto& name : models)
        if (name != "all") parse_at(reader, "models", [&] { (void)loops::model_named(name); });
    if (reader.is_list("models")) e.models.models = std::move(models);
}

void read_columns(TomlReader& reader, ExperimentInput& e) {
    static const std::vector<std::string> roles{"force", "displacement", "contact_radius", "time"};
    reader.table("columns", [&](TomlReader inner) {
        e.columns.clear();
        for (const auto& role : roles)
            if (const auto column = inner.text(role.c_str())) e.columns[role] = *column;
        inner.finish();
    });
}

void read_exponent(TomlReader& reader, ExperimentInput& e) {
    if (const auto exponent = reader.number("exponent", domain::positive)) e.models.exponent = exponent;
}

void read_share(TomlReader& reader, ExperimentInput& e) {
    const auto shared = reader.texts("share");
    if (reader.is_list("share")) e.models.share_contact_modulus = e.models.share_work_of_adhesion = false;
    for (const auto& what : shared) {
        if (what != "modulus" && what != "work") reader.fail("share", "'" + what + "', expected modulus or work");
        (what == "modulus" ? e.models.share_contact_modulus : e.models.share_work_of_adhesion) = true;
    }
}

void read_force_drift(TomlReader& reader, ExperimentInput& e) {
    if (reader.boolean("force_drift") == false) e.options.segments.drift = loops::DriftModel::constant;
}

Keys<ExperimentInput> keys_of_loops() {
    using Analysis = loops::AnalysisOptions;
    using Models = LoopModelOptions;
    Keys<ExperimentInput> keys;
    keys.add(
            {"columns", "table of texts", "", "",
             "`{ force = \"Load\", displacement = \"3\" }`: columns of the file, in place of what names and units say, with a "
             "unit that the header lacks as in `\"Kraft[uN]\"`, or expressions over them such as `\"-1 * load\"`; "
             "also `contact_radius`, `time`"},
            read_columns)
        .whole("samples_dropped", analysis(&Analysis::samples_dropped), 0, max_samples,
               "samples left out after the jump-in")
        .whole("retraction_points", analysis(&Analysis::retraction_points), 2, max_samples,
               "samples before pull-off that (S2) rests on")
        .add("effective_variance", analysis(&Analysis::effective_variance),
             "fits allow for the errors of force too, where they are known")
        .parsed(
            "drift", "`auto`, `none`, `linear`, `quadratic`, `cubic`, `extrapolate`",
            [](ExperimentInput& e, const std::string& text) {
                e.options.segments.drift = loops::drift_model_named(text);
            },
            "curve that the zero of force follows in time ([loops](../concepts/loops.md#drift))")
        .by_default("`auto`")
        .add({"force_drift", "true or false", "", "true", "false: the same as `drift = \"none\"`"}, read_force_drift)
        .add(
            "force_zero", [](auto& e) -> auto& { return e.options.segments.force_baseline; }, dimension::force,
            "zero of force where no free flight shows it; no drift is then removed")
        .add("leave_pinned_out", analysis(&Analysis::leave_pinned_out),
             "unloading fits begin where the contact edge lets go")
        .add("retraction_modulus_free", analysis(&Analysis::retraction_modulus_free),
             "E* of (S2) is fitted, not taken from loading")
        .add("displacement_drift", analysis(&Analysis::displacement_drift_rate), dimension::length / dimension::time,
             "rate of the displacement's drift, where a reference tells it")
        .add("interaction_range", analysis(&Analysis::interaction_range), positive(dimension::length),
             "z0 of the Tabor parameter")
        .plausible(1e-11, 1e-5)
        .by_default("3e-10")
        .add(
            "baseline_share", [](auto& e) -> auto& { return e.options.segments.baseline_share; },
            {dimension::none, domain::share},
            "share of the record, from its start, that is free flight; where it is missing, free flight is found")
        .add("contact_radius_noise", analysis(&Analysis::contact_radius_noise), positive(dimension::length),
             "of a radius; where it is missing, from the radii's second differences")
        .plausible(1e-12, 1e-2)
        .add({"machine_stiffness", "quantity ± error", si_unit(dimension::stiffness), "",
              "of a stage whose position stands for the displacement"},
             read_machine_stiffness)
        .add("force_calibration", &ExperimentInput::force_calibration, positive(dimension::none),
             "true force over what the file says")
        .plausible(0.01, 100.0)
        .by_default("1")
        .add("displacement_calibration", &ExperimentInput::displacement_calibration, positive(dimension::none),
             "likewise of the displacement; a contact point or drift given here is multiplied, too")
        .plausible(0.01, 100.0)
        .by_default("1")
        .add("contact_radius_calibration", &ExperimentInput::contact_radius_calibration, positive(dimension::none),
             "likewise of the contact radius: the size of the camera's pixel, say; its noise is multiplied, too")
        .plausible(1e-10, 1e3)
        .by_default("1")
        .parsed(
            "contact_point", "`auto`, `fit`, a method's name or a length",
            [](ExperimentInput& e, const std::string& text) {
                e.options.contact_point = loops::parse_contact_point(text);
            },
            "where fits of force against displacement begin ([loops](../concepts/loops.md))")
        .by_default("`auto`")
        .add(
            {"models", "list of texts", "", "",
             "models fitted beside JKR's own routes ([contact models](../concepts/contact-models.md)), or `[\"all\"]`; in study.json under "
             "`models`"},
            read_models)
        .add("profile", fitted(&Models::profile), "E* and W by profile likelihood")
        .add("crack_speed", fitted(&Models::crack_speed), "G(v) of the receding edge")
        .add({"exponent", "number", "", "", "n of G(v), held; where it is missing it is fitted"}, read_exponent)
        .parsed(
            "fit_errors", "`orthogonal_distance`, `effective_variance`, `force_only`",
            [](ExperimentInput& e, const std::string& text) { e.models.errors = fit_errors_named(text); },
            "errors of these fits")
        .by_default("`" + to_string(Models{}.errors) + "`")
        .add(
            {"share", "list of texts", "", "",
             "`modulus`, `work` or both: one fit of all loops on each elastomer that ask for it, alike in share, models and "
             "fit_errors; in study.json under `shared_fit`"},
            read_share);
    return keys;
}

}  // namespace

const Keys<ExperimentInput>& loop_keys() {
    static const auto keys = keys_of_loops();
    return keys;
}

}  // namespace setae::study
