// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/file_options.hpp"
#include "files/measurement_files.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/diagnostics/diagnose.hpp"

namespace setae::cli::check_command {
namespace {

constexpr const char* explanation =
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
    FileOptions file;
    std::vector<std::string> files;
    std::string tip_radius;
    bool strict = false;
};

output::Json as_json(const diagnostics::Finding& finding) {
    output::Json json = output::to_json(std::vector<Alert>{finding.alert}).front();
    json["effects"] = output::Json::array();
    for (const auto& effect : finding.effects) json["effects"].push_back(output::to_json(effect));
    return json;
}

ExitCode run(const Arguments& arguments) {
    if (arguments.files.empty()) throw InvalidArgument("no file; expected at least one measurement");
    diagnostics::DiagnosisOptions options;
    options.threads = arguments.common.workers();
    std::optional<double> tip_radius;
    if (!arguments.tip_radius.empty()) tip_radius = parse_quantity(arguments.tip_radius, dimension::length);
    std::vector<topography::Measurement> all;
    std::vector<diagnostics::Finding> findings;
    const auto code = for_each_item(arguments.files, [&](const std::string& path) {
        for (auto& measurement : measurements_of(path, arguments.file)) {
            if (tip_radius) topography::metadata(measurement).instrument.tip_radius = tip_radius;
            auto found = diagnostics::diagnose(measurement, options);
            if (!arguments.common.json && found.empty())
                print(topography::label(topography::metadata(measurement)) + ": nothing found\n");
            findings.insert(findings.end(), std::make_move_iterator(found.begin()),
                            std::make_move_iterator(found.end()));
            all.push_back(std::move(measurement));
        }
    });
    if (all.size() > 1) {
        auto found = diagnostics::diagnose_overlap(all, options);
        findings.insert(findings.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
    }
    output::Json json = output::Json::array();
    for (const auto& finding : findings) {
        if (arguments.common.json) json.push_back(as_json(finding));
        else
            print(fmt::format("{}: {}: {}; {}\n", finding.alert.subject, finding.alert.code, finding.alert.message,
                              finding.alert.action));
    }
    if (arguments.common.json) print_json(json);
    return code == ExitCode::done && arguments.strict && !findings.empty() ? ExitCode::some_failed : code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add("files", arguments->files, "measurements: files or containers; several are also compared with each other")
        .of_inputs();
    arguments->file.add_to(options);
    options.add("--tip-radius", arguments->tip_radius, "such as \"10 nm\", where the file does not say it")
        .quantity(positive(dimension::length), "nm");
    options.flag("--strict", arguments->strict, "exit code 1 where anything is found");
    options.example("setae check afm.ibw --tip-radius \"10 nm\"", "what is wrong with one map, and what to do");
    options.example("setae check a.ibw b.ibw stylus.csv", "the same, and whether they agree with each other");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::check_command
