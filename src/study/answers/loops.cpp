// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/loops.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "setae/bytes/archive_folder.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/loops/machine_stiffness.hpp"
#include "setae/loops/model_fits.hpp"
#include "setae/study/file_content.hpp"
#include "setae/study/force_map.hpp"
#include "setae/study/own_outputs.hpp"
#include "setae/tables/column_guess.hpp"
#include "setae/tables/loop_file.hpp"
#include "setae/tables/mapping_folder.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::answers {
namespace {

std::optional<double> given(const std::string& text, const Dimension& dimension) {
    return text.empty() ? std::nullopt : std::optional(parse_quantity(text, dimension));
}

/// stiffness k of the testing machine: given, measured on a rigid body, or stated in the loop's file.
std::optional<Estimate> stiffness_of(const LoopSettings& arguments, const Table& loop) {
    if (!arguments.machine_stiffness.empty())
        return parse_uncertain_quantity(arguments.machine_stiffness, dimension::stiffness);
    if (!arguments.rigid_contact.empty()) {
        const auto rigid = study::open_loop({.file = arguments.rigid_contact});
        return loops::machine_stiffness_from_rigid_contact(loops::loop_from_table(rigid.table)).stiffness;
    }
    return tables::loop_quantity(loop, "machine_stiffness");
}

/// A length that is given, with its ±.
std::optional<Estimate> length(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(parse_uncertain_quantity(text, positive(dimension::length)));
}

/// Whether a table has any column with the name of a loop's column, except time; for given columns whether it is a
/// table.
bool is_like_loop(const std::string& path, bool columns_are_named) {
    try {
        const auto table = tables::read_raw_table(bytes::file_source(path));
        if (columns_are_named) return true;
        const auto guess = tables::guess_columns(table, path);
        return std::any_of(guess.roles.begin(), guess.roles.end(), [](const tables::RoleGuess& role) {
            return role.role != "time" && !role.candidates.empty();
        });
    } catch (const Error&) {
        return false;
    }
}

/// Whether a file of a folder may be a loop: a loop, or a table with a column of one, whose fault is then reported;
/// every table where the user gives the columns.
bool may_be_loop(const std::string& path, bool columns_are_named) {
    try {
        const auto kind = study::file_content(path).kind;
        if (kind == study::FileKind::loop || kind == study::FileKind::force_curve) return true;
        return columns_are_named && kind == study::FileKind::topography && is_like_loop(path, true);
    } catch (const Error&) {
        return is_like_loop(path, columns_are_named);
    }
}

}  // namespace

std::vector<std::string> LoopFiles::expanded() const {
    const auto is_no_loop = [columns_are_named = !map.empty() || !columns.empty()](const std::string& file) {
        return !may_be_loop(file, columns_are_named);
    };
    std::vector<std::string> all;
    for (const auto& path : files) {
        if (!study::is_folder(path)) {
            all.push_back(path);
            continue;
        }
        if (!std::filesystem::is_directory(path)) {
            auto members = bytes::files_of_archive(path);
            std::erase_if(members, is_no_loop);
            all.insert(all.end(), members.begin(), members.end());
            continue;
        }
        std::vector<std::string> within;
        for (const auto& entry : std::filesystem::directory_iterator(path))
            if (entry.is_regular_file() && !entry.path().filename().string().starts_with(".") &&
                !study::is_own_output(entry.path().string()))
                within.push_back(entry.path().string());
        std::erase_if(within, is_no_loop);
        if (within.empty())
            throw InvalidArgument(
                fmt::format("{}: no loop among the files of this folder; folders in it are not searched", path));
        std::sort(within.begin(), within.end());
        all.insert(all.end(), within.begin(), within.end());
    }
    if (all.empty()) throw InvalidArgument("no file; expected at least one loop");
    return all;
}

tables::ChosenColumns LoopFiles::chosen() const {
    tables::ChosenColumns all;
    for (const auto& text : columns) {
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0 || trimmed(text.substr(equals + 1)).empty())
            throw InvalidArgument(fmt::format("`column = {}`: expected ROLE=COLUMN, such as force=Load", text));
        const std::string role(trimmed(text.substr(0, equals)));
        if (!all.emplace(role, trimmed(text.substr(equals + 1))).second)
            throw InvalidArgument(fmt::format("`column = {}`: {} is chosen twice; choose one column", text, role));
    }
    return all;
}

study::LoopSource LoopFiles::source(const std::string& file) const {
    study::LoopSource source{.file = file};
    source.mapping = mapping();
    source.columns = chosen();
    if (!camera.empty()) {
        source.camera = study::CameraInput{.file = camera,
                                           .clock_offset = given(clock_offset, dimension::time),
                                           .pixel_size = given(pixel, dimension::length),
                                           .frame_rate = frame_rate,
                                           .fringes = fringes};
        if (!camera_map.empty()) source.camera->mapping = tables::mapping_path(camera_map, mapping_folder);
    }
    source.force_curve.spring_constant = given(spring_constant, dimension::stiffness);
    if (!sensitivity.empty()) source.force_curve.sensitivity = tables::parse_sensitivity(sensitivity);
    return source;
}

std::optional<std::string> LoopFiles::mapping() const {
    return map.empty() ? std::nullopt : std::optional(tables::mapping_path(map, mapping_folder));
}

