// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_options.hpp"

#include <utility>

#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

using bytes::TomlReader;

/// A count of samples, at least `least`.
void read_count(TomlReader& reader, const char* key, Index least, Index& count) {
    const auto given = reader.integer(key);
    if (!given) return;
    if (*given < least || *given > 1'000'000)
        reader.fail(key, "expected a number from " + std::to_string(least) + " to 1000000");
    count = static_cast<Index>(*given);
}

void read_switch(TomlReader& reader, const char* key, bool& value) { value = reader.boolean(key).value_or(value); }

/// What a parser makes of a text, its complaint at the key's place.
template <class Parser>
void parse_at(TomlReader& reader, const char* key, const Parser& parser) {
    try {
        parser();
    } catch (const InvalidArgument& error) {
        reader.fail(key, error.what());
    }
}

}  // namespace

loops::AnalysisOptions read_loop_options(TomlReader& reader, loops::AnalysisOptions options) {
    read_count(reader, "samples_dropped", 0, options.samples_dropped);
    read_count(reader, "retraction_points", 2, options.retraction_points);
    read_switch(reader, "effective_variance", options.effective_variance);
    read_switch(reader, "force_drift", options.force_drift);
    read_switch(reader, "extrapolate_force_drift", options.extrapolate_force_drift);
    read_switch(reader, "leave_pinned_out", options.leave_pinned_out);
    read_switch(reader, "retraction_modulus_free", options.retraction_modulus_free);
    options.displacement_drift_rate = reader.quantity("displacement_drift", dimension::length / dimension::time)
                                          .value_or(options.displacement_drift_rate);
    options.interaction_range =
        reader.quantity("interaction_range", dimension::length).value_or(options.interaction_range);
    options.segments.baseline_share = reader.number("baseline_share").value_or(options.segments.baseline_share);
    if (const auto noise = reader.quantity("contact_radius_noise", dimension::length))
        options.contact_radius_noise = noise;
    if (const auto stiffness = reader.uncertain("machine_stiffness", dimension::stiffness)) {
        options.machine_stiffness = stiffness->value;
        options.machine_stiffness_standard_error = stiffness->standard_error > 0.0 ? stiffness->standard_error : 0.0;
    }
    if (const auto point = reader.text("contact_point"))
        parse_at(reader, "contact_point", [&] { options.contact_point = loops::parse_contact_point(*point); });
    return options;
}

LoopModelOptions read_loop_models(TomlReader& reader, LoopModelOptions options) {
    if (auto models = reader.texts("models"); !models.empty()) options.models = std::move(models);
    for (const auto& name : options.models)
        if (name != "all") parse_at(reader, "models", [&] { (void)loops::model_named(name); });
    read_switch(reader, "profile", options.profile);
    read_switch(reader, "crack_speed", options.crack_speed);
    if (const auto exponent = reader.number("exponent")) options.exponent = exponent;
    if (const auto errors = reader.text("fit_errors"))
        parse_at(reader, "fit_errors", [&] { options.errors = fit_errors_named(*errors); });
    for (const auto& what : reader.texts("share")) {
        if (what != "modulus" && what != "work") reader.fail("share", "'" + what + "', expected modulus or work");
        (what == "modulus" ? options.share_contact_modulus : options.share_work_of_adhesion) = true;
    }
    return options;
}

loops::AnalysisOptions read_loop_options_of_record(TomlReader& reader, const loops::AnalysisOptions& defaults) {
    auto options = read_loop_options(reader, defaults);
    for (const auto& edit : reader.texts("segments"))
        parse_at(reader, "segments", [&] { loops::add_segment_edit(options.segments.edits, edit); });
    return options;
}

}  // namespace setae::study
