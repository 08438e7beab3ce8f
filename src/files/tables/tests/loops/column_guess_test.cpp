// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/column_guess.hpp"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "import_samples.hpp"
#include "setae/tables/mapping_folder.hpp"

using namespace setae::tests;

namespace setae::tables::tests::column_guess_test {
namespace {

ColumnGuess guess_of(const std::string& text) {
    return guess_columns(read_raw_table(bytes::memory_source("t", text)), "t");
}

/// Columns from 1 for force, displacement, contact radius, time; 0 if none, negative if undecided.
std::vector<int> found(const std::string& names) {
    std::vector<int> columns;
    std::string numbers = "1";
    for (const char c : names) numbers += c == ';' ? ";2" : "";
    for (const auto& role : guess_of(fmt::format("{}\n{}\n{}\n", names, numbers, numbers)).roles)
        columns.push_back(role.candidates.empty()      ? 0
                          : role.candidates.size() > 1 ? -1
                                                       : static_cast<int>(role.candidates.front().column) + 1);
    return columns;
}

using Columns = std::vector<int>;

TEST(ColumnGuess, RecognisesTermsOfTheField) {
    EXPECT_EQ(found("Time (s);Load (mN);Indentation (um);Contact radius (um)"), (Columns{2, 3, 4, 1}));
    EXPECT_EQ(found("t [s];F [uN];d [nm];a [um]"), (Columns{2, 3, 4, 1}));
    EXPECT_EQ(found("Normal Force [N];Stage [mm];Temperature [K]"), (Columns{1, 2, 0, 0}));
    EXPECT_EQ(found("z-piezo [um];Load cell [mN];clock [ms]"), (Columns{2, 1, 0, 3}));
    EXPECT_EQ(found("force_mN;displacement_um;contact_radius_um;time_s"), (Columns{1, 2, 3, 4}));
    EXPECT_EQ(found("Kraft [mN];Weg [um];Zeit [s]"), (Columns{1, 2, 0, 3}));
}

TEST(ColumnGuess, RecognisesOtherLanguagesWithAndWithoutAccents) {
    EXPECT_EQ(found("Force (mN);Déplacement (µm);Rayon de contact (µm);Temps (s)"), (Columns{1, 2, 3, 4}));
    EXPECT_EQ(found("FORCE (mN);DEPLACEMENT (um);TEMPS (s)"), (Columns{1, 2, 0, 3}));
    EXPECT_EQ(found("Fuerza [mN];Desplazamiento [um];Radio de contacto [um];Tiempo [s]"), (Columns{1, 2, 3, 4}));
    EXPECT_EQ(found("Forza [mN];Spostamento [um];Raggio di contatto [um];Tempo [s]"), (Columns{1, 2, 3, 4}));
    EXPECT_EQ(found("Força [mN];Deslocamento [um];Raio de contato [um];Tempo [s]"), (Columns{1, 2, 3, 4}));
    EXPECT_EQ(found("Kracht [mN];Verplaatsing [um];Contactstraal [um];Tijd [s]"), (Columns{1, 2, 3, 4}));
    EXPECT_EQ(found("Prüfzeit [s];Standardkraft [N];Traversenweg absolut [mm]"), (Columns{2, 3, 0, 1}));
    EXPECT_EQ(found("Fuerza [mN];Vitesse d'enfoncement [um];Écart-type force [mN];Geschwindigkeit Weg [um]"),
              (Columns{1, 0, 0, 0}));
}

TEST(ColumnGuess, GapIsADisplacementWithOppositeSign) {
    for (const char* gap : {"gap", "Gap", "Tip-sample separation", "Abstand", "Écart", "separación"}) {
        const auto mapping = mapping_from(guess_of(fmt::format("Force [mN];{} [um]\n1;60\n3;4\n", gap)));
        EXPECT_EQ(mapping.results[1].expression, "-1 * gap") << gap;
    }
    EXPECT_EQ(found("Force [mN];Gap [um];Displacement [um]"), (Columns{1, 3, 0, 0}));
    const TemporaryFolder folder;
    const auto loop = read_loop_table(folder.write("t.csv", "force [mN];gap [um]\n1;60\n3;4\n"));
    EXPECT_DOUBLE_EQ(loop.table.at("displacement")[0], -60e-6);
    EXPECT_EQ(loop.channels.at("displacement").expression, "-1 * gap");
}

TEST(ColumnGuess, GivenUnitsAreUsedIfTheHeaderHasNone) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", "Zeit,Kraft,Weg\n0,1,60\n1,3,4\n");
    const auto message = message_of([&] { (void)mapping_from(guess_columns(path)); });
    EXPECT_TRUE(holds(message,
                      "column 2 'Kraft' for force and column 3 'Weg' for displacement and column 1 'Zeit' for "
                      "time have no unit"))
        << message;
    EXPECT_TRUE(holds(message, "--column force=\"kraft[mN]\"")) << message;
    for (const char* force : {"Kraft[uN]", "kraft [uN]", "2[uN]", "1 uN * kraft", "1 * kraft[uN]"}) {
        const auto mapping =
            mapping_from(guess_columns(path), {{"force", force}, {"displacement", "Weg[um]"}, {"time", "Zeit[s]"}});
        write_mapping(folder.path("m.toml"), mapping);
        EXPECT_DOUBLE_EQ(read_mapped_table(path, read_mapping(folder.path("m.toml"))).at("force")[1], 3e-6) << force;
        const auto loop = read_loop_table(path, LoopColumns::complete,
                                          {{"force", force}, {"displacement", "Weg[um]"}, {"time", "Zeit[s]"}});
        EXPECT_DOUBLE_EQ(loop.table.at("force")[1], 3e-6) << force;
        EXPECT_DOUBLE_EQ(loop.table.at("displacement")[0], 60e-6) << force;
        EXPECT_TRUE(loop.unused.empty()) << force;
    }
    EXPECT_TRUE(holds(message_of([&] {
                          (void)read_loop_table(path, LoopColumns::complete, {{"force", "2 * kraft"}});
                      }),
                      "the expression does not have the unit N"));
}

TEST(ColumnGuess, MassIsReportedAndItsWeightSuggested) {
    const TemporaryFolder folder;
    for (const auto& [unit, weight, newton] :
         {std::tuple("g", "gf", 9.80665e-3), std::tuple("kg", "kgf", 9.80665), std::tuple("mg", "mgf", 9.80665e-6),
          std::tuple("lb", "lbf", 4.4482216152605)}) {
        const auto path = folder.write("t.csv", fmt::format("Load ({});Weg (mm)\n1;60\n3;4\n", unit));
        const auto message = message_of([&] { (void)read_loop_table(path); });
        EXPECT_TRUE(holds(message, fmt::format("'Load' [{}] is in {}, a unit of mass", unit, unit))) << message;
        EXPECT_TRUE(holds(message, fmt::format("--column force=\"load[{}]\"", weight))) << message;
        const auto loop = read_loop_table(path, LoopColumns::complete, {{"force", fmt::format("load[{}]", weight)}});
        EXPECT_NEAR(loop.table.at("force")[0] / newton, 1.0, 1e-15);
    }
}

TEST(ColumnGuess, ComputesChosenColumnsOfALoopInSi) {
    Table table{
        .columns = {{"force", "N", Array1D::Constant(2, 3.0)}, {"displacement", "m", Array1D::Constant(2, 1.0)}}};
    const auto channels = choose_columns(table, "t", {{"force", "-1 * force"}});
    EXPECT_EQ(table.at("force")[0], -3.0);
    EXPECT_EQ(channels.at("force").expression, "-1 * force");
    EXPECT_EQ(channels.at("displacement").expression, "displacement");
}

TEST(MappingTemplate, MarksUnknownUnitsWithAQuestionMark) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", "Zeit,Kraft,Weg\n0,1,60\n1,3,4\n");
    const auto text = mapping_template(guess_columns(path), {});
    EXPECT_TRUE(holds(text, "header = \"Kraft\"\nunit = \"?\"")) << text;
    const auto draft = folder.write("m.toml", text);
    EXPECT_TRUE(holds(message_of([&] { (void)read_mapping(draft); }),
                      "a \"?\" marks information that the file does not contain"));
    auto answered = text;
    for (const char* unit : {"mN", "um", "s"})
        answered.replace(answered.find("\"?\"\n"), 3, fmt::format("\"{}\"", unit));
    const auto table = read_mapped_table(path, read_mapping(folder.write("n.toml", answered)));
    EXPECT_DOUBLE_EQ(table.at("force")[1], 3e-3);
    EXPECT_DOUBLE_EQ(table.at("displacement")[1], 4e-6);
    const auto without = folder.write("u.csv", "a,b\n0,1\n1,3\n");
    EXPECT_TRUE(holds(mapping_template(guess_columns(without), {}), "header = \"?\""));
}

