// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/command.hpp"

namespace setae::cli {

Action info_command(Options&);
Action formats_command(Options&);
Action convert_command(Options&);
Action level_command(Options&);
Action container_check_command(Options&);
Action container_write_command(Options&);
Action contour_command(Options&);
Action check_command(Options&);
Action profile_command(Options&);
Action tip_command(Options&);
Action psd_command(Options&);
Action sdrp_command(Options&);
Action acf_command(Options&);
Action vbw_command(Options&);
Action params_command(Options&);
Action adhesion_command(Options&);
Action jkr_import_command(Options&);
Action jkr_radius_command(Options&);
Action jkr_lens_command(Options&);
Action jkr_fit_command(Options&);
Action jkr_energy_command(Options&);
Action jkr_summary_command(Options&);
Action synthesize_command(Options&);
Action study_command(Options&);
Action plot_command(Options&);
Action lab_make_command(Options&);
Action lab_closure_command(Options&);
Action lab_causes_command(Options&);
Action lab_area_command(Options&);
Action lab_loops_command(Options&);
Action lab_contours_command(Options&);
Action lab_foil_command(Options&);
Action cache_command(Options&);
Action completion_command(Options&);
Action man_command(Options&);

namespace {

constexpr CommandGroup groups[] = {
    {"container", "containers of contact.engineering: what is in them, and making them"},
    {"jkr", "contact experiments with a soft or hard sphere"},
    {"lab", "measurements simulated on surfaces of which everything is known"},
};

constexpr Command table[] = {
    {"", "info", "what files hold: format, channels, shape, size, unit, heights, and what they leave open",
     info_command},
    {"", "formats", "file formats setae reads and writes", formats_command},
    {"", "convert", "write the heights of files in metres as .x3p, .sdf, .gwy, .nc, .npy, .txt or .csv",
     convert_command},
    {"", "level", "levels, aligns, despikes, filters, crops: processing steps, recorded, on any number of files",
     level_command},
    {"container", "check",
     "surfaces and measurements of containers, all that is wrong, and whether writing loses anything",
     container_check_command},
    {"container", "write", "measured files, or older containers, as a container that contact.engineering takes",
     container_write_command},
    {"", "contour", "from a micrograph's edge to a profile with errors", contour_command},
    {"", "check", "what is wrong with measurements, how large its effect is, what to do", check_command},
    {"", "profile", "heights of a map along a straight line", profile_command},
    {"", "tip", "the tip from its own scan, and where the scan shows the surface", tip_command},
    {"", "psd", "power spectral density of one measurement, or combined from several", psd_command},
    {"", "sdrp", "slope and curvature at every scale, of one measurement or combined from several", sdrp_command},
    {"", "acf", "height-difference autocorrelation of one measurement, or combined from several", acf_command},
    {"", "vbw", "rms height left in cells of every size, of one measurement or combined from several", vbw_command},
    {"", "params", "roughness parameters of files, from heights and from their combined spectrum", params_command},
    {"", "adhesion", "apparent work of adhesion of a soft solid on a measured surface", adhesion_command},
    {"jkr", "import", "turn tables, workbooks and force curves into loop files, columns guessed and shown",
     jkr_import_command},
    {"jkr", "radius", "contact radius in every frame of a recording", jkr_radius_command},
    {"jkr", "lens", "radius of curvature of a lens from a profile or an outline of it", jkr_lens_command},
    {"jkr", "fit", "fit JKR to loops of force, displacement and contact radius", jkr_fit_command},
    {"jkr", "energy", "where the energy of loops goes: ledger, error budget, course along the loop",
     jkr_energy_command},
    {"jkr", "summary", "means of repeated fits over spots, lenses and surfaces, with a forest plot",
     jkr_summary_command},
    {"", "synthesize", "make a random surface or line with a given power spectrum", synthesize_command},
    {"", "study", "run a study: surfaces, elastomers, experiments → tables and fits", study_command},
    {"", "plot", "draw one figure of a study: SVG, PDF, PNG or its numbers as CSV", plot_command},
    {"lab", "make", "write what instruments would record on surfaces and loops of a recipe", lab_make_command},
    {"lab", "closure", "make and study a recipe many times: bias and coverage of every quantity", lab_closure_command},
    {"lab", "causes", "what each thing a mean of spectra leaves uncorrected does, alone", lab_causes_command},
    {"lab", "area", "compare the true area of self-affine maps with that of Gaussian slopes (Fig. S7)",
     lab_area_command},
    {"lab", "loops", "fit many noisy loops that are known: bias and coverage of every fit", lab_loops_command},
    {"lab", "contours", "trace contours in rendered micrographs of known curves: errors, heights, spectra, overhangs",
     lab_contours_command},
    {"lab", "foil", "what the silhouette of a foil shows of a surface with a given spectrum", lab_foil_command},
    {"", "cache", "results kept between runs: show, prune or clear them", cache_command},
    {"", "completion", "what bash, zsh or fish need to complete setae's verbs and options", completion_command},
    {"", "man", "the manual page, as man reads it", man_command},
};

}  // namespace

std::span<const Command> commands() { return table; }
std::span<const CommandGroup> command_groups() { return groups; }

}  // namespace setae::cli
