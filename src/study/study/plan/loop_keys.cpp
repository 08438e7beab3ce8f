// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_keys.hpp"

#include <limits>
#include <utility>

namespace setae::study {
namespace {

using bytes::TomlReader;

constexpr std::int64_t max_samples = 1'000'000;

/// A field of the options of a loop's analysis.
template <class Field>
auto analysis(Field field) {
    return [field](auto& e) -> auto& { return std::invoke(field, e.options); };
}

/// A field of the models that are fitted.
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
    keys.add({"columns", "table of texts", "", "",
              "`{ force = \"Load\", displacement = \"3\" }`: columns of the file, in place of those found "
              "by names and units, with a unit that the header lacks as in `\"Kraft[uN]\"`, or expressions "
              "over columns such as `\"-1 * load\"`; also `contact_radius`, `time`"},
             read_columns)
        .whole("samples_dropped", analysis(&Analysis::samples_dropped), 0, max_samples,
               "number of samples left out after the jump-in")
        .whole("retraction_points", analysis(&Analysis::retraction_points), 2, max_samples,
               "number of samples before pull-off that are used for Eq. S2")
        .add("effective_variance", analysis(&Analysis::effective_variance),
             "whether fits take the errors of force into account, too, where they are known")
        .parsed(
            "drift", "`auto`, `none`, `linear`, `quadratic`, `cubic`, `extrapolate`",
            [](ExperimentInput& e, const std::string& text) {
                e.options.segments.drift = loops::drift_model_named(text);
            },
            "curve of the zero of force against time ([loops](../concepts/loops.md#drift))")
        .by_default("`auto`")
        .add({"force_drift", "true or false", "", "true",
              "whether a drift of force is removed; `false` is equivalent to `drift = \"none\"`"},
             read_force_drift)
        .add(
            "force_zero", [](auto& e) -> auto& { return e.options.segments.force_baseline; }, dimension::force,
            "zero of force, for records without free flight; no drift is removed then")
        .add("leave_pinned_out", analysis(&Analysis::leave_pinned_out),
             "whether unloading fits begin where the contact edge starts to move")
        .add("retraction_modulus_free", analysis(&Analysis::retraction_modulus_free),
             "whether E* of Eq. S2 is fitted instead of taken from loading")
        .add("displacement_drift", analysis(&Analysis::displacement_drift_rate), dimension::length / dimension::time,
             "drift rate of the displacement, where a reference measurement gives it")
        .add("interaction_range", analysis(&Analysis::interaction_range), positive(dimension::length),
             "range of interaction z0 of the Tabor parameter")
        .plausible(1e-11, 1e-5)
        .by_default("3e-10")
        .add(
            "baseline_share", [](auto& e) -> auto& { return e.options.segments.baseline_share; },
            {dimension::none, domain::share},
            "share of the record, from its start, that is free flight; without this key, free flight is "
            "determined from the record")
        .add("contact_radius_noise", analysis(&Analysis::contact_radius_noise), positive(dimension::length),
             "standard error of a contact radius; without this key, it is determined from second "
             "differences of the radii")
        .plausible(1e-12, 1e-2)
        .add({"machine_stiffness", "quantity ± error", si_unit(dimension::stiffness), "",
              "stiffness of the testing machine, for records of the stage position instead of the displacement"},
             read_machine_stiffness)
        .add("force_calibration", &ExperimentInput::force_calibration, positive(dimension::none),
             "true force divided by the force of the file")
        .plausible(0.01, 100.0)
        .by_default("1")
        .add("displacement_calibration", &ExperimentInput::displacement_calibration, positive(dimension::none),
             "true displacement divided by the displacement of the file; a contact point or drift given "
             "here is multiplied by it, too")
        .plausible(0.01, 100.0)
        .by_default("1")
        .add("contact_radius_calibration", &ExperimentInput::contact_radius_calibration, positive(dimension::none),
             "true contact radius divided by the contact radius of the file, such as the size of the "
             "camera's pixel; `contact_radius_noise` is multiplied by it, too")
        .plausible(1e-10, 1e3)
        .by_default("1")
        .parsed(
            "contact_point", "`auto`, `fit`, a method's name or a length",
            [](ExperimentInput& e, const std::string& text) {
                e.options.contact_point = loops::parse_contact_point(text);
            },
            "contact point of fits of force against displacement ([loops](../concepts/loops.md))")
        .by_default("`auto`")
        .add({"models", "list of texts", "", "",
              "models that are fitted in addition to JKR ([contact "
              "models](../concepts/contact-models.md)), or `[\"all\"]`; in study.json under `models`"},
             read_models)
        .add("profile", fitted(&Models::profile), "whether E* and W are fitted by profile likelihood")
        .add("crack_speed", fitted(&Models::crack_speed), "whether G(v) of the retracting edge is fitted")
        .add({"exponent", "number", "", "", "exponent n of G(v), kept fixed; without this key, n is fitted"},
             read_exponent)
        .parsed(
            "fit_errors", "`orthogonal_distance`, `effective_variance`, `force_only`",
            [](ExperimentInput& e, const std::string& text) { e.models.errors = fit_errors_named(text); },
            "error model of the fits of `models`")
        .by_default("`" + to_string(Models{}.errors) + "`")
        .add({"share", "list of texts", "", "",
              "shared parameters, `modulus`, `work` or both: one fit of all loops on each elastomer that "
              "have this key; these loops need equal share, models and fit_errors; in study.json under "
              "`shared_fit`"},
             read_share);
    return keys;
}

}  // namespace

const Keys<ExperimentInput>& loop_keys() {
    static const auto keys = keys_of_loops();
    return keys;
}

}  // namespace setae::study
