// SPDX-License-Identifier: GPL-3.0-or-later
#include "draft_text.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "believed.hpp"
#include "setae/bytes/toml_text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/study/instrument_words.hpp"

namespace setae::study {
namespace {

/// A line of a draft with its remark in a column of its own.
std::string remarked(std::string line, const std::string& remark) {
    constexpr std::size_t column = 40;
    if (remark.empty()) return line + "\n";
    line += std::string(column - std::min(column - 1, display_width(line)), ' ');
    return line + "# " + comment_line(remark) + "\n";
}

/// Instrument stated by the file, else by its name.
struct StatedInstrument {
    std::string type, remark;
};

StatedInstrument instrument_of(const DraftMeasurement& measurement) {
    const auto& instrument = measurement.info->metadata.instrument;
    for (const auto& said : {instrument.type, instrument.name})
        if (auto type = instrument_in_name(said); !type.empty())
            return {type, "as the file states: " + (instrument.name.empty() ? instrument.type : instrument.name)};
    for (const auto& name : {measurement.channels, measurement.file})
        if (auto type = instrument_in_name(name); !type.empty()) return {type, "by its name"};
    return {"", instrument.name.empty() ? "" : "; the file states " + instrument.name};
}

/// Questions for a probe that no file states, which limits the short waves.
std::string probe_lines(const std::string& type, const formats::ChannelInfo& info) {
    const auto& instrument = info.metadata.instrument;
    const auto believed = resolution_without_probe(info);
    if (instrument.tip_radius_standard_error) return "";  // the container states it, with its standard error
    if (instrument.tip_radius)
        return draft_line("tip_radius", format_value(*instrument.tip_radius, "m"), "as the file states, without its ±");
    if (instrument.resolution)
        return draft_line("resolution", format_value(*instrument.resolution, "m"), "as the file states");
    if (type == "afm") return draft_question("tip_radius", "such as \"10 ± 3 nm\"; without it " + believed);
    if (type == "stylus") return draft_question("tip_radius", "such as \"5 ± 1 um\"; without it " + believed);
    if (type == "optical")
        return draft_question("resolution", "or numerical_aperture and light_wavelength; without it " + believed);
    return type.empty() ? draft_question("tip_radius", "of a stylus or an AFM; without it " + believed) : "";
}

}  // namespace

std::string comment_line(const std::string& text) { return one_line(text); }

std::string draft_key(const std::string& name) {
    const bool bare = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return c < 0x80 && (std::isalnum(c) != 0 || c == '_' || c == '-');
    });
    return bare ? name : bytes::toml_quoted(name);
}

std::string draft_line(const std::string& key, const std::string& value, const std::string& remark) {
    return remarked(fmt::format("{} = {}", key, bytes::toml_quoted(value)), remark);
}

std::string draft_question(const std::string& key, const std::string& remark) {
    return remarked(fmt::format("# {} = \"?\"", key), remark);
}

std::string draft_heading(const std::string& title) {
    return "# Drafted by `setae study init` from the content of the files. A line with \"?\" asks for what "
           "no file contains: replace the \"?\"\n# by the answer and remove the \"# \" in front. `setae "
           "study FILE --dry-run` lists what is missing;\n# docs/reference/study-keys.md explains every key.\n" +
           draft_line("title", title);
}

std::string draft_rule(const std::string& title) {
    constexpr std::size_t width = 100;
    const auto text = "# ---- " + comment_line(title) + " ";
    return text + std::string(width - std::min(width, display_width(text)), '-') + "\n";
}

std::string measurement_text(const std::string& surface, const DraftMeasurement& measurement) {
    const auto& info = *measurement.info;
    std::string points, size;
    for (const auto n : info.shape) points += fmt::format("{}{}", points.empty() ? "" : " × ", n);
    for (const double length : info.size)
        size += fmt::format("{}{}", size.empty() ? ", " : " × ", format_value(length, "m"));
    auto text = fmt::format("[[surfaces.{}.measurements]]\n", draft_key(surface)) +
                draft_line("file", measurement.file, fmt::format("{} points{}", points, size));
    if (measurement.channel) text += remarked(fmt::format("channel = {}", *measurement.channel), measurement.channels);
    const auto instrument = instrument_of(measurement);
    text += instrument.type.empty() ? draft_question("instrument", "stylus, afm, tem or optical" + instrument.remark)
                                    : draft_line("instrument", instrument.type, instrument.remark);
    text += probe_lines(instrument.type, info);
    if (info.unit.empty()) text += draft_question("unit", "of lengths and heights, such as \"um\"; needed");
    if (info.size.empty())
        text += remarked(info.shape.size() == 2 ? "# size = [\"?\", \"?\"]" : "# size = [\"?\"]",
                         "extent, such as \"5 um\"; needed");
    return text;
}

std::string spectrum_remark(const Table& spectrum) {
    const auto& q = spectrum.at("wavevector");
    const auto shortest = format_value(2.0 * pi / q[q.size() - 1], "m", 3);
    return fmt::format("{} against {}, {}", spectrum.columns[1].name, spectrum.metadata.at("quantity"),
                       q[0] > 0.0 ? fmt::format("waves from {} to {}", shortest, format_value(2.0 * pi / q[0], "m", 3))
                                  : "waves from " + shortest);
}

std::string contour_command(const std::string& picture, bool ask_pixel_size) {
    const auto profile = std::filesystem::path(picture).replace_extension(".csv").generic_string();
    return comment_line(fmt::format("setae contour {} -o {}{}", shell_word(picture), shell_word(profile),
                                    ask_pixel_size ? " --pixel \"?\"" : ""));
}

}  // namespace setae::study