TEST(ColumnGuess, IgnoresOtherQuantities) {
    EXPECT_EQ(
        found(
            "Force [mN];Force std [mN];Lateral force [mN];Displacement [um];Sphere radius [mm];Approach speed [um/s]"),
        (Columns{1, 4, 0, 0}));
    EXPECT_EQ(found("Force [mN];Displacement [um];X position [mm];Y position [mm]"), (Columns{1, 2, 0, 0}));
}

TEST(ColumnGuess, UsesTheUnitIfNoTermMatches) {
    const auto guess = guess_of("channel 1 [mN];depth [um]\n1;2\n3;4\n");
    ASSERT_EQ(guess.roles[0].candidates.size(), 1u);
    EXPECT_DOUBLE_EQ(guess.roles[0].candidates[0].confidence, 0.5);
    EXPECT_TRUE(holds(guess.roles[0].candidates[0].reason, "no other column has one"));
}

TEST(ColumnGuess, RadiusFromAreaGivesANote) {
    const auto guess = guess_of("Force [mN];Contact area [um2]\n1;314.159265358979\n3;4\n");
    EXPECT_TRUE(holds(describe(guess), "the radius of the circle with that area"));
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", "Force [mN];Contact area [um2]\n1;314.159265358979\n3;4\n");
    const auto table = read_mapped_table(path, mapping_from(guess_columns(path)));
    EXPECT_NEAR(table.at("contact_radius")[0], 1e-5, 1e-17);  // the area has 15 digits
    EXPECT_EQ(table.find("contact_radius")->unit, "m");
}

