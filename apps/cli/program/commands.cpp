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
    {"container", "containers of contact.engineering: check, write"},
    {"jkr", "adhesion tests: loops, contact radii, lenses, fits"},
    {"contact", "rough surface on a soft body: solver, crack front, theory"},
    {"lab", "simulated experiments with known true values"},
};

// descriptions of at most 60 characters: a line of the help
constexpr Command table[] = {
    {"Inspect", "", "info", "contents of files, and the commands that take them", info_command::declare},
    {"Inspect", "", "formats", "supported file formats", formats_command::declare},
    {"Inspect", "", "check", "problems of measurements, size of the effect, remedy", check_command::declare},
    {"Inspect", "", "profile", "heights of a map along a straight line", profile_command::declare},
    {"Inspect", "", "tip", "shape of the tip, estimated from its own scan", tip_command::declare},
    {"Prepare", "", "convert", "heights as .x3p, .sdf, .gwy, .nc, .npy, .txt or .csv", convert_command::declare},
    {"Prepare", "", "level", "level, align, despike, filter, crop; steps are recorded", level_command::declare},
    {"Prepare", "", "contour", "profile with errors from the edge in a micrograph", contour_command::declare},
    {"Prepare", "container", "check", "surfaces and measurements of containers, with problems",
     container_check_command::declare},
    {"Prepare", "container", "write", "container for contact.engineering from measured files",
     container_write_command::declare},
    {"Roughness", "", "psd", "power spectral density of one or several measurements", psd_command::declare},
    {"Roughness", "", "params", "roughness parameters from heights and spectrum", params_command::declare},
    {"Roughness", "", "acf", "height-difference autocorrelation", acf_command},
    {"Roughness", "", "sdrp", "slope and curvature as functions of scale", sdrp_command},
    {"Roughness", "", "vbw", "variable bandwidth: rms height in cells of every size", vbw_command},
    {"Adhesion tests", "jkr", "import", "loop files from tables, workbooks and force curves",
     jkr_import_command::declare},
    {"Adhesion tests", "jkr", "radius", "contact radius in every frame of a recording", jkr_radius_command::declare},
    {"Adhesion tests", "jkr", "line", "edge of a contact: roughness, speed, jumps, voids", jkr_line_command::declare},
    {"Adhesion tests", "jkr", "lens", "radius of curvature of a lens from profile or picture",
     jkr_lens_command::declare},
    {"Adhesion tests", "jkr", "camera", "pixel size and distortion from a stage micrometer",
     jkr_camera_command::declare},
    {"Adhesion tests", "jkr", "stiffness", "stiffness of the testing machine from a rigid contact",
     jkr_stiffness_command::declare},
    {"Adhesion tests", "jkr", "fit", "JKR fits to loops of force, displacement, contact radius",
     jkr_fit_command::declare},
    {"Adhesion tests", "jkr", "energy", "energy budget of loops, with errors", jkr_energy_command::declare},
    {"Adhesion tests", "jkr", "summary", "means of fits over spots, lenses and surfaces", jkr_summary_command::declare},
    {"Predict", "", "adhesion", "apparent work of adhesion on a measured surface", adhesion_command::declare},
    {"Predict", "", "predict", "hysteresis: W_ret, pull-off force and loss of every pair", predict_command::declare},
    {"Predict", "contact", "solve", "rough surface on an elastic body: area, gap, stiffness",
     contact_solve_command::declare},
    {"Predict", "contact", "sweep", "adhesive contact, approach and retraction: work, loss",
     contact_sweep_command::declare},
    {"Predict", "contact", "front", "edge of an adhesive contact as a crack front", contact_front_command::declare},
    {"Predict", "contact", "persson", "area, gap, stiffness from a spectrum (Persson's theory)",
     contact_persson_command::declare},
    {"Predict", "contact", "compare", "Persson's theory compared with solved contacts",
     contact_compare_command::declare},
    {"Studies", "", "study", "surfaces, elastomers and loops together: W_int, figures", study_command::declare},
    {"Studies", "study", "init", "draft of a study from the files in folders", study_init_command::declare},
    {"Studies", "", "plot", "one figure of a study as SVG, PDF, PNG or CSV", plot_command::declare},
    {"Studies", "", "cache", "stored results: show, prune, clear", cache_command::declare},
    {"Simulate", "", "synthesize", "random surface or line with a given power spectrum", synthesize_command::declare},
    {"Simulate", "lab", "make", "measurements and loops of a recipe, as instruments record", lab_make_command::declare},
    {"Simulate", "lab", "closure", "recipes studied many times: bias and coverage", lab_closure_command::declare},
    {"Simulate", "lab", "causes", "effect of each correction missing from mean spectra", lab_causes_command::declare},
    {"Simulate", "lab", "next", "measurements advised by `setae study --next`, tested", lab_next_command::declare},
    {"Simulate", "lab", "conform", "rough patches in adhesive contact: full contact or not",
     lab_conform_command::declare},
    {"Simulate", "lab", "area", "true area of self-affine maps against Eq. 9 (Fig. S7)", lab_area_command::declare},
    {"Simulate", "lab", "loops", "fits of simulated noisy loops: bias and coverage", lab_loops_command::declare},
    {"Simulate", "lab", "records", "analysis of simulated records with faults", lab_records_command::declare},
    {"Simulate", "lab", "contours", "contours traced in rendered micrographs: errors", lab_contours_command::declare},
    {"Simulate", "lab", "recording", "recording of a contact edge with known true values",
     lab_recording_command::declare},
    {"Simulate", "lab", "foil", "projection of a foil of a surface with a given spectrum", lab_foil_command::declare},
    {"This program", "", "schema", "JSON Schema of each command's --json output", schema_command::declare},
    {"This program", "", "completion", "completion of commands for bash, zsh and fish", completion_command::declare},
    {"This program", "", "man", "manual page", man_command::declare},
};

}  // namespace

std::span<const Command> commands() { return table; }
std::span<const CommandGroup> command_groups() { return groups; }

}  // namespace setae::cli
