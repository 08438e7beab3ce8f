// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/mapping.hpp"
#include "setae/tables/power_spectrum_table.hpp"
#include "setae/tables/table_file.hpp"

using namespace setae::tests;

namespace setae::tables::tests::table_test {
namespace {

TEST(Table, ColumnsAreConvertedToSi) {
    const TemporaryFolder folder;
    const char* tables[] = {"force [mN],displacement (um),note\n1,2,3\n2,4,6\n",
                            "force / mN;displacement / um;note\n1;2;3\n2;4;6\n",
                            "force\tdisplacement\tnote\nmN\tum\t-\n1\t2\t3\n2\t4\t6\n",
                            "# force [mN] displacement [um] note\n1 2 3\n2 4 6\n",
                            "force [mN];displacement [um];note\n1,0;2,0;3,0\n2,0;4,0;6,0\n"};
    for (const auto* text : tables) {
        const auto table = read_table(folder.write("t.csv", text));
        EXPECT_DOUBLE_EQ(table.at("force")[1], 2e-3) << text;
        EXPECT_EQ(table.find("force")->unit, "N") << text;
        EXPECT_DOUBLE_EQ(table.at("displacement")[0], 2e-6) << text;
        EXPECT_DOUBLE_EQ(table.at("note")[1], 6.0) << text;
    }
}

TEST(Table, ColumnsWithoutUnitKeepTheirNumbers) {
    const TemporaryFolder folder;
    const auto table = read_table(folder.write("t.csv", "a,T [°C]\n1,20\n2,21\n"));
    EXPECT_EQ(table.find("a")->unit, "");
    EXPECT_EQ(table.find("T")->unit, "°C");
    EXPECT_DOUBLE_EQ(table.at("T")[1], 21.0);
}

TEST(Table, WrittenTablesAreReadBackToTheLastDigit) {
    const TemporaryFolder folder;
    Table table;
    table.columns = {{"wavevector", "1/m", Array1D{{0.1, 1.0 / 3.0, 1e300}}},
                     {"C1D", "m3", Array1D{{4.9e-324, std::nan(""), -2.0}}}};
    write_csv(folder.path("t.csv"), table);
    const auto back = read_table(folder.path("t.csv"));
    EXPECT_TRUE((back.at("wavevector") == table.columns[0].values).all());
    EXPECT_EQ(back.at("C1D")[0], 4.9e-324);
    EXPECT_TRUE(std::isnan(back.at("C1D")[1]));
    EXPECT_EQ(back.find("C1D")->unit, "m3");
}

TEST(Table, ColumnsOfUndefinedValuesAreReadBackFromCsv) {
    const TemporaryFolder folder;
    Table table;
    table.columns = {{"a", "m", Array1D{{1.0, 2.0}}}, {"b", "m", Array1D{{std::nan(""), std::nan("")}}}};
    write_csv(folder.path("t.csv"), table);
    EXPECT_EQ(bytes::read_file(folder.path("t.csv")), "a [m],b [m]\n1,\n2,\n");
    EXPECT_TRUE(read_table(folder.path("t.csv")).at("b").isNaN().all());
    table.columns = {{"a", "m", Array1D{{1.0, std::nan(""), 2.0}}}};
    write_csv(folder.path("t.csv"), table);
    EXPECT_EQ(read_table(folder.path("t.csv")).rows(), 3);
}

TEST(Table, NamesThatBreakCsvAreRefused) {
    const TemporaryFolder folder;
    Table table;
    table.columns = {{"a,b", "m", Array1D::Zero(1)}};
    EXPECT_THROW(write_csv(folder.path("t.csv"), table), InvalidArgument);
}

TEST(WholeFile, KeepsTheOldContentWhenWritingFails) {
    const TemporaryFolder folder;
    bytes::write_whole_file(folder.path("a"), "one");
    bytes::write_whole_file(folder.path("a"), "two");
    EXPECT_EQ(bytes::read_file(folder.path("a")), "two");
    EXPECT_THROW(bytes::write_whole_file(folder.path("missing/a"), "three"), FileError);
    EXPECT_THROW(bytes::write_whole_file(folder.path("."), "three"), FileError);
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path("."))) ++files;
    EXPECT_EQ(files, 1u);
}