TEST(ColumnGuess, TwoCandidatesAreBothNamedAndRefused) {
    const auto guess = guess_of("Force [mN];Piezo position [um];MEMS displ. [nm]\n1;2;3\n3;4;5\n");
    const auto text = describe(guess);
    EXPECT_TRUE(
        holds(text, "displacement: undecided between column 2 'Piezo position' [um] and column 3 'MEMS displ.' [nm]"))
        << text;
    const auto message = message_of([&] { (void)mapping_from(guess); });
    EXPECT_TRUE(holds(message, "'Piezo position'") && holds(message, "'MEMS displ.'")) << message;
    EXPECT_EQ(*mapping_from(guess, {{"displacement", "Piezo position"}}).columns[1].header, "Piezo position");
    EXPECT_EQ(*mapping_from(guess, {{"displacement", "3"}}).columns[1].header, "MEMS displ.");
    EXPECT_TRUE(holds(message_of([&] {
                          (void)mapping_from(guess, {{"displacement", "Stage"}});
                      }),
                      "no column 'Stage'"));
    EXPECT_TRUE(holds(message_of([&] { (void)mapping_from(guess, {{"depth", "2"}}); }), "chosen for 'depth'"));
}

TEST(ColumnGuess, DescribesItsChoicesWithReasons) {
    const auto text = describe(guess_of("Force [mN];depth [um];state\n1,5;2;ok\n3,5;4;ok\n"));
    EXPECT_TRUE(holds(text, "3 columns between semicolons, decimal comma")) << text;
    EXPECT_TRUE(holds(text, "column 1 'Force' [mN]: 1.5, 3.5")) << text;
    EXPECT_TRUE(holds(text, "force: column 1 'Force' [mN], confidence 0.95: 'Force' is a word for force, mN its unit"))
        << text;
    EXPECT_TRUE(holds(text, "(text: 'ok' on line 2)")) << text;
    EXPECT_TRUE(holds(text, "contact_radius: no column found")) << text;
    EXPECT_TRUE(holds(text, "force positive in compression")) << text;
}

TEST(ColumnGuess, UnusableColumnsAreRefusedByName) {
    const auto message = [](const std::string& text) {
        return message_of([&] { (void)mapping_from(guess_of(text)); });
    };
    EXPECT_TRUE(holds(message("Force;depth [um]\n1;2\n3;4\n"), "column 1 'Force' for force has no unit"));
    EXPECT_TRUE(holds(message("depth [um];T [K]\n1;2\n3;4\n"),
                      "no column is found for force; the file has column 1 'depth' [um]"));
    EXPECT_TRUE(
        holds(message("Force [mN];T [K]\n1;2\n3;4\n"), "no column is found for displacement or contact_radius"));
    EXPECT_TRUE(
        holds(message("Force [mN];depth [um];T [K]\n1;;2\n3;;4\n"), "column 2 'depth' [um] (all values undefined)"));
    const auto without_radii = guess_of("Force [mN];depth [um];a [um]\n1;2;\n3;4;\n");
    EXPECT_TRUE(holds(as_toml(mapping_from(without_radii)),
                      "# contact_radius: column 3 'a' [um] was left out, since it has no numbers"));
    EXPECT_TRUE(holds(message_of([&] {
                          (void)mapping_from(without_radii, {{"contact_radius", "a"}});
                      }),
                      "for contact_radius has no numbers"));
    const auto text = guess_of("Force [mN];depth [um];state\n1;2;ok\n3;4;ok\n");
    EXPECT_TRUE(holds(message_of([&] {
                          (void)mapping_from(text, {{"displacement", "state"}});
                      }),
                      "has text: 'ok' on line 2, expected numbers"));
}

