// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jkr/loop_arguments.hpp"
#include "program/command.hpp"
#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/import_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"
#include "setae/tables/clocks.hpp"
#include "setae/tables/column_guess.hpp"
#include "setae/tables/loop_file.hpp"
#include "setae/tables/mapping_folder.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli::jkr_import_command {
namespace {

constexpr const char* explanation =
    "The command writes a table, workbook or force curve as a loop file (docs/reference/loop-format.md).\n"
    "\n"
    "columns      Without --map, columns are guessed from names and units. The guess is printed.\n"
    "             --column overrules the guess. --save-map writes it to a file.\n"
    "expressions  An expression gives a column by its header in lower case, with '_' for other characters.\n"
    "             The beginning of a header is enough. With --mapping, columns have the names of the mapping.\n"
    "signs        force > 0 presses; displacement increases into the contact; contact_radius is 0 out of contact\n"
    "units        SI after import\n"
    "clocks       F = 2 E* a (delta - a^2/(3R)) is valid in any state of the contact\n"
    "             The clock offset of the camera is the one with which the frames fit this equation best.\n"
    "metadata     sphere_radius and other metadata of the loop file need not be given again.\n";

struct Arguments {
    Common common;
    answers::LoopFiles loops;
    std::vector<std::string> entries;
    std::string encoding, separator, decimal, header_end, sheet, save_map, output;
};

/// "name=value". @throws InvalidArgument.
std::pair<std::string, std::string> assignment(const std::string& text, const char* option) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw InvalidArgument(fmt::format("{} {}: expected NAME=VALUE", option, text));
    return {std::string(trimmed(text.substr(0, equals))), std::string(trimmed(text.substr(equals + 1)))};
}

std::map<std::string, std::string> assignments(const std::vector<std::string>& texts, const char* option) {
    std::map<std::string, std::string> all;
    for (const auto& text : texts) all.insert(assignment(text, option));
    return all;
}

