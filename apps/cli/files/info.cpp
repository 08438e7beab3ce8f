// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/channel_lines.hpp"
#include "files/file_options.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::cli::info_command {
namespace {

constexpr const char* explanation =
    "heights in metres, scaled once and not levelled; NaN undefined; h(x, y) with the first index x, y downwards as in the file's picture\n"
    "mean, rms   over defined heights; rms = sqrt(<(h - <h>)^2>)\n"
    "size        number of points times pixel size; of a traced profile x_last - x_first\n"
    "undefined   share of points without height\n"
    "MISSING     what the file does not say: size and unit, without which heights cannot be read, instrument and date\n"
    "heights     are read of files up to 64 MB; of larger ones with --heights, with --no-heights of none: only headers are read then\n";

/// Larger files are not read without being asked to.
constexpr std::uint64_t largest_read = 64'000'000;

struct Arguments {
    Common common;
    FileOptions file;
    std::vector<std::string> files;
    bool heights = false, no_heights = false;
};

/// What the heights of a channel say, or why they could not be read.
struct HeightSummary {
    bool read = false;
    Index undefined_count = 0, points = 0;
    double mean = undefined, standard_deviation = undefined, least = undefined, greatest = undefined;
    std::string error;

    [[nodiscard]] double undefined_share() const {
        return read ? static_cast<double>(undefined_count) / static_cast<double>(points) : undefined;
    }
};

bool is_missing(const formats::ChannelInfo& info, const std::string& what) {
    for (const auto& name : formats::missing(info))
        if (name == what) return true;
    return false;
}

bool can_be_read(const formats::ChannelInfo& info) {
    return info.is_height && !is_missing(info, "size") && !is_missing(info, "unit");
}

/// A member of a container that cannot be opened is a channel of no format; an alert says why.
bool is_bad_member(const formats::ChannelInfo& info) { return info.format.empty(); }

HeightSummary summary_of(const Eigen::Ref<const Array1D>& heights) {
    HeightSummary summary{.read = true, .undefined_count = heights.isNaN().count(), .points = heights.size()};
    const auto count = static_cast<double>(summary.points - summary.undefined_count);
    const double offset = summary.mean = heights.isNaN().select(0.0, heights).sum() / count;
    summary.standard_deviation = std::sqrt(heights.isNaN().select(0.0, heights - offset).square().sum() / count);
    summary.least = heights.isNaN().select(INFINITY, heights).minCoeff();
    summary.greatest = heights.isNaN().select(-INFINITY, heights).maxCoeff();
    return summary;
}

HeightSummary summarise(const formats::Channel& channel) {
    try {
        const auto measurement = channel.read();
        return std::visit(
            [](const auto& m) { return summary_of(Eigen::Map<const Array1D>(m.heights.data(), m.heights.size())); },
            measurement);
    } catch (const std::exception& error) {
        return {.error = reason_of(error)};
    }
}

output::Json optional_number(const std::optional<double>& value) {
    return value ? output::Json(*value) : output::Json(nullptr);
}

output::Json channel_json(const std::string& file, std::size_t index, const formats::ChannelInfo& info,
                          const HeightSummary& heights) {
    using output::number;
    output::Json json{{"file", file},
                      {"channel", index},
                      {"format", info.format},
                      {"name", info.name},
                      {"shape", info.shape},
                      {"size", info.size},
                      {"unit", info.unit},
                      {"orientation", info.orientation},
                      {"is_height", info.is_height},
                      {"heights_read", heights.read},
                      {"undefined_count", heights.read ? output::Json(heights.undefined_count) : output::Json(nullptr)},
                      {"undefined_share", number(heights.undefined_share())},
                      {"mean", number(heights.mean)},
                      {"standard_deviation", number(heights.standard_deviation)},
                      {"minimum", number(heights.least)},
                      {"maximum", number(heights.greatest)}};
    const auto& instrument = info.metadata.instrument;
    json["instrument"] = {{"name", instrument.name},
                          {"type", instrument.type},
                          {"tip_radius", optional_number(instrument.tip_radius)},
                          {"resolution", optional_number(instrument.resolution)}};
    json["acquisition_time"] = info.metadata.acquisition_time;
    json["recommended_trend"] =
        info.recommended_trend ? output::Json(topography::name(*info.recommended_trend)) : output::Json(nullptr);
    json["missing"] = formats::missing(info);
    if (!heights.error.empty()) json["error"] = heights.error;
    json["alerts"] = output::to_json(info.alerts);
    return json;
}

std::string bytes_for_readers(std::uint64_t bytes) {
    const auto value = static_cast<double>(bytes);
    return bytes >= 1'000'000'000 ? fmt::format("{:.1f} GB", 1e-9 * value) : fmt::format("{:.0f} MB", 1e-6 * value);
}

std::string heights_words(const formats::ChannelInfo& info, const HeightSummary& heights, std::uint64_t bytes) {
    if (is_bad_member(info)) return {};
    if (!heights.error.empty()) return ", unreadable: " + heights.error;
    if (!info.is_height) return ", no heights";
    if (heights.read)
        return fmt::format(
            ", heights {} … {}, rms {}{}", format_value(heights.least, "m"), format_value(heights.greatest, "m"),
            format_value(heights.standard_deviation, "m", 5),
            heights.undefined_count > 0 ? fmt::format(", {} undefined", percent(heights.undefined_share())) : "");
    if (!can_be_read(info)) return {};
    return bytes > largest_read ? fmt::format(", heights not read: {}, --heights reads them", bytes_for_readers(bytes))
                                : ", heights not read";
}

class Lister {
public:
    explicit Lister(const Arguments& arguments) : arguments_(arguments) {}

