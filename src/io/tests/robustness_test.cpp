// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include <gtest/gtest.h>

#include "sample_files.hpp"
#include "setae/core/errors.hpp"
#include "setae/io/format.hpp"
#include "setae/io/netcdf.hpp"
#include "setae/io/whole_file.hpp"

namespace setae::io::tests {
namespace {

/// Opens bytes as any format and reads every channel: nothing but setae's own errors may come out.
void must_read_or_refuse(const std::string& content) {
    try {
        for (const auto& channel : open(memory_source("sample", content), {{{1e-6, 1e-6}}, "nm"}))
            try {
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
    const auto xml = x3p_document("SUR", "<AxisType>I</AxisType><DataType>D</DataType><Increment>1e-6</Increment>",
                                  "<AxisType>A</AxisType><DataType>I</DataType><Increment>0.001</Increment>",
                                  "<MatrixDimension><SizeX>2</SizeX><SizeY>2</SizeY><SizeZ>1</SizeZ></MatrixDimension>",
                                  "<DataList><Datum>1</Datum><Datum>2</Datum><Datum>3</Datum><Datum>4</Datum></DataList>");
    return {{"xy", "x [um];h [um]\n0,5;1,5\n1,5;2,5\n2,5;3,5\n"},
            {"matrix", "# Channel: a\n# Width: 1 um\n# Height: 1 um\n# Value units: nm\n1 2 3\n4 5 6\n"},
            {"nanoscope", nanoscope_file(6, 5, 2)},
            {"x3p list", xml},
            {"x3p", zip_archive({{"main.xml", xml}})},
            {"container", container_file()},
            {"npy", "\x93NUMPY\x01" + std::string(1, '\0') + "\x3e" + std::string(1, '\0') +
                        "{'descr': '<i2', 'fortran_order': False, 'shape': (2, 2), }   \n12345678"},
            {"netcdf", read_file(folder.path("t.nc"))}};
}

TEST(Readers, SurviveTruncationAnywhere) {
    for (const auto& [name, content] : samples()) {
        SCOPED_TRACE(name);
        const auto stride = std::max<std::size_t>(1, content.size() / 600);
        for (std::size_t length = 0; length < content.size(); length += stride) must_read_or_refuse(content.substr(0, length));
    }
}

TEST(Readers, SurviveFlippedBits) {
    std::mt19937 generator(12345);
    for (const auto& [name, content] : samples()) {
        SCOPED_TRACE(name);
        for (int trial = 0; trial < 800; ++trial) {
            auto damaged = content;
            const auto flips = 1 + generator() % 4;
            for (std::size_t k = 0; k < flips; ++k) damaged[generator() % damaged.size()] ^= static_cast<char>(1u << (generator() % 8));
            must_read_or_refuse(damaged);
        }
    }
}

TEST(Readers, SamplesAreReadUndamaged) {
    for (const auto& [name, content] : samples())
        EXPECT_NO_THROW((void)open(memory_source(name, content), {{{1e-6, 1e-6}}, "nm"}).front().read()) << name;
}

}  // namespace
}  // namespace setae::io::tests