study::OpenedLoop LoopFiles::open(const std::string& file) const {
    const auto wanted = source(file);
    if (!curve_number && !map.empty()) return study::open_loop(wanted);
    if (!curve_number) {
        try {
            return study::open_loop(wanted);
        } catch (const FormatError& error) {
            const auto remark = tables::fitting_mappings_hint(file, mapping_folder);
            if (remark.empty()) throw;
            throw InvalidArgument(error.what() + remark);
        }
    }
    auto opened = study::open_force_curve(file, *curve_number, wanted.force_curve);
    opened.channels = tables::choose_columns(opened.table, file, wanted.columns);
    return opened;
}

study::StatedBodies LoopBodies::bodies(const Table& loop) const {
    auto bodies = without_radius(loop);
    if (!(bodies.values.radius > 0.0))
        throw InvalidArgument("no radius of the sphere, and the file contains none; expected `radius = 7.5 um`");
    return bodies;
}

study::StatedBodies LoopBodies::without_radius(const Table& loop) const {
    using loops::SharedInput;
    auto bodies = study::bodies_stated_in(loop);
    auto& values = bodies.values;
    bodies.take(SharedInput::sphere_radius, values.radius, length(radius));
    if (poisson_ratio) bodies.take(SharedInput::poisson_ratio, values.lens_poisson_ratio, Estimate{*poisson_ratio});
    bodies.take(SharedInput::sphere_height, values.lens_height, length(lens_height));
    bodies.take(SharedInput::sphere_height, values.layer_thickness, length(layer_thickness));
    values.counter_youngs_modulus = given(counter_modulus, dimension::pressure).value_or(values.counter_youngs_modulus);
    values.counter_poisson_ratio = counter_poisson_ratio.value_or(values.counter_poisson_ratio);
    return bodies;
}

namespace {

/// "0.1:20s": share and time.
contact::RelaxationTerm relaxation_term(const std::string& text) {
    const auto colon = text.find(':');
    if (colon == std::string::npos)
        throw InvalidArgument(fmt::format("`relaxation = {}`: expected SHARE:TIME, such as 0.1:20s", text));
    return {parse_quantity(text.substr(0, colon), non_negative(dimension::none)),
            parse_quantity(text.substr(colon + 1), positive(dimension::time))};
}

}  // namespace

loops::DriftModel LoopSettings::drift_model() const {
    const loops::DriftModel model = loops::drift_model_named(drift);
    if (!no_drift) return model;
    if (model != loops::DriftModel::automatic && model != loops::DriftModel::constant)
        throw InvalidArgument(
            fmt::format("`no_drift` and `drift = {}` contradict each other; give one of them", drift));
    return loops::DriftModel::constant;
}

loops::AnalysisOptions LoopSettings::options(const Table& loop) const {
    loops::AnalysisOptions options;
    options.samples_dropped = samples_dropped;
    options.effective_variance = !unweighted;
    options.leave_pinned_out = !whole_retraction;
    options.retraction_modulus_free = modulus_free;
    options.contact_point = loops::parse_contact_point(contact_point);
    options.true_area_ratio = area_ratio;
    options.segments.baseline_share = baseline_share;
    options.segments.drift = drift_model();
    options.segments.force_baseline = given(force_zero, dimension::force);
    for (const auto& edit : segments) loops::add_segment_edit(options.segments.edits, edit);
    for (const auto& term : relaxation) options.relaxation.push_back(relaxation_term(term));
    if (!displacement_drift.empty())
        options.displacement_drift_rate = parse_quantity(displacement_drift, dimension::velocity);
    if (const auto stiffness = stiffness_of(*this, loop)) {
        options.machine_stiffness = stiffness->value;
        if (stiffness->standard_error > 0.0) options.machine_stiffness_standard_error = stiffness->standard_error;
    }
    return options;
}

study::LoopModelOptions LoopModelsRequest::options() const {
    const auto shares = [&](const char* what) { return std::find(shared.begin(), shared.end(), what) != shared.end(); };
    for (const auto& name : models)
        if (name != "all") (void)loops::model_named(name);
    study::LoopModelOptions options{.models = models,
                                    .profile = profile,
                                    .crack_speed = crack_speed,
                                    .exponent = exponent,
                                    .share_contact_modulus = shares("modulus"),
                                    .share_work_of_adhesion = shares("work")};
    options.branch = branch == "loading" ? loops::LoopBranch::loading : loops::LoopBranch::unloading;
    options.errors = study::fit_errors_named(errors);
    if (!contact_point.empty()) options.contact_point = parse_quantity(contact_point, dimension::length);
    if (!cohesive_stress.empty()) options.cohesive_stress = parse_quantity(cohesive_stress, dimension::pressure);
    return options;
}

AnalysedLoop analysed_loop(const std::string& file, const LoopFiles& files, const LoopBodies& bodies,
                           const LoopSettings& settings) {
    return analysed_loop(files.open(file), file, bodies, settings);
}

AnalysedLoop analysed_loop(study::OpenedLoop opened, const std::string& file, const LoopBodies& bodies,
                           const LoopSettings& settings) {
    AnalysedLoop loop{.file = file, .opened = std::move(opened)};
    const auto stated = bodies.bodies(loop.opened.table);
    loop.bodies = stated.values;
    loop.options = settings.options(loop.opened.table);
    loop.analysis = study::analyse_loop(loop.opened, file, stated, loop.options);
    return loop;
}

study::LoopModels models_of(const AnalysedLoop& loop, const study::LoopModelOptions& models) {
    return study::loop_models(loop.analysis, loop.bodies, loop.options, models);
}

FittedLoop fitted(const AnalysedLoop& loop, const study::LoopModelOptions& models) {
    return {&loop, models.any() ? std::optional(models_of(loop, models)) : std::nullopt};
}

}  // namespace setae::answers