void expect_same(const Mapping& a, const Mapping& b) {
    EXPECT_EQ(a.file, b.file);
    EXPECT_EQ(a.constants, b.constants);
    EXPECT_EQ(a.columns, b.columns);
    EXPECT_EQ(a.results, b.results);
}

TEST(MappingTemplate, GuessesAreWrittenAndAppliedToOtherFiles) {
    const TemporaryFolder folder;
    const auto mapping =
        mapping_from(guess_columns(folder.write("a.csv", "Time [ms];Load [mN];depth [um]\n0,5;1,5;2\n1,0;3,5;4\n")));
    write_mapping(folder.path("m.toml"), mapping);
    const auto back = read_mapping(folder.path("m.toml"));
    expect_same(mapping, back);
    const auto table =
        read_mapped_table(folder.write("b.csv", "depth [nm];Load [N];Time [s]\n7,5;8;9\n1,5;2;10\n"), back);
    EXPECT_DOUBLE_EQ(table.at("force")[0], 8.0);
    EXPECT_DOUBLE_EQ(table.at("displacement")[0], 7.5e-9);
    EXPECT_DOUBLE_EQ(table.at("time")[1], 10.0);
}

TEST(MappingTemplate, EveryPartIsUnchangedAfterWritingAndReading) {
    const TemporaryFolder folder;
    const Mapping mapping{
        .path = {},
        .file = {.encoding = bytes::Encoding::latin1,
                 .separator = '\t',
                 .decimal_point = ',',
                 .header_end = "e\"o\\h",
                 .sheet = "Tabelle 1"},
        .constants = {{"k", 3.01, dimension::stiffness},
                      {"share", 0.1, {}},
                      {"v", 1.0 / 3.0, parse_unit("m/s").dimension}},
        .columns = {{"a", "Piezo \"x\" [µm]", {}, "um"}, {"b", {}, 2, {}}},
        .results = {{"force", "k * b", dimension::force}, {"my power", "k * a * b", dimension::energy}},
        .notes = {"made by a test"}};
    write_mapping(folder.path("m.toml"), mapping);
    expect_same(mapping, read_mapping(folder.path("m.toml")));
    expect_same(read_mapping("examples/mappings/eoh.toml"), [&] {
        write_mapping(folder.path("eoh.toml"), read_mapping("examples/mappings/eoh.toml"));
        return read_mapping(folder.path("eoh.toml"));
    }());
    EXPECT_THROW((void)as_toml({.constants = {{"k", std::nan(""), {}}}}), InvalidArgument);
    EXPECT_THROW((void)as_toml({.columns = {{"two words", "a", {}, {}}}}), InvalidArgument);
}

TEST(MappingTemplate, WorksOnWorkbooks) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.xlsx", xlsx_loop());
    write_mapping(folder.path("m.toml"), mapping_from(guess_columns(path, {.sheet = "Loop"})));
    const auto mapping = read_mapping(folder.path("m.toml"));
    EXPECT_EQ(mapping.file.sheet, "Loop");
    EXPECT_DOUBLE_EQ(read_mapped_table(path, mapping).at("force")[1], 2e-3);
}

TEST(MappedTable, TextAndEmptyColumnsAreRefused) {
    const TemporaryFolder folder;
    const auto mapping =
        read_mapping(folder.write("m.toml", "[columns.f]\nheader = \"F\"\nunit = \"N\"\n[table]\nforce = \"f\"\n"));
    const auto message = [&](const std::string& text) {
        return message_of([&] { (void)read_mapped_table(folder.write("t.csv", text), mapping); });
    };
    EXPECT_TRUE(holds(message("F,x\na,1\nb,2\n"), "column 'f' contains text ('a' on line 2), expected numbers"));
    EXPECT_TRUE(holds(message("F,x\n,1\n,2\n"), "column 'f' has no numbers"));
    EXPECT_TRUE(
        holds(message("F,x\n1 mN,1\n2 N,2\n"), "contains text ('1 mN' on line 2)"));  // units in cells may be mixed
}

const char* const sensor_table = "Piezo position [um];MEMS displ. [nm];Time [s]\n1;100;0\n2;300;1\n";