TEST(LoopTable, RequiresForcesAndUnits) {
    const TemporaryFolder folder;
    const auto table = read_loop_table(folder.write("l.csv", "Force [mN],Displacement [um]\n1,2\n2,3\n")).table;
    EXPECT_DOUBLE_EQ(table.at("force")[0], 1e-3);
    const auto no_force = folder.write("a.csv", "signal [V],displacement [um]\n1,2\n2,3\n");
    EXPECT_NE(message_of([&] { (void)read_loop_table(no_force); }).find("no column is found for force"),
              std::string::npos);
    const auto no_unit = folder.write("b.csv", "force,displacement [um]\n1,2\n2,3\n");
    EXPECT_NE(message_of([&] { (void)read_loop_table(no_unit); }).find("no unit"), std::string::npos);
    const auto wrong = folder.write("c.csv", "force [um],displacement [um]\n1,2\n2,3\n");
    EXPECT_NE(message_of([&] { (void)read_loop_table(wrong); }).find("'force' [um] is in um, expected a unit of N"),
              std::string::npos);
}

TEST(LoopTable, RecognisesColumnsAsImportAndNamesTheOthers) {
    const TemporaryFolder folder;
    const auto loop = read_loop_table(
        folder.write("l.csv", "load [mN],displacement [um],contact radius [um],humidity\n1,2,30,0.4\n2,3,40,0.4\n"));
    EXPECT_DOUBLE_EQ(loop.table.at("force")[1], 2e-3);
    EXPECT_DOUBLE_EQ(loop.table.at("contact_radius")[1], 40e-6);
    ASSERT_EQ(loop.taken.size(), 2u);
    EXPECT_NE(loop.taken[0].find("force from 'load [mN]'"), std::string::npos) << loop.taken[0];
    EXPECT_NE(loop.taken[1].find("contact_radius from 'contact radius [um]'"), std::string::npos) << loop.taken[1];
    EXPECT_EQ(loop.unused, std::vector<std::string>{"humidity"});

    const auto area =
        read_loop_table(folder.write("m.csv", "force [mN],contact area [um2]\n1,314.159265358979\n2,400\n"));
    EXPECT_NEAR(area.table.at("contact_radius")[0], 10e-6, 1e-18);

    // two candidates: neither is used, and both are reported
    const auto two = read_loop_table(
        folder.write("n.csv", "force [mN],displacement [um],radius left [um],radius right [um]\n1,2,3,4\n2,3,4,5\n"));
    EXPECT_EQ(two.table.find("contact_radius"), nullptr);
    EXPECT_EQ(two.unused.size(), 2u);
}

TEST(PowerSpectrumTable, TablesWithoutUnitsAreInSi) {
    const TemporaryFolder folder;
    for (const auto* first_row : {"q;C\n", "0;1\n"}) {
        const auto table =
            read_power_spectrum_table(folder.write("p.csv", std::string(first_row) + "1,5e3;2,5e-12\n2,5e3;1e-12\n"));
        ASSERT_EQ(table.rows(), 2) << first_row;
        EXPECT_DOUBLE_EQ(table.at("wavevector")[0], 1500.0);
        EXPECT_DOUBLE_EQ(table.at("C1D")[0], 2.5e-12);
        EXPECT_EQ(table.metadata.at("units"), "assumed SI");
    }
}

