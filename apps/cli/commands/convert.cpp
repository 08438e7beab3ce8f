// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/io/npy.hpp"
#include "setae/io/table_file.hpp"
#include "setae/io/whole_file.hpp"
#include "verbs.hpp"

namespace setae::cli {
namespace {

constexpr const char* explanation =
    ".npy  heights [m], float64, C order, shape (nx, ny) or (n); NaN undefined\n"
    ".csv  a map: one line for each x, no header; a line: columns x [m], h [m]\n";

struct Arguments {
    Common common;
    FileOptions file;
    std::string input;
    std::string output;
};

Array1D positions(const topography::LineScan& scan) {
    return scan.pixel_size() * Array1D::LinSpaced(scan.heights.size(), 0.0, static_cast<double>(scan.heights.size() - 1));
}

void write_line(const std::string& path, const Array1D& x, const Array1D& h) { io::write_csv(path, {{{"x", "m", x}, {"h", "m", h}}, {}}); }

/// A map as a matrix without header: one line for each x, NaN spelled out, since an empty cell ends some readers.
void write_matrix(const std::string& path, const Array2D& heights) {
    std::string text;
    for (Index i = 0; i < heights.rows(); ++i)
        for (Index j = 0; j < heights.cols(); ++j) fmt::format_to(std::back_inserter(text), "{}{}", heights(i, j), j + 1 < heights.cols() ? ',' : '\n');
    io::write_whole_file(path, text);
}

struct CsvWriter {
    std::string path;
    void operator()(const topography::HeightMap& map) const { write_matrix(path, map.heights); }
    void operator()(const topography::LineScan& scan) const { write_line(path, positions(scan), scan.heights); }
    void operator()(const topography::Profile& profile) const { write_line(path, profile.positions, profile.heights); }
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
    if (arguments.input.empty() || arguments.output.empty()) throw InvalidArgument("expected an input file and OUT.npy or OUT.csv");
    const auto channels = io::open(arguments.input, arguments.file.read_options());
    const auto& channel = channels[chosen_channel(arguments, channels)];
    const auto measurement = channel.read();
    if (arguments.output.ends_with(".npy"))
        std::visit([&](const auto& m) { io::write_npy(arguments.output, m.heights); }, measurement);
    else if (arguments.output.ends_with(".csv"))
        std::visit(CsvWriter{arguments.output}, measurement);
    else
        throw InvalidArgument(fmt::format("{}: cannot tell the format from the name; expected an ending .npy or .csv", arguments.output));
    show(channel.info.alerts);
    if (arguments.common.json) print_json({{"input", arguments.input}, {"output", arguments.output}, {"channel", channel.info.name}, {"unit", "m"}});
    return ExitCode::done;
}

}  // namespace

void add_convert(CLI::App& program, Action& action) {
    auto arguments = std::make_shared<Arguments>();
    auto* verb = program.add_subcommand("convert", "write the heights of a file in metres as .npy or .csv, first index x");
    verb->add_option("input", arguments->input, "file");
    verb->add_option("output", arguments->output, "OUT.npy or OUT.csv");
    arguments->file.add_to(*verb);
    on_named(*verb, action, arguments, explanation, run);
}

}  // namespace setae::cli