tables::TableOptions table_options(const Arguments& arguments) {
    static const std::map<std::string, char> separators{
        {"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"blank", ' '}},
        decimals{{"point", '.'}, {"comma", ','}};
    static const std::map<std::string, bytes::Encoding> encodings{
        {"utf-8", bytes::Encoding::utf8}, {"utf-16", bytes::Encoding::utf16}, {"latin-1", bytes::Encoding::latin1}};
    tables::TableOptions options;
    if (!arguments.encoding.empty()) options.encoding = encodings.at(arguments.encoding);
    if (!arguments.separator.empty()) options.separator = separators.at(arguments.separator);
    if (!arguments.decimal.empty()) options.decimal_point = decimals.at(arguments.decimal);
    if (!arguments.header_end.empty()) options.header_end = arguments.header_end;
    if (!arguments.sheet.empty()) options.sheet = arguments.sheet;
    return options;
}

bool is_foreign_table(const std::string& file) {
    const auto source = bytes::file_source(file);
    return !tables::is_loop_file(source) && !tables::force_curve_format(source);
}

/// Range of each column, with unit and prefix.
std::string summary(const Table& table) {
    std::string text = fmt::format("{} samples\n", table.rows());
    for (const auto& column : table.columns) {
        double smallest = undefined, largest = undefined;
        Index defined = 0;
        for (const double value : column.values) {
            if (std::isnan(value)) continue;
            smallest = defined == 0 ? value : std::min(smallest, value);
            largest = defined == 0 ? value : std::max(largest, value);
            ++defined;
        }
        text += fmt::format("  {:<16} {} … {}{}\n", column.name, format_value(smallest, column.unit),
                            format_value(largest, column.unit),
                            defined == table.rows() ? "" : fmt::format(", {} defined", defined));
    }
    return text;
}

/// The first rows of a loop after import.
std::string first_rows(const Table& table) {
    constexpr Index shown = 5;
    tables::TidyTable rows;
    for (const auto& column : table.columns) rows.columns.push_back(fmt::format("{} [{}]", column.name, column.unit));
    for (Index i = 0; i < std::min(shown, table.rows()); ++i) {
        rows.rows.emplace_back();
        for (const auto& column : table.columns) rows.rows.back().emplace_back(column.values[i]);
    }
    return tables::as_text(rows, 6);
}

std::string output_of(const Arguments& arguments, const std::string& file) {
    namespace fs = std::filesystem;
    if (arguments.output.empty()) return {};
    const bool folder =
        arguments.output.ends_with('/') || fs::is_directory(arguments.output) || arguments.loops.expanded().size() > 1;
    return folder ? (fs::path(arguments.output) / (fs::path(file).stem().string() + ".csv")).string()
                  : arguments.output;
}

/// The mapping for a file: given by the user, or guessed from its columns.
struct FileMapping {
    std::optional<tables::ColumnGuess> guess;
    std::optional<tables::Mapping> mapping;
};

FileMapping file_mapping(const Arguments& arguments, const std::string& file) {
    const auto chosen = arguments.loops.chosen();
    if (const auto mapping = arguments.loops.mapping())
        return {.mapping = tables::with_results(tables::read_mapping(*mapping), chosen)};
    if (!is_foreign_table(file)) return {};
    FileMapping result{.guess = tables::guess_columns(file, table_options(arguments))};
    if (!arguments.common.json) print(tables::describe(*result.guess));
    const auto required =
        arguments.loops.camera.empty() ? tables::LoopColumns::complete : tables::LoopColumns::force_record;
    try {
        result.mapping = tables::mapping_from(*result.guess, chosen, required);
    } catch (const FormatError& error) {
        auto help = tables::fitting_mappings_hint(file, mapping_folder());
        if (!arguments.save_map.empty()) {
            bytes::write_whole_file(arguments.save_map, tables::mapping_template(*result.guess, chosen, required));
            help += fmt::format("; {} written; replace each \"?\" in this file and give the file with --mapping",
                                arguments.save_map);
        }
        if (help.empty()) throw;
        throw InvalidArgument(error.what() + help);
    }
    return result;
}

void import(const Arguments& arguments, const std::string& file, output::Json& list) {
    const auto mapped = file_mapping(arguments, file);
    if (mapped.mapping && !arguments.save_map.empty()) tables::write_mapping(arguments.save_map, *mapped.mapping);
    const auto opened =
        mapped.mapping ? study::open_loop(arguments.loops.source(file), *mapped.mapping) : arguments.loops.open(file);
    auto metadata = tables::loop_metadata(opened.table);
    metadata.emplace("source", std::filesystem::path(file).filename().string());
    for (const auto& [key, value] : assignments(arguments.entries, "--set")) metadata[key] = value;
    const auto output = output_of(arguments, file);
    if (!output.empty()) {
        if (const auto folder = std::filesystem::path(output).parent_path(); !folder.empty())
            std::filesystem::create_directories(folder);
        tables::write_loop(output, opened.table, metadata);
    }
    if (arguments.common.json) {
        list.push_back(output::described(answers::ImportedLoop{
            .file = file,
            .opened = &opened,
            .metadata = metadata,
            .guess = mapped.guess,
            .mapping = mapped.mapping ? std::optional(tables::as_toml(*mapped.mapping)) : std::nullopt,
            .output = output.empty() ? std::nullopt : std::optional(output)}));
        return;
    }
    print(fmt::format("{}: {}{}", file, summary(opened.table), first_rows(opened.table)));
    if (opened.clock)
        print(fmt::format("  camera's clock   + {}, by {}\n", format_uncertain(opened.clock->offset, "s"),
                          opened.clock->method));
    print(output.empty() ? "nothing written; give the loop file with -o LOOP.csv\n"
                         : fmt::format("{} written\n", output));
    show(opened.alerts);
}

ExitCode run(const Arguments& arguments) {
    output::Json list = output::Json::array();
    const auto files = arguments.loops.expanded();
    const auto code = for_each_item(files, [&](const std::string& file) { import(arguments, file, list); });
    if (arguments.common.json && !list.empty()) print_json(files.size() == 1 ? list.front() : list);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    add_loop_options(options, arguments->loops);
    options.add("--encoding", arguments->encoding, "encoding of the text; default: detected")
        .one_of({"utf-8", "utf-16", "latin-1"})
        .in(OptionGroup::advanced);
    options.add("--separator", arguments->separator, "separator of the columns; default: detected")
        .one_of({"tab", "comma", "semicolon", "blank"})
        .in(OptionGroup::advanced);
    options.add("--decimal", arguments->decimal, "decimal sign; default: detected")
        .one_of({"point", "comma"})
        .in(OptionGroup::advanced);
    options.add("--header-end", arguments->header_end, "line after which the numbers begin").in(OptionGroup::advanced);
    options.add("--sheet", arguments->sheet,
                "sheet of a workbook, by name; default: the first with a loop, else the first with a table");
    options.add("--set", arguments->entries,
                "KEY=VALUE that is written into the loop file, such as sphere_radius=\"1.25 mm\" or surface=UNCD");
    options.output("--save-map", arguments->save_map,
                   "file for the mapping, a template for --map; a \"?\" marks missing metadata");
    options.output("-o,--output", arguments->output,
                   "loop file, or folder of loop files; without it nothing is written");
    options.example("setae jkr import force_curve.txt -o loop.csv",
                    "loop file from a table; the columns are guessed and printed");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_import_command
