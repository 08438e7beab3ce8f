// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/command.hpp"

namespace setae::cli {

// clang-format off
namespace info_command { Action declare(Options&); }
namespace formats_command { Action declare(Options&); }
namespace convert_command { Action declare(Options&); }
namespace level_command { Action declare(Options&); }
namespace container_check_command { Action declare(Options&); }
namespace container_write_command { Action declare(Options&); }
namespace contour_command { Action declare(Options&); }
namespace check_command { Action declare(Options&); }
namespace profile_command { Action declare(Options&); }
namespace tip_command { Action declare(Options&); }
namespace psd_command { Action declare(Options&); }
Action sdrp_command(Options&);
Action acf_command(Options&);
Action vbw_command(Options&);
namespace params_command { Action declare(Options&); }
namespace adhesion_command { Action declare(Options&); }
namespace contact_solve_command { Action declare(Options&); }
namespace contact_sweep_command { Action declare(Options&); }
namespace contact_front_command { Action declare(Options&); }
namespace contact_persson_command { Action declare(Options&); }
namespace contact_compare_command { Action declare(Options&); }
namespace jkr_import_command { Action declare(Options&); }
namespace jkr_line_command { Action declare(Options&); }
namespace jkr_radius_command { Action declare(Options&); }
namespace jkr_camera_command { Action declare(Options&); }
namespace jkr_lens_command { Action declare(Options&); }
namespace jkr_stiffness_command { Action declare(Options&); }
namespace jkr_fit_command { Action declare(Options&); }
namespace jkr_energy_command { Action declare(Options&); }
namespace jkr_summary_command { Action declare(Options&); }
namespace synthesize_command { Action declare(Options&); }
namespace study_command { Action declare(Options&); }
namespace study_init_command { Action declare(Options&); }
namespace predict_command { Action declare(Options&); }
namespace plot_command { Action declare(Options&); }
namespace lab_make_command { Action declare(Options&); }
namespace lab_closure_command { Action declare(Options&); }
namespace lab_causes_command { Action declare(Options&); }
namespace lab_next_command { Action declare(Options&); }
namespace lab_conform_command { Action declare(Options&); }
namespace lab_area_command { Action declare(Options&); }
namespace lab_loops_command { Action declare(Options&); }
namespace lab_records_command { Action declare(Options&); }
namespace lab_contours_command { Action declare(Options&); }
namespace lab_foil_command { Action declare(Options&); }
namespace lab_recording_command { Action declare(Options&); }
namespace schema_command { Action declare(Options&); }
namespace cache_command { Action declare(Options&); }
namespace completion_command { Action declare(Options&); }
namespace man_command { Action declare(Options&); }
// clang-format on

namespace {

constexpr CommandGroup groups[] = {
    {"contact", "two rough bodies pressed together"},
    {"container", "containers of contact.engineering: what is in them, and making them"},
    {"jkr", "contact experiments with a soft or hard sphere"},
    {"lab", "measurements simulated on surfaces of which everything is known"},
};

constexpr Command table[] = {
    {"", "info", "what files and folders hold, which verb takes them, and what they leave open", info_command::declare},
    {"", "formats", "file formats setae reads and writes", formats_command::declare},
    {"", "convert", "write the heights of files in metres as .x3p, .sdf, .gwy, .nc, .npy, .txt or .csv",
     convert_command::declare},
    {"", "level", "levels, aligns, despikes, filters, crops: processing steps, recorded, on any number of files",
     level_command::declare},
    {"container", "check",
     "surfaces and measurements of containers, all that is wrong, and whether writing loses anything",
     container_check_command::declare},
    {"container", "write", "measured files, or older containers, as a container that contact.engineering takes",
     container_write_command::declare},
    {"", "contour", "from a micrograph's edge to a profile with errors", contour_command::declare},
    {"", "check", "what is wrong with measurements, how large its effect is, what to do", check_command::declare},
    {"", "profile", "heights of a map along a straight line", profile_command::declare},
    {"", "tip", "the tip from its own scan, and where the scan shows the surface", tip_command::declare},
    {"", "psd", "power spectral density of one measurement, or combined from several", psd_command::declare},
    {"", "sdrp", "slope and curvature at every scale, of one measurement or combined from several", sdrp_command},
    {"", "acf", "height-difference autocorrelation of one measurement, or combined from several", acf_command},
    {"", "vbw", "rms height left in cells of every size, of one measurement or combined from several", vbw_command},
    {"", "params", "roughness parameters of files, from heights and from their combined spectrum",
     params_command::declare},
    {"", "adhesion", "apparent work of adhesion of a soft solid on a measured surface", adhesion_command::declare},
    {"contact", "solve", "a rough surface pressed on an elastic body: area, gap, stiffness, pressure point by point",
     contact_solve_command::declare},
    {"contact", "sweep", "a rough surface that attracts, approached and parted: work, loss, every step's ledger",
     contact_sweep_command::declare},
    {"contact", "front",
     "a soft sphere on a rough surface, its edge as a crack front: W on approach and retraction, jumps, loss",
     contact_front_command::declare},
    {"contact", "persson", "area, gap, stiffness and energy of a rough contact from its spectrum, by Persson's theory",
     contact_persson_command::declare},
    {"contact", "compare", "Persson's theory beside solved contacts of surfaces with the same spectrum",
     contact_compare_command::declare},
    {"jkr", "import", "turn tables, workbooks and force curves into loop files, columns guessed and shown",
     jkr_import_command::declare},
    {"jkr", "radius", "contact radius in every frame of a recording", jkr_radius_command::declare},
    {"jkr", "line", "edge of the contact in a recording: roughness, speed, jumps, arrests, voids",
     jkr_line_command::declare},
    {"jkr", "lens", "radius of curvature and asphericity of a lens from a profile or a picture of its side",
     jkr_lens_command::declare},
    {"jkr", "camera", "pixel size, aspect and distortion of a camera from pictures of a stage micrometer",
     jkr_camera_command::declare},
    {"jkr", "stiffness", "stiffness of the machine from a loop on something rigid", jkr_stiffness_command::declare},
    {"jkr", "fit", "fit JKR to loops of force, displacement and contact radius", jkr_fit_command::declare},
    {"jkr", "energy", "where the energy of loops goes: ledger, error budget, course along the loop",
     jkr_energy_command::declare},
    {"jkr", "summary", "means of repeated fits over spots, lenses and surfaces, with a forest plot",
     jkr_summary_command::declare},
    {"", "synthesize", "make a random surface or line with a given power spectrum", synthesize_command::declare},
    {"", "study", "run a study: surfaces, elastomers, experiments → tables and fits", study_command::declare},
    {"study", "init", "draft a study from what files in folders say; what it must be told is asked in its lines",
     study_init_command::declare},
    {"", "predict",
     "hysteresis from roughness: W_ret at pull-off, pull-off force and loss of every pair, and the law that says the measured ones",
     predict_command::declare},
    {"", "plot", "draw one figure of a study: SVG, PDF, PNG or its numbers as CSV", plot_command::declare},
    {"lab", "make", "write what instruments would record on surfaces and loops of a recipe", lab_make_command::declare},
    {"lab", "closure", "make and study a recipe many times: bias and coverage of every quantity",
     lab_closure_command::declare},
    {"lab", "causes", "what each thing a mean of spectra leaves uncorrected does, alone", lab_causes_command::declare},
    {"lab", "next", "do what `setae study --next` advises, and hold it to its promise", lab_next_command::declare},
    {"lab", "conform", "simulate rough patches in adhesive contact: whether they close, and what that gains",
     lab_conform_command::declare},
    {"lab", "area", "compare the true area of self-affine maps with that of Gaussian slopes (Fig. S7)",
     lab_area_command::declare},
    {"lab", "loops", "fit many noisy loops that are known: bias and coverage of every fit", lab_loops_command::declare},
    {"lab", "records", "analyse simulated records with the faults that laboratories meet: bias, coverage, what is said",
     lab_records_command::declare},
    {"lab", "contours", "trace contours in rendered micrographs of known curves: errors, heights, spectra, overhangs",
     lab_contours_command::declare},
    {"lab", "recording", "render the edge of a contact as a camera records it: a recording whose truth is known",
     lab_recording_command::declare},
    {"lab", "foil", "what the silhouette of a foil shows of a surface with a given spectrum",
     lab_foil_command::declare},
    {"", "schema", "what each verb's JSON holds: names, types, units and meanings as JSON Schema",
     schema_command::declare},
    {"", "cache", "results kept between runs: show, prune or clear them", cache_command::declare},
    {"", "completion", "what bash, zsh or fish need to complete setae's verbs and options",
     completion_command::declare},
    {"", "man", "the manual page, as man reads it", man_command::declare},
};

}  // namespace

std::span<const Command> commands() { return table; }
std::span<const CommandGroup> command_groups() { return groups; }

}  // namespace setae::cli
