// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/contour.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/units.hpp"
#include "setae/file_figures/contour_figure.hpp"
#include "setae/imaging/calibration_file.hpp"
#include "setae/output/contour_fields.hpp"
#include "setae/output/contour_file.hpp"
#include "setae/output/field_json.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/file_content.hpp"

namespace setae::cli::contour_command {
namespace {

namespace fs = std::filesystem;

constexpr const char* explanation =
    "The command traces the edge between vacuum and sample in a micrograph. The result is a profile with standard errors.\n"
    "\n"
    "division        vacuum and sample, by grey level and structure: minimum cuts, coarse to fine\n"
    "edge            I(d) = level + step/2 erf(d/(sqrt(2) w)) + fringe (d/f) exp(1/2 - d^2/(2 f^2))\n"
    "                d is the distance along the normal of the contour, positive in vacuum.\n"
    "trace           least squares of all pixels near the edge + l^4 |second difference|^2\n"
    "                In the trace a wave q is followed by K = 1/(1 + l^4 (2 - 2 cos q)^2).\n"
    "standard error  (1/pi) int [(1 - K)^2 S + K^2 N] dq\n"
    "                N is measured next to the edge. S is the spectrum of the positions minus N.\n"
    "profile         turned to its mean line\n"
    "                The envelope is the highest point at each x. Otherwise re-entrant stretches are excluded.\n"
    "spectrum        C1D = (P - K^2 N)/T^2, T = K exp(-q^2 w^2/2); `setae psd` computes it from the profile file\n"
    "Rq              sqrt(mean h^2 - mean squared standard error)\n"
    "pixel size      from the options, else from the file, else from the scale bar\n"
    "                Scale bar: its length in pixels, with the label as read or as given by --scale-bar.\n";

struct Arguments : answers::ContourRequest {
    Common common;
    std::vector<std::string> pictures;
    std::string output, anchors, segment = "1", save_calibration;
    FigureOption figure;
    bool no_overlay = false;
};

/// Output files of one picture.
struct Outputs {
    fs::path stem;          ///< without ending
    std::string extension;  ///< of profiles
};

Outputs outputs_of(const Arguments& a, const std::string& picture, bool batch) {
    if (batch) return {fs::path(a.output) / fs::path(picture).stem(), ".csv"};
    const fs::path path(a.output);
    return {path.parent_path() / path.stem(), path.extension().empty() ? ".csv" : path.extension().string()};
}

/// @throws InvalidArgument where a result would replace its input.
void require_not_the_same(const fs::path& output, const std::string& input) {
    std::error_code error;
    if (fs::equivalent(output, input, error))
        throw InvalidArgument(
            fmt::format("{} would be overwritten by a result; choose another name or folder for -o", input));
}

/// The options, with the anchors of a file.
answers::RepeatedTrace trace_options(const Arguments& a) {
    auto repeated = a.with_anchors(a.anchors);
    if (!a.anchors.empty() && !repeated.is_whole && !a.output.empty())
        require_not_the_same(outputs_of(a, a.pictures.front(), false).stem.string() + ".json", a.anchors);
    return repeated;
}

std::vector<std::size_t> chosen_segments(const Arguments& a, std::size_t count) {
    std::vector<std::size_t> chosen;
    if (a.segment == "all") {
        for (std::size_t i = 0; i < count; ++i) chosen.push_back(i);
        return chosen;
    }
    const auto number = spelled<std::size_t>(a.segment).value_or(0);
    if (number == 0 || number > count)
        throw InvalidArgument(
            fmt::format("--segment {}: expected all or the number of a segment, 1 to {}", a.segment, count));
    return {number - 1};
}

void write_picture(const Arguments& a, const study::TracedPicture& picture, const study::ContourOptions& options,
                   const Outputs& to) {
    const auto chosen = chosen_segments(a, picture.profiles.size());
    if (file_figures::is_figure_path(a.output)) {
        require_not_the_same(a.output, picture.micrograph.file);
        write_figure(file_figures::contour_figure(picture, chosen, options.shape, a.figure.look()), a.output,
                     a.common.json);
        return;
    }
    const auto& input = picture.micrograph.file;
    require_not_the_same(to.stem.string() + to.extension, input);
    require_not_the_same(to.stem.string() + ".json", input);
    if (!a.no_overlay) require_not_the_same(to.stem.string() + ".png", input);
    for (const auto i : chosen) {
        const auto path = chosen.size() == 1 ? to.stem.string() + to.extension
                                             : fmt::format("{}_{}{}", to.stem.string(), i + 1, to.extension);
        bytes::write_whole_file(path, study::profile_text(picture, i, options.shape));
    }
    bytes::write_whole_file(to.stem.string() + ".json",
                            output::as_text(output::described(output::ContourEntry{&picture, &options})));
    if (!a.no_overlay) bytes::write_whole_file(to.stem.string() + ".png", study::overlay_of(picture, options));
}

std::vector<std::string> listed(const std::vector<std::string>& given) {
    std::vector<std::string> pictures;
    for (const auto& path : given) {
        if (!study::is_folder(path)) {
            pictures.push_back(path);
            continue;
        }
        const auto found = imaging::micrographs_in(path);
        pictures.insert(pictures.end(), found.begin(), found.end());
    }
    return pictures;
}

void require_different_stems(const std::vector<std::string>& pictures) {
    std::vector<std::string> stems;
    for (const auto& path : pictures) stems.push_back(fs::path(path).stem().string());
    std::sort(stems.begin(), stems.end());
    if (const auto twin = std::adjacent_find(stems.begin(), stems.end()); twin != stems.end())
        throw InvalidArgument(fmt::format(
            "two pictures have the name {} and the same output file; trace the pictures one by one", *twin));
}

/// The trace of one picture, or the reason why there is none.
struct Outcome {
    std::optional<study::TracedPicture> picture;
    std::string error;
};

Outcome traced(const Arguments& a, const std::string& path, const answers::RepeatedTrace& repeated, bool batch) {
    Outcome outcome;
    try {
        outcome.picture = study::trace_picture(path, repeated.options);
        repeated.require_picture(*outcome.picture, a.anchors);
        if (!a.output.empty()) write_picture(a, *outcome.picture, repeated.options, outputs_of(a, path, batch));
        if (batch) outcome.picture->micrograph.pixels.resize(0, 0);
    } catch (const std::exception& error) {
        outcome.picture.reset();
        outcome.error = reason_of(error);
    }
    return outcome;
}

/// One row per segment: the columns that a terminal shows, lengths with units.
tables::TidyTable in_short(const tables::TidyTable& table) {
    auto shown = tables::with_columns(
        table, {"file", "segment", "state", "pixel_x [m]", "length [m]", "Rq [m]", table.columns.back()});
    for (auto& row : shown.rows) {
        if (const double segment = std::get<double>(row[1]); !std::isnan(segment)) row[1] = fmt::format("{}", segment);
        for (auto& cell : row)
            if (const auto* length = std::get_if<double>(&cell)) cell = format_value(*length, "m");
        row.front() = fs::path(std::get<std::string>(row.front())).filename().string();
    }
    shown.columns = {"file", "segment", "state", "pixel", "length", "Rq", "warnings or failure"};
    return tables::constants_in_title(shown);
}

ExitCode run(const Arguments& a) {
    if (a.pictures.empty()) throw InvalidArgument("no picture given; name one, several, or a folder");
    const auto pictures = listed(a.pictures);
    const bool batch = pictures.size() > 1 || study::is_folder(a.pictures.front());
    if (batch && !a.anchors.empty())
        throw InvalidArgument("--anchors are for one picture; trace this picture separately");
    if (batch && !a.save_calibration.empty())
        throw InvalidArgument("--save-calibration is for one picture; trace this picture separately first");
    const auto repeated = trace_options(a);
    if (batch) {
        require_different_stems(pictures);
        if (!a.output.empty()) fs::create_directories(a.output);
    }
    std::vector<Outcome> outcomes(pictures.size());
    parallel::for_each_index(pictures.size(), a.common.workers(),
                             [&](std::size_t i) { outcomes[i] = traced(a, pictures[i], repeated, batch); });

    auto table = study::contour_table();
    auto json = output::Json::array();
    std::size_t failed = 0;
    std::vector<Alert> alerts;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const auto& outcome = outcomes[i];
        if (!outcome.picture) {
            ++failed;
            print_message(outcome.error);
            study::add_failure(table, pictures[i], outcome.error);
            json.push_back({{"image", {{"file", pictures[i]}}}, {"error", outcome.error}});
            continue;
        }
        alerts.insert(alerts.end(), outcome.picture->alerts.begin(), outcome.picture->alerts.end());
        study::add_rows(table, *outcome.picture);
        if (a.common.json)
            json.push_back(output::described(output::ContourEntry{&*outcome.picture, &repeated.options}));
    }
    show(alerts);
    if (!a.save_calibration.empty() && failed == 0)
        imaging::write_calibration(a.save_calibration,
                                   imaging::kept_calibration(outcomes.front().picture->calibration, pictures.front()));
    if (batch && !a.output.empty())
        bytes::write_whole_file((fs::path(a.output) / "contours.csv").string(), tables::as_csv(table));
    if (a.common.json) print_json(batch ? json : json.front());
    else if (batch || !a.output.empty())
        print(tables::as_text_within(a.common.all ? table : in_short(table), output_size().width));
    else if (failed == 0)
        print(study::profile_text(*outcomes.front().picture,
                                  chosen_segments(a, outcomes.front().picture->profiles.size()).front(),
                                  repeated.options.shape));
    if (failed == pictures.size()) return ExitCode::nothing_done;
    return failed > 0 ? ExitCode::some_failed : ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add("pictures", arguments->pictures,
             "DM3, DM4, TIFF, PNG, JPEG, SER, EMD or MRC; several, or a folder of them")
        .of_inputs();
    options.output("-o,--output", arguments->output,
                   "OUT.csv, with OUT.json and OUT.png in the same folder; OUT.svg, .pdf or .png: only a figure of the "
                   "profile; for several pictures a folder");
    arguments->figure.add_to(options);
    options.add("--anchors", arguments->anchors,
                "points that the trace must pass (JSON), or a whole trace to be repeated");
    options.add("--segment", arguments->segment, "number of the segment that is written, longest first, or all");
    options.ask<answers::ContourRequest>(*arguments);
    options.output("--save-calibration", arguments->save_calibration,
                   "file for the pixel size, for other pictures of the same magnification");
    options.flag("--no-overlay", arguments->no_overlay, "write no OUT.png").in(OptionGroup::output);
    options.example("setae contour tem.dm3 -o contour.csv",
                    "profile, contour.json with the options that repeat it, contour.png with the edge drawn in");
    options.example("setae contour tem.tif --scale-bar \"50 nm\" -o contour.svg",
                    "figure of the profile, from a picture with a scale bar of 50 nm");
    options.example("setae contour pictures -o contours", "profiles of all pictures of a folder");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::contour_command