TEST(PowerSpectrumTable, IsRecognisedByItsUnits) {
    const auto is = [](const std::string& text) { return is_power_spectrum_table(bytes::memory_source("a", text)); };
    EXPECT_TRUE(is("q [1/um],C1D [nm3]\n1,2\n2,1\n"));
    EXPECT_TRUE(is("frequency (1/um);C2D (nm4);err\n1,5;2;0\n2,5;1;0\n"));
    EXPECT_TRUE(is("wavelength [um],C_iso [nm4]\n1,2\n2,1\n"));
    EXPECT_FALSE(is("x [um],h [nm]\n1,2\n2,1\n"));
    EXPECT_FALSE(is("q,C1D\n1,2\n2,1\n"));
    EXPECT_FALSE(is("1 2\n2 1\n"));
    EXPECT_FALSE(is(""));
    EXPECT_FALSE(is(std::string(100, '\0')));
    std::string text = "q [1/um],C1D [nm3]\n";
    for (int i = 1; i < 5000; ++i) text += std::to_string(i) + ",1\n";
    EXPECT_TRUE(is(text)) << "its beginning is enough";
}

TEST(PowerSpectrumTable, UsesGivenUnitsIfTheHeaderLacksThem) {
    const TemporaryFolder folder;
    const auto bare = folder.write("p.csv", "f,psd,err\n1,2,0.5\n2,1,0.25\n");
    const auto table = read_power_spectrum_table(bare, SpectrumUnits::from_text("1/um, nm3"));
    EXPECT_DOUBLE_EQ(table.at("wavevector")[0], 2e6 * pi) << "its name says frequency";
    EXPECT_DOUBLE_EQ(table.at("standard_error")[0], 0.5e-27);
    const auto stated = folder.write("s.csv", "q [1/nm],C1D [nm3]\n1,2\n2,1\n");
    EXPECT_THROW((void)read_power_spectrum_table(stated, {.wavevector = "1/um", .density = "nm3"}), InvalidArgument);
    EXPECT_THROW((void)SpectrumUnits::from_text("um"), InvalidArgument);
}

TEST(PowerSpectrumTable, UsesTheGivenMeaningOfTheFirstColumn) {
    const TemporaryFolder folder;
    const auto bare = folder.write("p.txt", "1 2\n2 1\n");
    const auto q = [&](const std::string& path, const char* units) {
        return read_power_spectrum_table(path, SpectrumUnits::from_text(units)).at("wavevector")[0];
    };
    EXPECT_DOUBLE_EQ(q(bare, "1/um, nm3"), 1e6);
    EXPECT_DOUBLE_EQ(q(bare, "wavevector 1/um, nm3"), 1e6);
    EXPECT_DOUBLE_EQ(q(bare, "frequency 1/um, nm4"), 2e6 * pi);
    EXPECT_DOUBLE_EQ(q(bare, "wavelength um, nm3"), 1e6 * pi);
    EXPECT_DOUBLE_EQ(q(folder.write("f.csv", "f [1/um],C1D [nm3]\n1,2\n2,1\n"), "wavevector 1/um, nm3"), 1e6)
        << "what is said goes before a name";
    EXPECT_THROW((void)q(bare, "wavelength 1/um, nm3"), FormatError);
    EXPECT_EQ(read_power_spectrum_table(bare).metadata.at("quantity"), "wavevector");
    EXPECT_EQ(read_power_spectrum_table(bare).metadata.at("units_of_file"), "1/m, m3");
}

TEST(PowerSpectrumTable, WarnsOfAssumptions) {
    const TemporaryFolder folder;
    const auto bare = folder.write("p.txt", "1 2\n2 1\n");
    const auto codes = [&](const Table& table) {
        std::string list;
        for (const auto& alert : alerts_of(table, "s")) list += alert.subject + " " + alert.code + "; ";
        return list;
    };
    EXPECT_EQ(codes(read_power_spectrum_table(bare)), "s UNIT_GUESSED; s SPECTRUM_CONVENTION; ");
    EXPECT_EQ(codes(read_power_spectrum_table(bare, SpectrumUnits::from_text("frequency 1/um, nm4"))),
              "s SPECTRUM_CONVERTED; ");
    EXPECT_EQ(codes(read_power_spectrum_table(bare, SpectrumUnits::from_text("1/um, nm4"))), "s SPECTRUM_CONVENTION; ");
    EXPECT_EQ(codes(read_power_spectrum_table(bare, SpectrumUnits::from_text("1/um, C_iso nm4"))), "");
    const auto named = folder.write("q.csv", "q [1/um],C1D [nm3]\n1,2\n2,1\n");
    EXPECT_EQ(codes(read_power_spectrum_table(named)), "");
}

