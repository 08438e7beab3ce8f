// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "files/format_pages.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/pages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/format_list.hpp"
#include "setae/formats/format.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/output/field_json.hpp"
#include "setae/tables/force_curve.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli::formats_command {
namespace {

std::string yes(bool value) { return value ? "yes" : "no"; }

template <class Formats>
tables::TidyTable as_table(const std::string& title, const Formats& formats) {
    tables::TidyTable table{title, {"format", "name", "extensions", "tested", "description"}, {}};
    for (const auto& f : formats)
        table.rows.push_back({f.identifier, f.name, f.extensions, yes(f.tested_on_real_files), f.description});
    return table;
}

/// One row per format; descriptions only where all is wanted.
std::string text_of(tables::TidyTable table, bool all) {
    const auto width = output_size().width;
    if (all) return tables::as_text_within(table, width);
    table.columns.pop_back();
    for (auto& row : table.rows) row.pop_back();
    return tables::as_text_within(tables::constants_in_title(table), width);
}

struct Arguments {
    Common common;
    std::string documentation;
};

std::string explanation() {
    std::string text;
    const auto add = [&text](const auto& formats) {
        for (const auto& f : formats) text += f.identifier + ": " + f.description + " [" + f.reference + "]\n";
    };
    add(formats::formats());
    add(tables::force_curve_formats());
    add(imaging::micrograph_formats());
    return text;
}

/// Formats of topographies; formats that are not tested on an instrument file are marked.
tables::TidyTable topographies_table() {
    tables::TidyTable table{
        "topographies", {"format", "name", "extensions", "reads", "writes", "tested", "description"}, {}};
    for (const auto& f : formats::formats())
        table.rows.push_back({f.identifier, f.name, f.extensions, "yes", yes(f.writes()),
                              f.tested_on_real_files ? "yes" : "NO", f.description});
    return table;
}

ExitCode run(const Arguments& arguments) {
    if (!arguments.documentation.empty()) {
        write_pages(arguments.documentation, format_pages());
        return ExitCode::done;
    }
    if (arguments.common.json) {
        print_json(output::described(answers::FormatList{}));
        return ExitCode::done;
    }
    const auto curves = as_table("force curves, for setae jkr", tables::force_curve_formats());
    const auto micrographs = as_table("micrographs, for setae contour", imaging::micrograph_formats());
    const bool all = arguments.common.all;
    print(
        text_of(topographies_table(), all) +
        "\ntested NO: made from the published layout, not tested on a file of an instrument (please send one)\n\n" +
        text_of(curves, all) + "\n" + text_of(micrographs, all) +
        "\nloops of force, displacement and contact radius: any table with units, workbooks (.xlsx), docs/reference/loop-format.md\n" +
        (all ? "" : "--all prints the descriptions\n"));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add("--documentation", arguments->documentation,
             "folder for the documentation pages: one page per format, and their list")
        .in(OptionGroup::advanced);
    options.example("setae formats", "formats that are read or written, with their endings");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::formats_command