TEST(ExpressionForARole, UsesColumnHeadersAndQuantities) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", sensor_table);
    for (const char* force :
         {"3.01 N/m * mems", "mems_displ*3.01N/m", "column2 * 3010 mN/m", "2 * mems * 1.505e0 N/m"}) {
        SCOPED_TRACE(force);
        const auto mapping = mapping_from(guess_columns(path), {{"force", force}, {"displacement", "piezo - mems"}});
        const auto table = read_mapped_table(path, mapping);
        EXPECT_NEAR(table.at("force")[1], 3.01 * 300e-9, 1e-18);
        EXPECT_NEAR(table.at("displacement")[1], 2e-6 - 300e-9, 1e-18);
        EXPECT_EQ(table.at("time")[1], 1.0);
        // the mapping is a template like any other
        write_mapping(folder.path("m.toml"), mapping);
        EXPECT_NEAR(read_mapped_table(path, read_mapping(folder.path("m.toml"))).at("force")[1], 3.01 * 300e-9, 1e-18);
    }
}

TEST(ExpressionForARole, MistakesAreNamed) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", sensor_table);
    const auto message = [&](const char* force) {
        return message_of([&] {
            (void)read_mapped_table(path, mapping_from(guess_columns(path), {{"force", force}, {"displacement", "1"}}));
        });
    };
    EXPECT_TRUE(holds(message("3.01 N/m * volts"),
                      "no column 'volts' of the expression for force; the file has piezo_position, mems_displ, time"));
    EXPECT_TRUE(holds(message("3.01 * mems"), "the expression does not have the unit N"));
    EXPECT_TRUE(holds(message("3.01 N/m * mems +"), "force"));
    EXPECT_TRUE(
        holds(message_of([&] {
                  (void)mapping_from(guess_of("a x [N];a y [m]\n1;2\n"), {{"force", "1 * a"}, {"displacement", "2"}});
              }),
              "more than one column 'a'"));
}

TEST(ExpressionForARole, OverridesTheExpressionOfAMapping) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", sensor_table);
    const auto mapping = read_mapping(
        folder.write("m.toml",
                     "[columns.mems]\nposition = 2\n[columns.piezo]\nposition = 1\n[constants]\nk = \"3 N/m\"\n"
                     "[table]\nforce = \"k * mems\"\ndisplacement = \"piezo\"\n"));
    const auto table = read_mapped_table(path, with_results(mapping, {{"force", "2 * k * mems - 1 nN"}}));
    EXPECT_NEAR(table.at("force")[0], 6.0 * 100e-9 - 1e-9, 1e-18);
    EXPECT_NEAR(table.at("displacement")[0], 1e-6, 1e-18);
    EXPECT_TRUE(holds(message_of([&] {
                          (void)with_results(mapping, {{"force", "k * volts"}});
                      }),
                      "has k, mems, piezo"));
    EXPECT_THROW((void)with_results(mapping, {{"speed", "k"}}), InvalidArgument);
}

TEST(MappingFolder, FindsMappingsByPathAndByName) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", sensor_table);
    std::filesystem::create_directory(folder.path("mappings"));
    const std::string places = "[columns.a]\nposition = 1\n[columns.b]\nposition = 2\n";
    const auto own =
        folder.write("mappings/sensor.toml",
                     places + "[constants]\nk = \"3 N/m\"\n[table]\nforce = \"k * b\"\ndisplacement = \"a\"\n");
    (void)folder.write("mappings/other.toml",
                       "[columns.a]\nheader = \"Load\"\n[table]\nforce = \"a\"\ndisplacement = \"a\"\n");
    (void)folder.write("mappings/broken.toml", "force = ");
    const auto mappings = folder.path("mappings");
    EXPECT_EQ(mapping_names(mappings), (std::vector<std::string>{"broken", "other", "sensor"}));
    EXPECT_EQ(mapping_path("sensor", mappings), own);
    EXPECT_EQ(mapping_path(own, ""), own);
    EXPECT_EQ(fitting_mappings(path, mappings), (std::vector<std::string>{"sensor"}));
    EXPECT_TRUE(holds(message_of([&] { (void)mapping_path("sensors", mappings); }), "did you mean 'sensor'?"));
    EXPECT_TRUE(mapping_names(folder.path("none")).empty());
    EXPECT_TRUE(
        holds(message_of([&] { (void)mapping_path("eoh", folder.path("none")); }), "mappings in this folder: none"));
}

}  // namespace
}  // namespace setae::tables::tests::column_guess_test