TEST(PowerSpectrumTable, UnitsOfTheHeaderAreApplied) {
    const TemporaryFolder folder;
    const auto table =
        read_power_spectrum_table(folder.write("p.csv", "q [1/um],C1D [nm3],std err [nm3]\n1,2,0.5\n2,1,0.25\n"));
    EXPECT_DOUBLE_EQ(table.at("wavevector")[0], 1e6);
    EXPECT_DOUBLE_EQ(table.at("C1D")[0], 2e-27);
    EXPECT_DOUBLE_EQ(table.at("standard_error")[1], 0.25e-27);
    EXPECT_EQ(table.metadata.count("units"), 0u);
}

TEST(PowerSpectrumTable, FrequenciesAndWavelengthsBecomeWavevectors) {
    const TemporaryFolder folder;
    const auto by_frequency =
        read_power_spectrum_table(folder.write("f.csv", "frequency [1/um],two-sided PSD [nm3]\n1,2\n2,1\n"));
    EXPECT_DOUBLE_EQ(by_frequency.at("wavevector")[0], 2e6 * pi);
    EXPECT_DOUBLE_EQ(by_frequency.at("C1D")[0], 2e-27);
    EXPECT_NE(by_frequency.metadata.at("converted").find("frequencies, q = 2π f"), std::string::npos);
    const auto by_wavelength =
        read_power_spectrum_table(folder.write("l.csv", "wavelength [um],C1D [nm3],error [nm3]\n2,1,0.1\n4,3,0.2\n"));
    EXPECT_DOUBLE_EQ(by_wavelength.at("wavevector")[0], 0.5e6 * pi) << "ascending";
    EXPECT_DOUBLE_EQ(by_wavelength.at("C1D")[0], 3e-27);
    EXPECT_DOUBLE_EQ(by_wavelength.at("standard_error")[0], 0.2e-27);
    EXPECT_EQ(
        read_power_spectrum_table(folder.write("q.csv", "q [1/um],C1D [nm3]\n1,2\n2,1\n")).metadata.count("converted"),
        0u);
}

TEST(PowerSpectrumTable, CyclesAndPairsOfLinesAreFrequencies) {
    const TemporaryFolder folder;
    for (const char* first : {"cycles per um", "f [cycles/um]", "period (lp/um)"}) {
        const auto table =
            read_power_spectrum_table(folder.write("f.csv", std::string(first) + ",two-sided PSD [nm3]\n1,2\n2,1\n"));
        EXPECT_DOUBLE_EQ(table.at("wavevector")[0], 2e6 * pi) << first;
    }
}

TEST(PowerSpectrumTable, LogarithmsAreRefused) {
    const TemporaryFolder folder;
    EXPECT_NE(
        message_of([&] {
            (void)read_power_spectrum_table(folder.write("l.csv", "log10 q (1/m),log10 C1D (m3)\n5,-27\n6,-28\n"));
        }).find("'log10 q' contains logarithms"),
        std::string::npos);
}

TEST(HeaderCell, ReadsUnitsAfterASlashAsInDin) {
    const auto shown = [](const char* cell) {
        const auto [name, unit] = parse_header_cell(cell);
        return name + "|" + unit;
    };
    EXPECT_EQ(shown("x/mm"), "x|mm");
    EXPECT_EQ(shown("F/mN"), "F|mN");
    EXPECT_EQ(shown("Kraft/N"), "Kraft|N");
    EXPECT_EQ(shown("N/mm"), "N/mm|");
    EXPECT_EQ(shown("1/um"), "1/um|");
    EXPECT_EQ(shown("y/x"), "y/x|");
}

