// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/format_pages.hpp"

#include <cctype>

#include <fmt/format.h>

#include "program/markdown.hpp"
#include "setae/formats/format.hpp"

namespace setae::cli {
namespace {

constexpr const char* untested =
    "made from the published layout, not tested on a file of an instrument (please send one)";

/// A sentence of the table with capital letter and full stop; names that begin with a small letter are not changed.
std::string sentence(std::string text) {
    if (text.empty()) return text;
    const bool plain_word = text.size() > 1 && std::islower(static_cast<unsigned char>(text[1]));
    if (plain_word || text[1] == ' ') text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
}

std::string section(const char* title, const std::string& text) {
    return text.empty() ? "" : fmt::format("\n## {}\n\n{}\n", title, sentence(text));
}

std::string page(const formats::Format& format) {
    std::string text =
        fmt::format("# {} (`{}`)\n\n{}\n\n", format.name, format.identifier, sentence(format.description));
    text += fmt::format(
        "| | |\n|---|---|\n| usual endings | {} |\n| read | yes, recognised by content, not by name |\n| written | {} |\n| tested on | {} |\n",
        markdown_cell(format.extensions), format.writes() ? "yes" : "no",
        format.tested_on_real_files ? "real files" : untested);
    text += section("Heights", format.heights) + section("Orientation", format.orientation) +
            section("Not read", format.not_read);
    return text + section("Layout", format.reference) + "\n[All formats](README.md)\n";
}

std::string index_page() {
    std::string text =
        "# Formats of topographies\n\n"
        "*Reference · [all documents](../../README.md)*\n\n"
        "Made from the program's own table by `setae formats --documentation docs/reference/formats`: edit the table, not these pages. `setae info FILE`\n"
        "lists the content of a file, and `setae convert` writes it in another format. Heights are in metres and scaled once. Undefined heights are NaN.\n"
        "In h(x, y), y points downwards as Gwyddion shows the file.\n\n"
        "| format | name | usual endings | written | real files |\n|---|---|---|---|---|\n";
    for (const auto& format : formats::formats())
        text += fmt::format("| [{0}]({0}.md) | {1} | {2} | {3} | {4} |\n", format.identifier,
                            markdown_cell(format.name), markdown_cell(format.extensions), format.writes() ? "yes" : "",
                            format.tested_on_real_files ? "yes" : "**no**");
    text += fmt::format(
        "\n**no**: {}.\n"
        "\n## Which channel\n\n"
        "`--channel` and the study key `channel` choose a channel by its number or its name. Numbers are counted from 0 as in `setae info`. The\n"
        "beginning of a name is enough if no other name has the same beginning. Capitals do not matter. `--image` chooses images of micrographs by the same\n"
        "rules. `--curve-number` chooses the curves of a file by their numbers from 0. Without a choice the preferred channel is read, in this order:\n\n"
        "1. a map before a line\n"
        "2. a name of heights (height, topography, topo, elevation, surface, z, h) before other names\n"
        "3. a channel with size and unit before a channel without them\n"
        "4. trace or forward before retrace or backward\n"
        "5. the order of the file\n"
        "\n## Arrays that are not heights\n\n"
        "HDF5, MAT and NPZ files contain arbitrary arrays. An array is offered as heights if its name is a name of heights, if the file states a unit of\n"
        "length for it, if it is a map of floats, or if it is the only line of floats. `setae info --long` lists the other arrays as \"not heights\" with\n"
        "the reason: an index, positions, coordinates of points, a table of a few columns, whole numbers without a unit, a picture or mask of 8 bits,\n"
        "complex numbers, parts of tables of PyTables and pandas. `--channel` with `--size` and `--unit` reads such an array anyway, except complex\n"
        "numbers. A file that another reader recognises and refuses is never read as an array: EMD files, force curves, pictures.\n"
        "\n## Archives\n\n"
        "A ZIP archive of no other format is used as a folder of its members by all commands that accept a folder: `setae info`, `setae study init`,\n"
        "`setae jkr fit`, `setae contour`, recordings. `scans.zip/afm/map.spm` is the file of one member, also in a study. Members that point outside the\n"
        "archive, expand to more than 8 MiB and a hundred times their size, or are archives of this kind themselves are refused.\n"
        "\nOther files: [force curves](../../guides/force-curves.md), [micrographs](../micrograph-formats.md),\n"
        "[loops](../loop-format.md).\n",
        untested);
    return text;
}

}  // namespace

std::map<std::string, std::string> format_pages() {
    std::map<std::string, std::string> pages{{"README.md", index_page()}};
    for (const auto& format : formats::formats()) pages[format.identifier + ".md"] = page(format);
    return pages;
}

}  // namespace setae::cli
