// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/loop_arguments.hpp"

#include <algorithm>

#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::cli {

void LoopArguments::add_to(Options& options) {
    mapping_folder = cli::mapping_folder();
    options
        .add("files", files,
             "loops: tables with units in the header, setae's loop files, workbooks, force curves, or folders of them")
        .of_inputs();
    options.add(
        "--map,--mapping", map,
        "mapping (TOML) that names the columns of a foreign table: its file, or its name where it came with setae, such as eoh");
    options.add(
        "--column", columns,
        "ROLE=COLUMN overrules what names and units say, such as force=Load, displacement=3 (from 1), force=\"Kraft[uN]\" (a unit that the header lacks), or ROLE=EXPRESSION over columns, such as force=\"-1 * load\"; also contact_radius, time");
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
    options.add(
        "--curve-number", curve_number,
        "one force curve of a file of many, as the file counts them, from 0; without it `jkr fit` fits them all");
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
    options
        .add("--lens-height", lens_height,
             "height of the soft lens above its mount, such as \"3 ± 0.1 mm\": fits are corrected for it")
        .quantity(positive(dimension::length));
    options.add("--layer-thickness", layer_thickness, "the same of a soft layer on a rigid base")
        .quantity(positive(dimension::length));
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
    options
        .add("--baseline-share", baseline_share,
             "share of the record, from its start, that is free flight; default: found from the record")
        .within(domain::share);
    options
        .add(
            "--drift", drift,
            "curve that the zero of force follows in time: auto (the line through the free flight before and after contact, a curve "
            "where that does not fit), none, linear, quadratic, cubic, extrapolate (the free flight before contact only)")
        .default_shown();
    options
        .add("--force-zero", force_zero,
             "zero of force where no free flight shows it, such as \"0 N\"; no drift is removed")
        .quantity(dimension::force);
    options.add("--displacement-drift", displacement_drift, "rate of it where known, such as \"0.1 nm/s\"")
        .quantity(dimension::length / dimension::time);
    options.add("--area-ratio", area_ratio, "true over apparent area of the hard surface, for losses per true area")
        .within(domain::positive)
        .default_shown();
    options.add("--samples-dropped", samples_dropped, "samples left out after the jump into contact")
        .between(0, 1000000);
    options.add(
        "--relaxation", relaxation,
        "SHARE:TIME of E(t)/E∞ = 1 + Σ g e^(−t/τ), such as 0.1:20s; what the bulk relaxes is taken off the force first");
    options.flag("--unweighted", unweighted, "ordinary least squares in radius or depth, errors of force left out");
    options.flag("--no-drift", no_drift,
                 "the same as --drift none: one zero of force, from the free flight before contact");
    options.flag("--whole-retraction", whole_retraction,
                 "fit the retraction from the largest force, its pinned stretch included");
    options.flag("--retraction-modulus-free", modulus_free, "fit E* in (S2) too");
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
                results[i].loop =
                    answers::analysed_loop(files[first + i], request.loops, request.bodies, request.analysis);
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