/// A Gaussian spectrum, σ 2 nm and T 1 µm: C1D = √π σ² T exp(−q²T²/4), C_iso = π σ² T² exp(−q²T²/4) [µm, nm].
struct GaussianSpectrum {
    static double C1D(double q) { return std::sqrt(pi) * 4.0 * std::exp(-0.25 * q * q); }
    static double C_iso(double q) { return pi * 4.0 * std::exp(-0.25 * q * q); }
};

/// A table of the spectrum with `names` above, `x(q)` and `y(q)` below.
std::string spectrum_text(const std::string& names, double (*x)(double), double (*y)(double)) {
    std::string text = names + "\n";
    for (int i = 1; i <= 1200; ++i) {
        const double q = 0.005 * i;
        text += fmt::format("{},{}\n", x(q), y(q));
    }
    return text;
}

TEST(PowerSpectrumTable, EveryNamedConventionGivesTheSameHeight) {
    const auto q = [](double w) { return w; };
    const auto f = [](double w) { return w / (2.0 * pi); };
    const auto lambda = [](double w) { return 2.0 * pi / w; };
    const auto C1D = [](double w) { return GaussianSpectrum::C1D(w); };
    const auto W1 = [](double w) { return GaussianSpectrum::C1D(w) / (2.0 * pi); };
    const auto one = [](double w) { return 2.0 * GaussianSpectrum::C1D(w); };
    const auto C_iso = [](double w) { return GaussianSpectrum::C_iso(w); };
    const auto W2 = [](double w) { return GaussianSpectrum::C_iso(w) / (4.0 * pi * pi); };
    const auto Wr = [](double w) { return w * GaussianSpectrum::C_iso(w) / (2.0 * pi); };
    const std::vector<std::string> texts{
        spectrum_text("q [1/um],C1D [nm2 um]", q, C1D),
        spectrum_text("wavevector (rad/µm),C^1D (nm²·µm)", q, C1D),
        spectrum_text("f [1/um],two-sided PSD [nm2 um]", f, C1D),
        spectrum_text("# double sided\nSpatial frequency [cycles/um],PSD [nm2 um]", f, C1D),
        spectrum_text("Ortsfrequenz [1/um],einseitige PSD [nm2 um]", f, one),
        spectrum_text("# one-sided spectrum\nfréquence spatiale [1/um],DSP [nm2 um]", f, one),
        spectrum_text("q [1/um],single-sided C1D [nm2 um]", q, one),
        spectrum_text("wavelength [um],C1D [nm2 um]", lambda, C1D),
        spectrum_text("k [1/um],W1 [nm2 um]", q, W1),
        spectrum_text("k [1/um],W<sub>1</sub> [nm2 um]", q, W1),
        spectrum_text("k [1/um],W₁ [nm2 um]", q, W1),
        spectrum_text("k [1/um],PSDF [nm2 um]", q, W1),
        spectrum_text("# Gwyddion\nk [1/um],spectral density [nm2 um]", q, W1),
        spectrum_text("k [1/um],Wr [nm2 um]", q, Wr),
        spectrum_text("q [1/um],C_iso [nm2 um2]", q, C_iso),
        spectrum_text("k [1/um],W2 [nm2 um2]", q, W2),
        spectrum_text("angular frequency [1/um],C1D [nm2 um]", q, C1D)};
    for (const auto& text : texts) {
        const TemporaryFolder folder;
        const auto path = folder.write("p.csv", text);
        const auto header = text.substr(0, text.find("\n0"));
        ASSERT_TRUE(is_power_spectrum_table(bytes::file_source(path))) << header;
        const auto table = read_power_spectrum_table(path);
        const auto& w = table.at("wavevector");
        const bool areal = table.find("C_iso") != nullptr;
        const auto& density = table.at(areal ? "C_iso" : "C1D");
        const double unit = areal ? 1e-30 : 1e-24;
        for (const Index i : {Index{10}, Index{300}}) {
            const double of = w[i] * 1e-6;
            EXPECT_NEAR(density[i] / unit / (areal ? GaussianSpectrum::C_iso(of) : GaussianSpectrum::C1D(of)), 1.0,
                        1e-12)
                << header;
        }
    }
}

