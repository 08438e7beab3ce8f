// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/listed_file.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/contents_fields.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/core/words.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::info_command {
namespace {

constexpr const char* explanation =
    "The command lists the content of files. Heights are in metres, scaled once and not levelled.\n"
    "\n"
    "h(x, y)    the first index is x; y points downwards as in the picture of the file; NaN is undefined\n"
    "heights    smallest and largest; with --long also rms = sqrt(<(h - <h>)^2>) over the defined heights\n"
    "size       number of points times pixel size; of a traced profile x_last - x_first\n"
    "undefined  share of points without height\n"
    "missing    metadata that the file does not contain: size, unit, instrument, date\n"
    "           Without size and unit heights cannot be read.\n"
    "not read   Heights of files above 64 MB are read only with --heights. With --no-heights only headers are read.\n"
    "units      of the table of a spectrum: of the first column and of the density; (assumed) if the header has none\n"
    "folders    All files of a folder are listed, except hidden files and linked folders. Unreadable files come last.\n";

struct Arguments {
    Common common;
    answers::FileRequest file;
    answers::ContentsRequest request;  ///< without the metadata given by `file`
    bool all = false;
};

/// Prints the warnings of files that were read, then the errors of the others; true if a channel is unreadable. A
/// member of a container that cannot be opened is a channel without format; a warning contains the reason.
bool show_warnings(const answers::Contents& contents, bool json) {
    bool any_bad_channel = false;
    std::vector<Alert> shown;
    for (const auto& file : contents.files) {
        if (file.content.picture && !json) {
            const auto& alerts = file.content.picture->alerts;
            shown.insert(shown.end(), alerts.begin(), alerts.end());
        }
        for (const auto& channel : file.channels)  // channels of one table have the same warnings
            for (const auto& alert : channel.info.alerts) {
                const bool known = std::find(shown.begin(), shown.end(), alert) != shown.end();
                if (!known && (!json || channel.info.format.empty())) shown.push_back(alert);
            }
    }
    show(shown);
    for (const auto& file : contents.files) {
        for (const auto& channel : file.channels) {
            if (!channel.heights.error.empty()) print_message(channel.heights.error);
            any_bad_channel |= channel.info.format.empty() || !channel.heights.error.empty();
        }
    }
    for (const auto& failed : contents.failed) print_message(failed.reason);
    return any_bad_channel;
}

ExitCode run(const Arguments& arguments) {
    auto request = arguments.request;
    request.questions = arguments.file.questions();
    request.channel = arguments.file.channel;
    const auto contents = answers::contents(request);
    if (!contents.files.empty() && arguments.common.json) print_json(output::described(contents));
    if (!arguments.common.json)
        print(file_tables(contents.files, arguments.all ? Detail::all : Detail::usual, output_size().width));
    if (!arguments.common.json && !contents.own.empty())
        print(fmt::format("\n{} skipped: figures, tables and reports written by setae\n",
                          counted(contents.own.size(), "file", "files")));
    const bool any_bad_channel = show_warnings(contents, arguments.common.json);
    if (contents.files.empty()) return ExitCode::nothing_done;
    return contents.failed.empty() && !any_bad_channel ? ExitCode::done : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("files", arguments->request.paths, "files of any kind that setae reads, or folders of them")
        .of_inputs();
    options.flag("--long", arguments->all, "all metadata, with orientation of maps, date and rms height")
        .in(OptionGroup::output);
    options.ask(arguments->request);
    options.ask(arguments->file, OptionGroup::height_files);
    options.example("setae info afm.ibw scan.csv", "channels, size, unit and heights of two files");
    options.example("setae info folder/*.spm --json", "content of all files as JSON");
    options.example("setae info scan.txt --unit um", "file without unit");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::info_command