    void add(const std::string& file) {
        const auto bytes = bytes::file_source(file).size;
        const auto found = formats::open(file, arguments_.file.read_options());
        const bool wanted = !arguments_.no_heights && (arguments_.heights || bytes <= largest_read);
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (arguments_.file.channel && *arguments_.file.channel != i) continue;
            const auto& info = found[i].info;
            const auto heights = wanted && can_be_read(info) ? summarise(found[i]) : HeightSummary{};
            note_failure(info, heights);
            if (arguments_.common.json) {
                channels_.push_back(channel_json(file, i, info, heights));
                continue;
            }
            print(fmt::format("{} [{}] {}{}{}\n", file, i, channel_line(info), heights_words(info, heights, bytes),
                              channel_remarks(info)));
            show(info.alerts);
        }
    }

    [[nodiscard]] const output::Json& channels() const { return channels_; }
    [[nodiscard]] bool any_unreadable() const { return unreadable_; }

private:
    /// The reason goes to standard error whatever form the data have.
    void note_failure(const formats::ChannelInfo& info, const HeightSummary& heights) {
        if (!heights.error.empty()) complain(heights.error);
        if (is_bad_member(info) && arguments_.common.json) show(info.alerts);
        unreadable_ = unreadable_ || is_bad_member(info) || !heights.error.empty();
    }

    const Arguments& arguments_;
    output::Json channels_ = output::Json::array();
    bool unreadable_ = false;
};

ExitCode run(const Arguments& arguments) {
    if (arguments.files.empty()) throw InvalidArgument("no file; expected at least one");
    if (arguments.heights && arguments.no_heights)
        throw InvalidArgument("--heights and --no-heights contradict each other; expected one of them");
    Lister lister(arguments);
    const auto code = for_each_item(arguments.files, [&](const std::string& file) { lister.add(file); });
    if (arguments.common.json && code != ExitCode::nothing_done) print_json({{"channels", lister.channels()}});
    return code == ExitCode::done && lister.any_unreadable() ? ExitCode::some_failed : code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("files", arguments->files, "files or containers").of_inputs();
    options.flag("--heights", arguments->heights, "read heights of files above 64 MB too");
    options.flag("--no-heights", arguments->no_heights, "read headers alone");
    arguments->file.add_to(options);
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::info_command
