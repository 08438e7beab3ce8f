// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/file_options.hpp"
#include "files/listed_file.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"

namespace setae::cli::info_command {
namespace {

constexpr const char* explanation =
    "heights in metres, scaled once and not levelled; NaN undefined; h(x, y) with the first index x, y downwards as in the file's picture\n"
    "heights     least and greatest; rms (--long) = sqrt(<(h - <h>)^2>) over defined heights\n"
    "size        number of points times pixel size; of a traced profile x_last - x_first\n"
    "undefined   share of points without height\n"
    "missing     what the file does not say: size and unit, without which heights cannot be read, instrument, date\n"
    "not read    heights are read of files up to 64 MB; of larger ones with --heights, with --no-heights of none: only headers are read then\n"
    "units       of a spectrum's table: of its first column and of the density; (assumed) where the header states none\n"
    "folders     are looked through, hidden files and linked folders left out; what cannot be read comes last\n";

/// Larger files are not read without being asked to.
constexpr std::uint64_t largest_read = 64'000'000;

struct Arguments {
    Common common;
    FileOptions file;
    std::vector<std::string> files;
    bool heights = false, no_heights = false, all = false;
};

/// What the options say of files that leave something open.
study::FileQuestions questions_of(const FileOptions& options) {
    if (options.as != "spectrum") return {.heights = options.read_options()};
    study::FileQuestions questions{.heights = {}, .is_spectrum = true};
    if (!options.unit.empty()) questions.spectrum = tables::SpectrumUnits::from_text(options.unit);
    return questions;
}

ListedFile listed(const std::string& file, const Arguments& arguments) {
    ListedFile listed{.content = study::file_content(file, questions_of(arguments.file)),
                      .channels = {},
                      .bytes = bytes::file_source(file).size};
    const bool large = listed.bytes > largest_read;
    const bool wanted = !arguments.no_heights && (arguments.heights || !large);
    listed.too_large = large && !arguments.heights && !arguments.no_heights;
    const auto& channels = listed.content.channels;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (arguments.file.channel && *arguments.file.channel != i) continue;
        const auto& info = channels[i].info;
        listed.channels.push_back({i, info, wanted && can_be_read(info) ? summarise(channels[i]) : HeightSummary{}});
    }
    return listed;
}

/// What was found, and what is wrong with it.
struct Inventory {
    std::vector<ListedFile> files;
    std::vector<study::UnreadablePath> failed;  ///< files that nothing can be said of
    bool any_bad_channel = false;
};

Inventory inventory_of(const Arguments& arguments) {
    const auto found = study::found_files(arguments.files);
    Inventory inventory{.files = {}, .failed = found.unreadable};
    for (const auto& file : found.files) {
        try {
            inventory.files.push_back(listed(file, arguments));
        } catch (const std::exception& error) {
            inventory.failed.push_back({file, reason_of(error, file)});
        }
    }
    return inventory;
}

/// Alerts of what was read, then reasons of what was not. A member of a container that cannot be opened is a channel of
/// no format; an alert says why.
void show_remarks(Inventory& inventory, bool json) {
    for (const auto& file : inventory.files) {
        if (file.content.picture && !json) show(file.content.picture->alerts);
        for (const auto& channel : file.channels)
            if (!json || channel.info.format.empty()) show(channel.info.alerts);
    }
    for (const auto& file : inventory.files) {
        for (const auto& channel : file.channels) {
            if (!channel.heights.error.empty()) complain(channel.heights.error);
            inventory.any_bad_channel |= channel.info.format.empty() || !channel.heights.error.empty();
        }
    }
    for (const auto& failed : inventory.failed) complain(failed.reason);
}

output::Json json_of(const Inventory& inventory) {
    output::Json json{
        {"channels", output::Json::array()}, {"files", output::Json::array()}, {"failed", output::Json::array()}};
    for (const auto& file : inventory.files) {
        json["files"].push_back(file_json(file));
        for (const auto& channel : file.channels) json["channels"].push_back(channel_json(file.content.file, channel));
    }
    for (const auto& failed : inventory.failed)
        json["failed"].push_back({{"file", failed.path}, {"error", failed.reason}});
    return json;
}

ExitCode run(const Arguments& arguments) {
    if (arguments.files.empty()) throw InvalidArgument("no file; expected at least one file or folder");
    if (arguments.heights && arguments.no_heights)
        throw InvalidArgument("--heights and --no-heights contradict each other; expected one of them");
    auto inventory = inventory_of(arguments);
    if (!inventory.files.empty() && arguments.common.json) print_json(json_of(inventory));
    if (!arguments.common.json)
        print(file_tables(inventory.files, arguments.all ? Detail::all : Detail::usual, output_size().width));
    show_remarks(inventory, arguments.common.json);
    if (inventory.files.empty()) return ExitCode::nothing_done;
    return inventory.failed.empty() && !inventory.any_bad_channel ? ExitCode::done : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("files", arguments->files, "files of any kind that setae reads, or folders of them").of_inputs();
    options.flag("--long", arguments->all, "all that is known of each, orientation of maps, date and rms height too");
    options.flag("--heights", arguments->heights, "read heights of files above 64 MB too");
    options.flag("--no-heights", arguments->no_heights, "read headers alone");
    arguments->file.add_to(options);
    options.example("setae info afm.ibw scan.csv", "channels, size, unit and heights of two files");
    options.example("setae info folder/*.spm --json", "the same for a script");
    options.example("setae info scan.txt --unit um", "a file that does not state its unit");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::info_command
