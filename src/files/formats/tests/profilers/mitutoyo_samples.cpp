// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

std::string text_cell(const char* place, const char* text) {
    return fmt::format(R"(<c r="{}" t="inlineStr"><is><t>{}</t></is></c>)", place, text);
}

std::string sheet(const std::string& rows) {
    return R"(<?xml version="1.0" encoding="UTF-8"?><worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>)" +
           rows + "</sheetData></worksheet>";
}

std::string data() {
    const double heights[] = {1.5, -2.25, 3.0, 4.125, 5.0};
    const char* results[] = {"Ra     3.308  µm      ", "Rku    2.463          ", "Mr1    5.822  %       "};
    std::string rows;
    for (int i = 0; i < 5; ++i)
        rows += fmt::format(R"(<row r="{0}">{1}<c r="E{0}"><v>{2}</v></c><c r="F{0}"><v>{3}</v></c></row>)", i + 1,
                            i < 3 ? text_cell(fmt::format("A{}", i + 1).c_str(), results[i]) : "", 0.0015 * (i + 1),
                            heights[i]);
    return sheet(rows);
}

std::string certificate() {
    return sheet("<row r=\"2\">" + text_cell("E2", "20- Jun -2023") + "</row><row r=\"47\">" +
                 text_cell("B47", "Standard") + text_cell("C47", "ISO 1997") + "</row><row r=\"48\">" +
                 text_cell("D48", "Cut-Off") + text_cell("E48", "2.5mm") + "</row>");
}

}  // namespace

std::vector<FormatSample> mitutoyo_samples() {
    const std::string relations =
        R"(<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)";
    const std::string office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    const std::string type = "application/vnd.openxmlformats-officedocument.spreadsheetml.";
    const auto content = zip_archive(
        {{"[Content_Types].xml",
          R"(<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Override PartName="/xl/workbook.xml" ContentType=")" +
              type + R"(sheet.main+xml"/><Override PartName="/xl/worksheets/sheet1.xml" ContentType=")" + type +
              R"(worksheet+xml"/><Override PartName="/xl/worksheets/sheet2.xml" ContentType=")" + type +
              R"(worksheet+xml"/></Types>)"},
         {"_rels/.rels", relations + R"(<Relationship Id="r1" Type=")" + office +
                             R"(/officeDocument" Target="xl/workbook.xml"/></Relationships>)"},
         {"xl/workbook.xml",
          R"(<?xml version="1.0" encoding="UTF-8"?><workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r=")" +
              office +
              R"("><sheets><sheet name="Certificate" sheetId="1" r:id="a"/><sheet name="DATA" sheetId="2" r:id="b"/></sheets></workbook>)"},
         {"xl/_rels/workbook.xml.rels",
          relations + R"(<Relationship Id="a" Type=")" + office +
              R"(/worksheet" Target="worksheets/sheet1.xml"/><Relationship Id="b" Type=")" + office +
              R"(/worksheet" Target="worksheets/sheet2.xml"/></Relationships>)"},
         {"xl/worksheets/sheet1.xml", certificate()},
         {"xl/worksheets/sheet2.xml", data()}});
    return {{.format = "mitutoyo",
             .name = "scan",
             .content = content,
             .shape = {5},
             .size = {7.5 * units::um},
             .heights = (Array2D(5, 1) << 1.5, -2.25, 3.0, 4.125, 5.0).finished() * units::um}};
}

}  // namespace setae::formats::tests
