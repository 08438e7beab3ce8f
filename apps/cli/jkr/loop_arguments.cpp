// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/loop_arguments.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/loops/machine_stiffness.hpp"
#include "setae/study/force_map.hpp"
#include "setae/tables/loop_file.hpp"
#include "setae/tables/mapping_folder.hpp"

namespace setae::cli {
namespace {

std::optional<double> given(const std::string& text, const Dimension& dimension) {
    return text.empty() ? std::nullopt : std::optional(parse_quantity(text, dimension));
}

/// A length that an option gives, with its ±.
std::optional<Estimate> length(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(parse_uncertain_quantity(text, positive(dimension::length)));
}

/// k of the machine: given, measured on something rigid, or stated in the loop's file.
std::optional<Estimate> stiffness_of(const LoopAnalysisArguments& arguments, const Table& loop) {
    if (!arguments.machine_stiffness.empty())
        return parse_uncertain_quantity(arguments.machine_stiffness, dimension::stiffness);
    if (!arguments.rigid_contact.empty()) {
        const auto rigid = study::open_loop({.file = arguments.rigid_contact});
        return loops::machine_stiffness_from_rigid_contact(loops::loop_from_table(rigid.table)).stiffness;
    }
    return tables::loop_quantity(loop, "machine_stiffness");
}

AnalysedLoop analysed(const LoopAnalysisRequest& request, const std::string& file) {
    AnalysedLoop loop{.file = file, .opened = request.loops.open(file)};
    const auto bodies = request.bodies.bodies(loop.opened.table);
    loop.bodies = bodies.values;
    loop.options = request.analysis.options(loop.opened.table);
    loop.analysis = study::analyse_loop(loop.opened, file, bodies, loop.options);
    return loop;
}

}  // namespace

void LoopArguments::add_to(Options& options) {
    options
        .add("files", files,
             "loops: tables with units in the header, setae's loop files, workbooks, force curves, or folders of them")
        .of_inputs();
    options.add(
        "--map,--mapping", map,
        "mapping (TOML) that names the columns of a foreign table: its file, or its name where it came with setae, such as eoh");
    options.add(
        "--camera", camera,
        "of the camera on its own clock: a table of time and contact_radius, or its pictures (TIFF stack, AVI, folder)");
    options.add("--camera-map", camera_map, "mapping file of the camera's table");
    options
        .add("--clock-offset", clock_offset,
             "added to the camera's times, such as \"0.12 s\"; default: found from the records")
        .quantity(dimension::time);
    options.add("--pixel", pixel, "of the camera's pictures where they do not say it, such as \"1.82 um\"")
        .quantity(positive(dimension::length));
    options.add("--fps", frame_rate, "of the camera's pictures, frames a second").within(domain::positive);
    options.flag("--fringes", fringes, "the pictures show Newton's rings around the contact");
    options.add("--spring-constant", spring_constant, "of the cantilever of a force curve, such as \"0.05 N/m\"")
        .quantity(positive(dimension::stiffness));
    options.add("--sensitivity", sensitivity, "of its deflection, such as \"55 nm/V\"");
    options.add("--curve-number", curve_number,
                "one force curve of a file of many, as the file counts them; without it `jkr fit` fits them all");
}

std::vector<std::string> LoopArguments::expanded() const {
    std::vector<std::string> all;
    for (const auto& path : files) {
        if (!std::filesystem::is_directory(path)) {
            all.push_back(path);
            continue;
        }
        std::vector<std::string> within;
        for (const auto& entry : std::filesystem::directory_iterator(path))
            if (entry.is_regular_file() && !entry.path().filename().string().starts_with("."))
                within.push_back(entry.path().string());
        std::sort(within.begin(), within.end());
        all.insert(all.end(), within.begin(), within.end());
    }
    if (all.empty()) throw InvalidArgument("no file; expected at least one loop");
    return all;
}

study::LoopSource LoopArguments::source(const std::string& file) const {
    study::LoopSource source{.file = file};
    source.mapping = mapping();
    if (!camera.empty()) {
        source.camera = study::CameraInput{.file = camera,
                                           .clock_offset = given(clock_offset, dimension::time),
                                           .pixel_size = given(pixel, dimension::length),
                                           .frame_rate = frame_rate,
                                           .fringes = fringes};
        if (!camera_map.empty()) source.camera->mapping = tables::mapping_path(camera_map, mapping_folder());
    }
    source.force_curve.spring_constant = given(spring_constant, dimension::stiffness);
    if (!sensitivity.empty()) source.force_curve.sensitivity = tables::parse_sensitivity(sensitivity);
    return source;
}

std::optional<std::string> LoopArguments::mapping() const {
    return map.empty() ? std::nullopt : std::optional(tables::mapping_path(map, mapping_folder()));
}

study::OpenedLoop LoopArguments::open(const std::string& file) const {
    const auto wanted = source(file);
    return curve_number ? study::open_force_curve(file, *curve_number, wanted.force_curve) : study::open_loop(wanted);
}

void BodyArguments::add_to(Options& options) {
    options
        .add("--radius", radius,
             "radius of the sphere, such as \"7.5 um\"; \"7.5 ± 0.1 um\" counts in the ± of JKR's fits of loops, "
             "as that of a height does")
        .quantity(positive(dimension::length));
    options.add("--nu,--poisson-ratio", poisson_ratio, "Poisson ratio of the soft body; default 0.5")
        .within(domain::poisson_ratio);
    options.add("--counter-E", counter_modulus, "Young's modulus of the counter-body; default rigid")
        .quantity(positive(dimension::pressure));
    options.add("--counter-nu", counter_poisson_ratio, "its Poisson ratio; default 0").within(domain::poisson_ratio);
    options.add("--lens-height", lens_height, "height of the soft lens above its mount, such as \"3 ± 0.1 mm\": fits are corrected for it")
        .quantity(positive(dimension::length));
    options.add("--layer-thickness", layer_thickness, "the same of a soft layer on a rigid base")
        .quantity(positive(dimension::length));
}

study::StatedBodies BodyArguments::bodies(const Table& loop) const {
    auto bodies = without_radius(loop);
    if (!(bodies.values.radius > 0.0))
        throw InvalidArgument(
            "missing --radius, the radius of the sphere, such as --radius \"7.5 um\"; the file does not say it");
    return bodies;
}

study::StatedBodies BodyArguments::without_radius(const Table& loop) const {
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

void LoopAnalysisArguments::add_to(Options& options) {
    options.add("--machine-stiffness", machine_stiffness, "where displacement is the stage's, such as \"30 ± 1 N/m\"")
        .quantity(positive(dimension::stiffness));
    options.add("--rigid-contact", rigid_contact, "a loop on something rigid, from which that stiffness is measured");
    options
        .add("--contact-point", contact_point,
             "of F-delta fits: auto, fit, a method (force_departure, broken_line, jump_in, …) or a displacement")
        .default_shown();
    options.add(
        "--segment", segments,
        "replace what was found, such as loading=120:900, unloading@2=12.5s:20s, baseline=0s:10s, cut=400, \"ignore=30:35 (slip)\"");
    options.add("--baseline-share", baseline_share, "share of the record, from its start, taken as free flight")
        .within(domain::share)
        .default_shown();
    options.add("--displacement-drift", displacement_drift, "rate of it where known, such as \"0.1 nm/s\"")
        .quantity(dimension::length / dimension::time);
    options.add("--area-ratio", area_ratio, "true over apparent area of the hard surface, for losses per true area")
        .within(domain::positive)
        .default_shown();
    options.add("--samples-dropped", samples_dropped, "samples left out after the jump into contact")
        .between(0, 1000000);
    options.flag("--unweighted", unweighted, "ordinary least squares in radius or depth, errors of force left out");
    options.flag("--extrapolate-drift", extrapolate_drift,
                 "slope of the first baseline goes on where there is no second");
    options.flag("--no-drift", no_drift, "one zero of force, from free flight before contact");
    options.flag("--whole-retraction", whole_retraction,
                 "fit the retraction from the largest force, its pinned stretch included");
    options.flag("--retraction-modulus-free", modulus_free, "fit E* in (S2) too");
}

loops::AnalysisOptions LoopAnalysisArguments::options(const Table& loop) const {
    loops::AnalysisOptions options;
    options.samples_dropped = samples_dropped;
    options.effective_variance = !unweighted;
    options.force_drift = !no_drift;
    options.leave_pinned_out = !whole_retraction;
    options.retraction_modulus_free = modulus_free;
    options.extrapolate_force_drift = extrapolate_drift;
    options.contact_point = loops::parse_contact_point(contact_point);
    options.true_area_ratio = area_ratio;
    options.segments.baseline_share = baseline_share;
    for (const auto& edit : segments) loops::add_segment_edit(options.segments.edits, edit);
    if (!displacement_drift.empty())
        options.displacement_drift_rate = parse_quantity(displacement_drift, dimension::length / dimension::time);
    if (const auto stiffness = stiffness_of(*this, loop)) {
        options.machine_stiffness = stiffness->value;
        if (stiffness->standard_error > 0.0) options.machine_stiffness_standard_error = stiffness->standard_error;
    }
    return options;
}

void LoopAnalysisRequest::add_to(Options& options) {
    loops.add_to(options);
    bodies.add_to(options);
    analysis.add_to(options);
}

ExitCode for_each_loop(const LoopAnalysisRequest& request, parallel::Threads threads,
                       const std::function<void(const AnalysedLoop&)>& show_loop) {
    const auto files = request.loops.expanded();
    struct Result {
        std::optional<AnalysedLoop> loop;
        std::string error;
    };
    std::size_t done = 0;
    // some at a time: a shown loop need not be kept
    constexpr std::size_t at_once = 64;
    for (std::size_t first = 0; first < files.size(); first += at_once) {
        std::vector<Result> results(std::min(at_once, files.size() - first));
        parallel::for_each_index(results.size(), threads, [&](std::size_t i) {
            try {
                results[i].loop = analysed(request, files[first + i]);
            } catch (const std::exception& error) {
                results[i].error = reason_of(error, files[first + i]);
            }
        });
        for (const auto& result : results) {
            if (result.loop) show_loop(*result.loop);
            else complain(result.error);
            done += result.loop ? 1 : 0;
        }
    }
    return done == files.size() ? ExitCode::done : done > 0 ? ExitCode::some_failed : ExitCode::nothing_done;
}

}  // namespace setae::cli
