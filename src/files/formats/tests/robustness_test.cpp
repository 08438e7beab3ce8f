// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include <gtest/gtest.h>

#include "import_samples.hpp"
#include "sample_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/tables/column_guess.hpp"
#include "setae/tables/force_map.hpp"
#include "setae/tables/loop_file.hpp"

using namespace setae::tests;

namespace setae::formats::tests::robustness_test {
namespace {

/// Opens bytes as any format and reads every channel: only errors of setae are allowed.
void must_read_or_refuse(const std::string& content) {
    try {
        for (const auto& channel : open(bytes::memory_source("sample", content), {{{1e-6, 1e-6}}, "nm"})) try {
                (void)channel.read();
            } catch (const Error&) {
            }
    } catch (const Error&) {
    }
}

std::vector<std::pair<std::string, std::string>> samples() {
    const TemporaryFolder folder;
    Table table;
    table.columns = {{"x", "m", Array1D{{0.0, 1.0, 3.0}}}, {"heights", "m", Array1D{{0.5, 0.25, 0.125}}}};
    write_netcdf(folder.path("t.nc"), table);
    const auto xml =
        x3p_document("SUR", "<AxisType>I</AxisType><DataType>D</DataType><Increment>1e-6</Increment>",
                     "<AxisType>A</AxisType><DataType>I</DataType><Increment>0.001</Increment>",
                     "<MatrixDimension><SizeX>2</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ></MatrixDimension>",
                     "<DataList><Datum>1</Datum><Datum>2</Datum><Datum>3</Datum><Datum>4</Datum></DataList>");
    return {
        {"xy", "x [um];h [um]\n0,5;1,5\n1,5;2,5\n2,5;3,5\n"},
        {"profile",
         "# format: setae profile\n# version: 1\n# instrument: tem\n# blur: 1e-10 m\n# smoothing_length: 2e-10 m\n# step: 1e-10 m\n# noise_density: 1e-31 m3\n"
         "# foil_thickness: 1e-08 m\nx [m],h [m],standard_error [m]\n0,1e-9,1e-11\n1e-10,2e-9,1e-11\n2e-10,1e-9,2e-11\n"},
        {"matrix", "# Channel: a\n# Width: 1 um\n# Height: 1 um\n# Value units: nm\n1 2 3\n4 5 6\n"},
        {"nanoscope", nanoscope_file(6, 5, 2)},
        {"x3p list", xml},
        {"x3p", zip_archive({{"main.xml", xml}})},
        {"container", container_file()},
        {"npy", "\x93NUMPY\x01" + std::string(1, '\0') + "\x3e" + std::string(1, '\0') +
                    "{'descr': '<i2', 'fortran_order': False, 'shape': (2, 2), }   \n12345678"},
        {"netcdf", bytes::read_file(folder.path("t.nc"))}};
}

TEST(Readers, HandleTruncationAnywhere) {
    for (const auto& [name, content] : samples()) {
        SCOPED_TRACE(name);
        const auto stride = std::max<std::size_t>(1, content.size() / 600);
        for (std::size_t length = 0; length < content.size(); length += stride)
            must_read_or_refuse(content.substr(0, length));
    }
}

TEST(Readers, HandleFlippedBits) {
    std::mt19937 generator(12345);
    for (const auto& [name, content] : samples()) {
        SCOPED_TRACE(name);
        for (int trial = 0; trial < 800; ++trial) {
            auto damaged = content;
            const auto flips = 1 + generator() % 4;
            for (std::size_t k = 0; k < flips; ++k)
                damaged[generator() % damaged.size()] ^= static_cast<char>(1u << (generator() % 8));
            must_read_or_refuse(damaged);
        }
    }
}

TEST(Readers, ReadUndamagedSamples) {
    for (const auto& [name, content] : samples())
        EXPECT_NO_THROW((void)open(bytes::memory_source(name, content), {{{1e-6, 1e-6}}, "nm"}).front().read()) << name;
}

/// Reads bytes as a table with its guess and mapping, and as a force curve.
void must_import_or_refuse(const std::string& content) {
    const auto source = bytes::memory_source("sample", content);
    try {
        const auto guess = tables::guess_columns(tables::read_raw_table(source), "sample");
        (void)tables::describe(guess);
        (void)tables::as_toml(tables::mapping_from(guess));
    } catch (const Error&) {
    }
    try {
        const auto curves = tables::open_force_curves(source, {.spring_constant = 1.0});
        for (const long number : curves.numbers) try {
                const auto curve = curves.read(number);
                if (curves.grid) (void)curves.grid->pixel(curve.x, curve.y);
            } catch (const Error&) {
            }
    } catch (const Error&) {
    }
}

std::vector<std::pair<std::string, std::string>> import_samples() {
    return {
        {"workbook", xlsx_loop()},
        {"words", "force [mN],state,depth [um]\n1,free,2\n3,contact,4\n"},
        {"grouped", "force [mN]\tdepth [um]\n1,234\t5.5\n2,345\t6.5\n"},
        {"jpk-force", jpk_force_file()},
        {"jpk-force with shared header", jpk_force_file(true)},
        {"jpk-force of 2015", jpk_force_file_of_2015()},
        {"jpk-force-map", jpk_map_file({{.number = 0, .x = 0.0, .y = -1e-6}, {.number = 7, .x = 2e-6, .y = -1e-6}})},
        {"jpk-text", jpk_text_file(2)},
        {"nanoscope-force", nanoscope_force_file(6, true)},
        {"nanosurf-force", nanosurf_force_file()},
        {"afm-workshop", afm_workshop_file()},
        {"igor-force", igor_force_file("SpringConstant: 0.5\rIndexes: 0,3,5\r")},
        {"nt-mdt", nt_mdt_file()}};
}

/// A copy with a few bits flipped.
std::string damaged(std::string content, std::mt19937& generator) {
    const auto flips = 1 + generator() % 4;
    for (std::size_t k = 0; k < flips; ++k)
        content[generator() % content.size()] ^= static_cast<char>(1u << (generator() % 8));
    return content;
}

TEST(Import, HandlesTruncationAnywhere) {
    for (const auto& [name, content] : import_samples()) {
        SCOPED_TRACE(name);
        const auto stride = std::max<std::size_t>(1, content.size() / 300);
        for (std::size_t length = 0; length < content.size(); length += stride)
            must_import_or_refuse(content.substr(0, length));
    }
}

TEST(Import, HandlesFlippedBits) {
    std::mt19937 generator(54321);
    for (const auto& [name, content] : import_samples()) {
        SCOPED_TRACE(name);
        for (int trial = 0; trial < 400; ++trial) must_import_or_refuse(damaged(content, generator));
    }
}

TEST(Import, HandlesFlippedBitsInMembersOfWorkbooks) {
    std::mt19937 generator(777);
    const std::string sheet =
        xlsx_sheet({{{"A1", "s:0"}, {"B1", "depth [um]"}}, {{"A2", "1"}, {"B2", "2"}}, {{"A3", "3"}, {"B3", "4"}}});
    for (int trial = 0; trial < 300; ++trial)
        must_import_or_refuse(xlsx_file({{"S", damaged(sheet, generator)}}, {"<t>force [mN]</t>"}));
    auto properties = jpk_segment("extend", 3, false);
    const auto channel = big_endian<std::int16_t>({1, 2, 3});
    for (int trial = 0; trial < 300; ++trial)
        must_import_or_refuse(zip_archive({{"header.properties", "jpk-data-file=spm-forcefile\n"},
                                           {"segments/0/segment-header.properties", damaged(properties, generator)},
                                           {"segments/0/channels/measuredHeight.dat", channel},
                                           {"segments/0/channels/vDeflection.dat", channel}}));
}

TEST(Import, HandlesIgorWavesDamagedAfterTheChecksum) {
    std::mt19937 generator(31);
    const auto whole = igor_force_file("SpringConstant: 0.5\rIndexes: 0,3,5\r");
    for (int trial = 0; trial < 1000; ++trial) {
        auto content = damaged(whole.substr(0, 384), generator) + whole.substr(384);
        content[2] = content[3] = 0;
        std::uint16_t sum = 0;
        for (std::size_t at = 0; at < 384; at += 2)
            sum = static_cast<std::uint16_t>(sum + static_cast<unsigned char>(content[at]) +
                                             256 * static_cast<unsigned char>(content[at + 1]));
        content.replace(2, 2, bytes_of(std::vector<std::uint16_t>{static_cast<std::uint16_t>(-sum)}));
        must_import_or_refuse(content);
    }
}

TEST(Import, HandlesFlippedBitsInLoopFiles) {
    std::mt19937 generator(99);
    const TemporaryFolder folder;
    const std::string text =
        "# format: setae loop\n# version: 1\n# sphere_radius: 1.25 mm\nforce [N],displacement [m]\n1,2\n3,\n";
    for (int trial = 0; trial < 80; ++trial) {
        const auto path = folder.write("l.csv", damaged(text, generator));
        try {
            (void)tables::read_loop(path);
        } catch (const Error&) {
        }
    }
}

}  // namespace
}  // namespace setae::formats::tests::robustness_test
