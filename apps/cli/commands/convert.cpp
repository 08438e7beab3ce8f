// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "heights_output.hpp"
#include "setae/core/errors.hpp"
#include "verbs.hpp"

namespace setae::cli {
namespace {

struct Arguments {
    Common common;
    FileOptions file;
    std::string input;
    std::string output;
};

/// The first channel of heights, unless one is named.
std::size_t chosen_channel(const Arguments& arguments, const std::vector<io::Channel>& channels) {
    if (arguments.file.channel) {
        if (*arguments.file.channel < channels.size()) return *arguments.file.channel;
        throw InvalidArgument(fmt::format("{}: no channel {}, it has {}", arguments.input, *arguments.file.channel, channels.size()));
    }
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (channels[i].info.is_height) return i;
    throw InvalidArgument(fmt::format("{}: none of its {} channels holds heights", arguments.input, channels.size()));
}

ExitCode run(const Arguments& arguments) {
    if (arguments.input.empty() || arguments.output.empty()) throw InvalidArgument("expected an input file and OUT.nc, OUT.npy or OUT.csv");
    const auto channels = io::open(arguments.input, arguments.file.read_options());
    const auto& channel = channels[chosen_channel(arguments, channels)];
    write_heights(arguments.output, channel.read());
    show(channel.info.alerts);
    if (arguments.common.json) print_json({{"input", arguments.input}, {"output", arguments.output}, {"channel", channel.info.name}, {"unit", "m"}});
    return ExitCode::done;
}

}  // namespace

void add_convert(CLI::App& program, Action& action) {
    auto arguments = std::make_shared<Arguments>();
    auto* verb = program.add_subcommand("convert", "write the heights of a file in metres as .nc, .npy or .csv, first index x");
    verb->add_option("input", arguments->input, "file");
    verb->add_option("output", arguments->output, "OUT.nc, OUT.npy or OUT.csv");
    arguments->file.add_to(*verb);
    on_named(*verb, action, arguments, heights_output_explanation, run);
}

}  // namespace setae::cli
