// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/diagnosis.hpp"
#include "setae/core/words.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::check_command {
namespace {

constexpr const char* explanation =
    "The command tests measurements for these problems. docs/reference/diagnostics.md gives the tests and their error rates.\n"
    "\n"
    "NO_DATA            heights equal to a number that marks missing data; taken as undefined\n"
    "NO_DATA_SUSPECTED  heights equal to a number that may mark missing data; kept\n"
    "UNDEF              share of undefined heights\n"
    "REENTRANT          share of the length of a curve that runs backwards\n"
    "QUANTISED          steps of the digitiser: size over rms height, share of equal neighbours\n"
    "CLIPPED            number of heights at the end of the range\n"
    "TILT_LARGE         plane of more than 3 times the rms of the rest\n"
    "CURVATURE_LEFT     bow of more than 1.5 times the rms of the rest\n"
    "SPIKES             points more than 6 robust deviations from the median of their surroundings\n"
    "                   Given are their number, C1D with over without them, and the wavelengths affected.\n"
    "SCARS              strokes along the fast axis that differ from the neighbouring lines\n"
    "PIXEL_NOISE        white floor above the surface at the Nyquist wavevector\n"
    "                   Given are its rms, its wavelength and its share of the mean square slope.\n"
    "TIP_CUTOFF         wavelengths that the tip does not resolve\n"
    "LOW_Q_GAP          C1D steeper than 1/q at the longest wavelengths: growth of the rms height with the size of the scan\n"
    "SCAN_DIRECTION     offsets between scan lines\n"
    "ANISOTROPIC        different rms slopes in perpendicular directions\n"
    "DISAGREE           C1D of several files in their common band, with its error\n"
    "SCALE_TWICE        ratio of C1D of two files that is one factor in the whole common band\n";

struct Arguments {
    Common common;
    answers::FileRequest file;
    std::vector<std::string> files;
    answers::DiagnosisRequest request;
    bool strict = false;
};

/// The subject first: a check is about files.
std::string line_of(const Alert& alert) {
    return fmt::format("{}: {}: {}; {}", alert.subject, alert.code, alert.message, alert.action);
}

ExitCode run(const Arguments& arguments) {
    std::vector<answers::Suspect> suspects;
    for (const auto& path : arguments.files)
        suspects.push_back({path, [path, &arguments] { return answers::measurements_of(path, arguments.file); }});
    const auto diagnosis = answers::diagnosis(suspects, arguments.request, arguments.common.workers());
    for (const auto& failure : diagnosis.failures) print_message(failure);
    if (arguments.common.json) {
        print_json(output::described(diagnosis.findings));
    } else {
        if (!diagnosis.faultless.empty()) print(listed(diagnosis.faultless) + ": nothing found\n");
        std::vector<Alert> alerts;
        for (const auto& finding : diagnosis.findings) alerts.push_back(finding.alert);
        for (const auto& line : lines_of(alerts, line_of)) print(line + "\n");
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
    options.ask(arguments->file, OptionGroup::height_files);
    options.ask(arguments->request);
    options.flag("--strict", arguments->strict, "exit code 1 if a problem is found");
    options.example("setae check afm.ibw --tip-radius \"10 nm\"",
                    "problems of one map, with their effects and remedies");
    options.example("setae check a.ibw b.ibw stylus.csv",
                    "problems of three measurements, and agreement of their spectra");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::check_command
