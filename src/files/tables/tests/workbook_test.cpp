// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "compound_file.hpp"
#include "import_samples.hpp"
#include "setae/tables/spreadsheet.hpp"
#include "setae/tables/workbook.hpp"

using namespace setae::tests;

namespace setae::tables::tests::workbook_test {
namespace {

bytes::Source book(const std::vector<std::pair<std::string, std::string>>& sheets, const std::string& styles = {}) {
    const std::string relation = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    std::string names, relations;
    std::vector<std::pair<std::string, std::string>> members;
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        names += fmt::format(R"(<sheet name="{}" sheetId="{}" r:id="r{}"/>)", sheets[k].first, k + 1, k);
        relations += fmt::format(R"(<Relationship Id="r{0}" Target="worksheets/sheet{0}.xml"/>)", k);
        members.emplace_back(fmt::format("xl/worksheets/sheet{}.xml", k),
                             "<worksheet><sheetData>" + sheets[k].second + "</sheetData></worksheet>");
    }
    members.emplace_back("xl/workbook.xml",
                         "<workbook xmlns:r=\"" + relation + "\"><sheets>" + names + "</sheets></workbook>");
    members.emplace_back("xl/_rels/workbook.xml.rels", "<Relationships>" + relations + "</Relationships>");
    if (!styles.empty()) members.emplace_back("xl/styles.xml", styles);
    return bytes::memory_source("b.xlsx", zip_archive(members));
}

/// Rows of cells in sequence, as in XML.
std::string rows(const std::vector<std::vector<std::string>>& cells) {
    std::string text;
    for (const auto& row : cells) {
        text += "<row>";
        for (const auto& cell : row) text += cell;
        text += "</row>";
    }
    return text;
}

std::string number(double value) { return fmt::format("<c><v>{}</v></c>", value); }
std::string words(const std::string& text) { return "<c t=\"inlineStr\"><is><t>" + text + "</t></is></c>"; }

std::string loop_sheet() {
    return rows({{words("Time"), words("Load"), words("Displacement")},
                 {words("s"), words("mN"), words("um")},
                 {number(0), number(1), number(2)},
                 {number(1), number(3), number(4)},
                 {number(2), number(2), number(3)}});
}

std::string summary_sheet() {
    return rows({{words("Test"), words("Mean")}, {number(1), number(5)}, {number(2), number(6)}});
}

TEST(Workbook, PrefersTheSheetOfALoop) {
    const auto source = book({{"Summary", summary_sheet()}, {"Test 1", loop_sheet()}, {"Test 2", loop_sheet()}});
    const auto table = read_spreadsheet(source);
    EXPECT_EQ(table.metadata.at("sheet"), "Test 1");
    EXPECT_EQ(table.metadata.at("other_sheets"), "Summary, Test 2");
    EXPECT_EQ(table.columns[1].unit, "mN");
    EXPECT_EQ(read_spreadsheet(source, "summary").columns[1].name, "Mean");
    EXPECT_TRUE(holds(message_of([&] { (void)read_spreadsheet(source, "nothing"); }),
                      "no sheet 'nothing'; the workbook has 'Summary', 'Test 1', 'Test 2'"));
}

TEST(Workbook, HiddenSheetsComeLast) {
    const auto text = [](const char* state) {
        return fmt::format(
            R"(<workbook xmlns:r="r"><sheets><sheet name="old" r:id="r0"{}/><sheet name="new" r:id="r1"/></sheets></workbook>)",
            state);
    };
    const auto first = [&](const char* state) {
        const auto source = bytes::memory_source(
            "b.xlsx",
            zip_archive(
                {{"xl/worksheets/sheet0.xml", "<worksheet><sheetData>" + summary_sheet() + "</sheetData></worksheet>"},
                 {"xl/worksheets/sheet1.xml", "<worksheet><sheetData>" + summary_sheet() + "</sheetData></worksheet>"},
                 {"xl/workbook.xml", text(state)},
                 {"xl/_rels/workbook.xml.rels",
                  R"(<Relationships><Relationship Id="r0" Target="worksheets/sheet0.xml"/><Relationship Id="r1" Target="worksheets/sheet1.xml"/></Relationships>)"}}));
        return spreadsheet_texts(source).at(0).sheet;
    };
    EXPECT_EQ(first(""), "old");
    EXPECT_EQ(first(R"( state="visible")"), "old");
    EXPECT_EQ(first(R"( state="hidden")"), "new");
    EXPECT_EQ(first(R"( state="veryHidden")"), "new");
}

TEST(Workbook, IgnoresSheetsWithoutATable) {
    const auto broken = rows({{number(1), number(2)}, {number(3), number(4)}, {words("Mean"), number(3)}});
    EXPECT_EQ(read_spreadsheet(book({{"Summary", broken}, {"Test", loop_sheet()}})).metadata.at("sheet"), "Test");
}

TEST(Workbook, ReadsDecimalCommasInTextCells) {
    const auto decided = book(
        {{"S",
          rows({{words("x [um]"), words("z [nm]")}, {words("0,5"), words("1,250")}, {words("1,0"), words("2,5")}})}});
    EXPECT_DOUBLE_EQ(read_spreadsheet(decided).columns[1].values[0], 1.25);
    EXPECT_DOUBLE_EQ(read_spreadsheet(decided).columns[0].values[1], 1.0);
    const auto open =
        book({{"S", rows({{words("x"), words("z")}, {number(1), words("1,250")}, {number(2), words("2,500")}})}});
    EXPECT_FALSE(read_spreadsheet(open).columns[1].text.empty()) << "thousands or decimals: not decided";
}

TEST(Workbook, DatesAreNotNumbers) {
    const std::string styles =
        R"(<styleSheet><numFmts><numFmt numFmtId="164" formatCode="yyyy\-mm\-dd hh:mm"/><numFmt numFmtId="165" formatCode="0.00 &quot;days&quot;"/></numFmts>)"
        R"(<cellXfs><xf numFmtId="0"/><xf numFmtId="164"/><xf numFmtId="14"/><xf numFmtId="165"/></cellXfs></styleSheet>)";
    const auto dated = [](double days, int style) { return fmt::format(R"(<c s="{}"><v>{}</v></c>)", style, days); };
    const Workbook workbook(
        book({{"S", rows({{dated(46027.5, 1), dated(46027.0, 2), dated(1.5, 3), dated(0.25, 1)}})}}, styles));
    const auto cells = workbook.rows(workbook.sheets().front()).at(0);
    EXPECT_EQ(cells.at(0), "2026-01-05 12:00:00");
    EXPECT_EQ(cells.at(1), "2026-01-05");
    EXPECT_EQ(cells.at(2), "1.5");
    EXPECT_EQ(cells.at(3), "06:00:00");
}

TEST(Workbook, FormulasWithoutResultsAreRefused) {
    const std::string formula = "<c><f>A1*2</f></c>";
    const auto message = message_of([&] {
        (void)read_spreadsheet(
            book({{"S", rows({{words("x"), words("z")}, {number(1), formula}, {number(2), formula}})}}));
    });
    EXPECT_TRUE(holds(message, "2 formulas without stored results, the first in cell B2")) << message;
}

TEST(Workbook, SheetsAsTextHoldTheirColumnsOfNumbers) {
    const auto texts =
        spreadsheet_texts(book({{"Notes", rows({{words("by me")}})},
                                {"Line", rows({{words("made with"), words("a stylus")},
                                               {words("")},
                                               {words(""), words("x [um]"), words("who"), words("z [nm]")},
                                               {number(0), number(0.5), words("me"), number(3)},
                                               {number(1), number(1.0), words("me"), number(4)}})}}));
    ASSERT_EQ(texts.size(), 2u);
    EXPECT_TRUE(holds(texts[0].problem, "sheet 'Notes' does not have two rows of numbers"));
    EXPECT_EQ(texts[1].text, "made with\ta stylus\nindex\tx [um]\tz [nm]\n0\t0.5\t3\n1\t1\t4\n");
}

TEST(Workbook, OpenDocumentRepeatsCellsAndRowsWithinTheSheet) {
    const auto ods = [](const std::string& rows_of_table) {
        return bytes::memory_source(
            "b.ods",
            zip_archive({{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"},
                         {"content.xml",
                          "<o:document-content xmlns:o='o' xmlns:t='t'><o:body><o:spreadsheet><t:table t:name='S'>" +
                              rows_of_table + "</t:table></o:spreadsheet></o:body></o:document-content>"}}));
    };
    const auto cell = [](const char* value, int count) {
        return fmt::format("<t:table-cell o:value-type='float' o:value='{}' t:number-columns-repeated='{}'/>", value,
                           count);
    };
    const Workbook workbook(
        ods("<t:table-row t:number-rows-repeated='3'><t:table-cell/>" + cell("2.5", 2) +
            "</t:table-row><t:table-row><t:table-cell o:value-type='date' o:date-value='2026-01-05'/>"
            "<t:covered-table-cell o:value-type='float' o:value='9'/>" +
            cell("1", 1) + "</t:table-row>"));
    const auto cells = workbook.rows(workbook.sheets().front());
    ASSERT_EQ(cells.size(), 4u);
    EXPECT_EQ(cells.at(2).at(1), "2.5");
    EXPECT_EQ(cells.at(2).at(2), "2.5");
    EXPECT_EQ(cells.at(3).at(0), "2026-01-05");
    EXPECT_FALSE(cells.at(3).contains(1)) << "covered by a merged cell";
    const auto beyond = ods("<t:table-row t:number-rows-repeated='1048576'>" + cell("1", 1) +
                            "</t:table-row><t:table-row>" + cell("1", 1) + "</t:table-row>");
    EXPECT_TRUE(holds(message_of([&] {
                          const Workbook large(beyond);
                          (void)large.rows(large.sheets().front());
                      }),
                      "beyond the"));
}

TEST(Workbook, OlderFormatsAreNamedWithTheRemedy) {
    const auto xls = bytes::memory_source("a.xls", CompoundFile({{"Workbook", std::string(5000, 'w')}}).content());
    EXPECT_EQ(workbook_kind(xls), WorkbookKind::old_excel);
    EXPECT_TRUE(holds(message_of([&] { (void)read_spreadsheet(xls); }), "save it as .xlsx"));
    const auto xlsb = bytes::memory_source("a.xlsb", zip_archive({{"xl/workbook.bin", "b"}}));
    EXPECT_TRUE(holds(message_of([&] { (void)read_spreadsheet(xlsb); }), "(.xlsb)"));
    EXPECT_EQ(workbook_kind(bytes::memory_source("a", "text")), WorkbookKind::none);
}

}  // namespace
}  // namespace setae::tables::tests::workbook_test
