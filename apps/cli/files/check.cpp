// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/diagnosis.hpp"

namespace setae::cli::check_command {
namespace {

constexpr const char* explanation =
    "NO_DATA         a value that marks missing heights, which were taken as undefined; NO_DATA_SUSPECTED: one that may, which was kept\n"
    "UNDEF           heights without a value: their share\n"
    "REENTRANT       stretches of a curve that turn back: share of its length\n"
    "QUANTISED       steps of the digitiser: their size against rms height, share of equal neighbours\n"
    "CLIPPED         heights at the end of the range: how many\n"
    "TILT_LARGE      a plane above three times the rms of the rest; CURVATURE_LEFT: a bow above one and a half times\n"
    "SPIKES          points beyond 6 robust deviations of the median around: n, C1D with over without, from which wavelength on\n"
    "SCARS           strokes along the fast axis that stand out of the lines beside\n"
    "PIXEL_NOISE     a white floor above the surface at the Nyquist wavevector: its rms, wavelength, share of the mean square slope\n"
    "TIP_CUTOFF      wavelengths the tip hides\n"
    "LOW_Q_GAP       C1D steeper than 1/q at the longest wavelengths: how rms height grows with the scan\n"
    "SCAN_DIRECTION  offsets of scan lines; ANISOTROPIC: rms slopes of perpendicular directions\n"
    "DISAGREE        of several files: C1D in their common band, with its error; SCALE_TWICE where the ratio is one factor throughout\n"
    "docs/reference/diagnostics.md says how each is tested and how often it errs\n";

struct Arguments {
    Common common;
    answers::FileRequest file;
    std::vector<std::string> files;
    answers::DiagnosisRequest request;
    bool strict = false;
};

ExitCode run(const Arguments& arguments) {
    std::vector<answers::Suspect> suspects;
    for (const auto& path : arguments.files)
        suspects.push_back({path, [path, &arguments] { return answers::measurements_of(path, arguments.file); }});
    const auto diagnosis = answers::diagnosis(suspects, arguments.request, arguments.common.workers());
    for (const auto& failure : diagnosis.failures) complain(failure);
    if (arguments.common.json) {
        print_json(answers::to_json(diagnosis));
    } else {
        for (const auto& label : diagnosis.faultless) print(label + ": nothing found\n");
        for (const auto& [alert, effects] : diagnosis.findings)
            print(fmt::format("{}: {}: {}; {}\n", alert.subject, alert.code, alert.message, alert.action));
    }
    if (!diagnosis.failures.empty())
        return diagnosis.failures.size() < arguments.files.size() ? ExitCode::some_failed : ExitCode::nothing_done;
    return arguments.strict && !diagnosis.findings.empty() ? ExitCode::some_failed : ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add("files", arguments->files, "measurements: files or containers; several are also compared with each other")
        .of_inputs();
    options.ask(arguments->file);
    options.ask(arguments->request);
    options.flag("--strict", arguments->strict, "exit code 1 where anything is found");
    options.example("setae check afm.ibw --tip-radius \"10 nm\"", "what is wrong with one map, and what to do");
    options.example("setae check a.ibw b.ibw stylus.csv", "the same, and whether they agree with each other");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::check_command
