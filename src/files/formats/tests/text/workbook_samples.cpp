// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

const double heights_of_line[] = {1.5, -2.25, 3.0, 4.125, 5.0};

/// The minimum for readers of OpenDocument: one table of two columns below their names.
std::string ods_file() {
    std::string rows =
        R"(<table:table-row><table:table-cell office:value-type="string"><text:p>x [um]</text:p></table:table-cell>)"
        R"(<table:table-cell office:value-type="string"><text:p>z [nm]</text:p></table:table-cell></table:table-row>)";
    for (int i = 0; i < 5; ++i)
        rows += fmt::format(
            R"(<table:table-row><table:table-cell office:value-type="float" office:value="{0}"><text:p>{0}</text:p></table:table-cell>)"
            R"(<table:table-cell office:value-type="float" office:value="{1}"/>)"
            R"(<table:table-cell table:number-columns-repeated="1022"/></table:table-row>)",
            0.5 * i, heights_of_line[i]);
    rows +=
        R"(<table:table-row table:number-rows-repeated="1048570"><table:table-cell table:number-columns-repeated="1024"/></table:table-row>)";
    return zip_archive(
        {{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"},
         {"content.xml",
          R"(<?xml version="1.0" encoding="UTF-8"?><office:document-content xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0")"
          R"( xmlns:table="urn:oasis:names:tc:opendocument:xmlns:table:1.0" xmlns:text="urn:oasis:names:tc:opendocument:xmlns:text:1.0">)"
          R"(<office:body><office:spreadsheet><table:table table:name="Line">)" +
              rows + "</table:table></office:spreadsheet></office:body></office:document-content>"}});
}

/// Shared strings, numbers and the result of a formula, below and to the right of empty cells.
std::string xlsx_file() {
    std::string rows = R"(<row r="3"><c r="C3" t="s"><v>0</v></c><c r="D3" t="s"><v>1</v></c></row>)";
    for (int i = 0; i < 5; ++i)
        rows += fmt::format(R"(<row r="{0}"><c r="C{0}"><v>{1}</v></c><c r="D{0}"><f>B{0}</f><v>{2}</v></c></row>)",
                            i + 4, 0.5 * i, heights_of_line[i]);
    const std::string relation = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    return zip_archive(
        {{"xl/workbook.xml",
          R"(<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r=")" + relation +
              R"("><sheets><sheet name="Line" sheetId="1" r:id="a"/></sheets></workbook>)"},
         {"xl/_rels/workbook.xml.rels",
          R"(<Relationships><Relationship Id="a" Target="worksheets/sheet1.xml"/></Relationships>)"},
         {"xl/sharedStrings.xml", "<sst><si><t>x [um]</t></si><si><r><t>z </t></r><r><t>[nm]</t></r></si></sst>"},
         {"xl/worksheets/sheet1.xml", "<worksheet><sheetData>" + rows + "</sheetData></worksheet>"}});
}

}  // namespace

std::vector<FormatSample> workbook_samples() {
    Array2D heights(5, 1);
    for (Index i = 0; i < 5; ++i) heights(i, 0) = heights_of_line[i] * units::nm;
    const auto sample = [&](const char* name, const std::string& content) {
        return FormatSample{
            .format = "workbook", .name = name, .content = content, .shape = {5}, .size = {2.5e-6}, .heights = heights};
    };
    return {sample("Office Open XML", xlsx_file()), sample("OpenDocument", ods_file())};
}

}  // namespace setae::formats::tests
