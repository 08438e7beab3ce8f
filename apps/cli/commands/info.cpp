// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "verbs.hpp"

namespace setae::cli {
namespace {

constexpr const char* explanation =
    "heights in metres, scaled once and not levelled; NaN undefined; h(x, y) with the first index x, y downwards as in the file's picture\n"
    "mean, rms   over defined heights; rms = sqrt(<(h - <h>)^2>)\n"
    "size        number of points times pixel size; of a traced profile x_last - x_first\n";

struct Arguments {
    Common common;
    FileOptions file;
    std::vector<std::string> files;
};

/// What the heights of a channel say, or why they could not be read.
struct HeightSummary {
    Index undefined_count = 0;
    double mean = undefined, standard_deviation = undefined, least = undefined, greatest = undefined;
    std::string error;
};

HeightSummary summarise(const io::Channel& channel) {
    HeightSummary summary;
    if (!channel.info.is_height) return summary;
    try {
        const auto heights = topography::all_heights(channel.read());
        const auto defined = heights == heights;
        const auto count = static_cast<double>(defined.count());
        const double offset = summary.mean = defined.select(heights, 0.0).sum() / count;
        summary.undefined_count = heights.size() - defined.count();
        summary.standard_deviation = std::sqrt(defined.select((heights - offset).square(), 0.0).sum() / count);
        summary.least = defined.select(heights, INFINITY).minCoeff();
        summary.greatest = defined.select(heights, -INFINITY).maxCoeff();
    } catch (const Error& error) {
        summary.error = error.what();
    }
    return summary;
}

workflow::Json channel_json(const std::string& file, std::size_t index, const io::ChannelInfo& info, const HeightSummary& heights) {
    using workflow::number;
    workflow::Json json{{"file", file}, {"channel", index}, {"format", info.format}, {"name", info.name}, {"shape", info.shape}, {"size", info.size},
                        {"unit", info.unit}, {"is_height", info.is_height}, {"undefined_count", heights.undefined_count}, {"mean", number(heights.mean)},
                        {"standard_deviation", number(heights.standard_deviation)}, {"minimum", number(heights.least)}, {"maximum", number(heights.greatest)}};
    const auto& instrument = info.metadata.instrument;
    json["instrument"] = {{"name", instrument.name}, {"type", instrument.type},
                          {"tip_radius", instrument.tip_radius ? workflow::Json(*instrument.tip_radius) : workflow::Json(nullptr)},
                          {"resolution", instrument.resolution ? workflow::Json(*instrument.resolution) : workflow::Json(nullptr)}};
    json["acquisition_time"] = info.metadata.acquisition_time;
    json["recommended_trend"] = info.recommended_trend ? workflow::Json(topography::name(*info.recommended_trend)) : workflow::Json(nullptr);
    json["missing"] = workflow::Json::array();
    if (info.unit.empty()) json["missing"].push_back("unit");
    if (info.size.empty()) json["missing"].push_back("size");
    if (!heights.error.empty()) json["error"] = heights.error;
    json["alerts"] = workflow::to_json(info.alerts);
    return json;
}

std::string channel_line(const std::string& file, std::size_t index, const io::ChannelInfo& info, const HeightSummary& heights) {
    std::vector<std::string> sizes;
    for (const double size : info.size) sizes.push_back(format_value(size, "m"));
    std::string line = fmt::format("{} [{}] {}: {}, {} points, {}", file, index, info.format, info.name.empty() ? "(no name)" : info.name,
                                   fmt::join(info.shape, " × "), sizes.empty() ? "size missing" : fmt::format("{}", fmt::join(sizes, " × ")));
    if (!info.is_height) return line + ", no heights\n";
    if (!heights.error.empty()) return line + ", unreadable: " + heights.error + "\n";
    line += fmt::format(", heights {} … {}, rms {}, unit in file {}", format_value(heights.least, "m"), format_value(heights.greatest, "m"),
                        format_value(heights.standard_deviation, "m", 5), info.unit.empty() ? "missing" : info.unit);
    if (heights.undefined_count > 0) line += fmt::format(", {} undefined", heights.undefined_count);
    if (!info.metadata.instrument.name.empty()) line += ", " + info.metadata.instrument.name;
    if (!info.metadata.acquisition_time.empty()) line += ", " + info.metadata.acquisition_time;
    return line + "\n";
}

ExitCode run(const Arguments& arguments) {
    if (arguments.files.empty()) throw InvalidArgument("no file; expected at least one");
    workflow::Json channels = workflow::Json::array();
    bool unreadable_member = false;
    const auto code = for_each_item(arguments.files, [&](const std::string& file) {
        const auto found = io::open(file, arguments.file.read_options());
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (arguments.file.channel && *arguments.file.channel != i) continue;
            const auto heights = summarise(found[i]);
            unreadable_member = unreadable_member || !heights.error.empty();
            if (arguments.common.json) {
                channels.push_back(channel_json(file, i, found[i].info, heights));
            } else {
                print(channel_line(file, i, found[i].info, heights));
                show(found[i].info.alerts);
            }
        }
    });
    if (arguments.common.json && code != ExitCode::nothing_done) print_json({{"channels", channels}});
    return code == ExitCode::done && unreadable_member ? ExitCode::some_failed : code;
}

}  // namespace

void add_info(CLI::App& program, Action& action) {
    auto arguments = std::make_shared<Arguments>();
    auto* verb = program.add_subcommand("info", "what files hold: format, channels, shape, size, unit, heights");
    verb->add_option("files", arguments->files, "files or containers");
    arguments->file.add_to(*verb);
    on_named(*verb, action, arguments, explanation, run);
}

}  // namespace setae::cli