TEST(PowerSpectrumTable, AmbiguousHeadersAreRefusedWithTheRmsHeightOfEachReading) {
    const TemporaryFolder folder;
    const auto q = [](double w) { return w; };
    const auto C1D = [](double w) { return GaussianSpectrum::C1D(w); };
    const auto message = [&](const std::string& names) {
        const auto path = folder.write("p.csv", spectrum_text(names, q, C1D));
        return message_of([&] { (void)read_power_spectrum_table(path); });
    };
    const auto by_frequency = message("frequency [1/um],PSD [nm2 um]");
    EXPECT_TRUE(holds(by_frequency, "\"frequency, C1D\": h_rms² = ∫ C df over ±f, 5.0")) << by_frequency;
    EXPECT_TRUE(holds(by_frequency, "\"frequency, one-sided C1D\"")) << by_frequency;
    const auto by_wavevector = message("q [1/um],PSD [nm2 um]");
    EXPECT_TRUE(holds(by_wavevector, "\"wavevector, C1D\": h_rms² = (1/2π) ∫ C1D dq over ±q, 2.00 nm"))
        << by_wavevector;
    EXPECT_TRUE(holds(by_wavevector, "\"wavevector, W1\": h_rms² = ∫ W1 dk over ±k, 5.0")) << by_wavevector;
    EXPECT_TRUE(holds(message("k [1/um],PSD [nm2 um]"), "\"frequency, C1D\""));
    const auto path = folder.write("p.csv", spectrum_text("q [1/um],PSD [nm2 um]", q, C1D));
    const auto stated = read_power_spectrum_table(path, SpectrumUnits::from_text("wavevector, W1"));
    EXPECT_NEAR(stated.at("C1D")[0] / 1e-24, 2.0 * pi * GaussianSpectrum::C1D(0.005), 1e-9);
    EXPECT_TRUE(holds(stated.metadata.at("converted"), "h_rms is 5.0"));
    EXPECT_NEAR(
        read_power_spectrum_table(path, SpectrumUnits::from_text("wavevector 1/um, one-sided um nm2")).at("C1D")[0] /
            1e-24,
        0.5 * GaussianSpectrum::C1D(0.005), 1e-12);
    EXPECT_THROW((void)read_power_spectrum_table(path, SpectrumUnits::from_text("wavevector, C_iso")), InvalidArgument);
}

TEST(PowerSpectrumTable, ArealDensityIsRecognisedByItsUnit) {
    const TemporaryFolder folder;
    const auto table = read_power_spectrum_table(folder.write("p.csv", "q [1/um],C_iso [nm4]\n1,2\n2,1\n"));
    EXPECT_EQ(table.find("C1D"), nullptr);
    EXPECT_DOUBLE_EQ(table.at("C_iso")[1], 1e-36);
}

TEST(PowerSpectrumTable, WrongUnitsAreRefused) {
    const TemporaryFolder folder;
    const auto path = folder.write("p.csv", "q [1/um],C1D [nm2]\n1,2\n2,1\n");
    EXPECT_NE(message_of([&] { (void)read_power_spectrum_table(path); }).find("nm2"), std::string::npos);
    const auto twice = folder.write("t.csv", "q [1/um],C1D [nm3]\n1,2\n1,1\n");
    EXPECT_NE(message_of([&] { (void)read_power_spectrum_table(twice); }).find("is in two rows"), std::string::npos);
    const auto partly = folder.write("r.csv", "q [1/um],C1D\n1,2\n2,1\n");
    EXPECT_THROW((void)read_power_spectrum_table(partly), FormatError);
    const auto single = folder.write("q.csv", "1\n2\n");
    EXPECT_THROW((void)read_power_spectrum_table(single), FormatError);
}

constexpr const char* mapping_text = R"(
[file]
encoding = "latin-1"
separator = "tab"
decimal = "comma"
header_end = "eoh"
[constants]
k = "2 N/m"
[columns.piezo]
header = "Piezo"
unit = "um"
[columns.mems]
position = 2
[table]
force = "k * mems"
displacement = "piezo - mems"
power = { expression = "k * mems^2", unit = "J" }
)";
constexpr const char* foreign_table =
    "Made 1,5 \xb0"
    "C\nPiezo[nm]\tMEMS[nm]\nx\neoh\n1,5\t10\n2,5\t20\n";

TEST(Mapping, ExpressionsWorkOnColumnsInSi) {
    const TemporaryFolder folder;
    const auto mapping = read_mapping(folder.write("m.toml", mapping_text));
    const auto table = read_mapped_table(folder.write("t.txt", foreign_table), mapping);
    EXPECT_DOUBLE_EQ(table.at("force")[1], 40e-9);
    EXPECT_DOUBLE_EQ(table.at("displacement")[0], 1.5e-6 - 10e-9);
    EXPECT_DOUBLE_EQ(table.at("power")[0], 2e-16);
    EXPECT_EQ(table.find("power")->unit, "J");
    EXPECT_NO_THROW(require_loop_columns(table, "t.txt"));
}

std::string mapping_error(const std::string& from, const std::string& to) {
    std::string text = mapping_text;
    text.replace(text.find(from), from.size(), to);
    const TemporaryFolder folder;
    const auto table = folder.write("t.txt", foreign_table);
    const auto path = folder.write("m.toml", text);
    return message_of([&] { (void)read_mapped_table(table, read_mapping(path)); });
}

TEST(Mapping, MistakesAreNamed) {
    EXPECT_NE(mapping_error("separator", "seperator").find("did you mean 'separator'"), std::string::npos);
    EXPECT_NE(mapping_error("[constants]", "[constant]").find("did you mean 'constants'"), std::string::npos);
    EXPECT_NE(mapping_error("\"tab\"", "\"tabulator\"").find("expected one of tab"), std::string::npos);
    EXPECT_NE(mapping_error("\"2 N/m\"", "\"two N/m\"").find("constant 'k'"), std::string::npos);
    EXPECT_NE(mapping_error("\"um\"", "\"parsec\"").find("parsec"), std::string::npos);
    EXPECT_NE(mapping_error("k * mems\"", "3.01 * mems\"").find("the expression does not have the unit N"),
              std::string::npos);
    EXPECT_NE(mapping_error("\"k * mems\"", "\"k = k * 1.01\"").find("assigns a value to a column"), std::string::npos);
    EXPECT_NE(mapping_error("\"k * mems\"", "\"mems, k * mems\"").find("expected one"), std::string::npos);
    EXPECT_NE(mapping_error("\"k * mems\"", "\"k * mems\\u0000 junk\"").find("zero byte"), std::string::npos);
    EXPECT_NE(mapping_error("\"k * mems\"", "\"mems > 0.007 * piezo ? k * mems : piezo\"")
                  .find("the expression does not have the unit N"),
              std::string::npos);
    EXPECT_EQ(mapping_error("\"k * mems\"", "\"mems >= 0.007 * piezo ? k * mems : 2 * k * mems\""), "no error");
    EXPECT_NE(mapping_error("piezo - mems", "piezo - mms").find("mms"), std::string::npos);
    EXPECT_NE(mapping_error("piezo - mems", "piezo -").find("displacement"), std::string::npos);
    EXPECT_NE(mapping_error("force =", "load =").find("unit of 'load'"), std::string::npos);
    EXPECT_NE(mapping_error("position = 2", "position = 5").find("no column 5"), std::string::npos);
    EXPECT_NE(mapping_error("header = \"Piezo\"", "header = \"Stage\"").find("Piezo [nm], MEMS [nm]"),
              std::string::npos);
    EXPECT_NE(mapping_error("\"eoh\"", "\"end\"").find("no line 'end'"), std::string::npos);
    EXPECT_NE(mapping_error("[file]", "[file").find("TOML"), std::string::npos);
    EXPECT_NE(mapping_error("header = \"Piezo\"", "").find("either header or position"), std::string::npos);
}

}  // namespace
}  // namespace setae::tables::tests::table_test
