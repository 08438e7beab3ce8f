// SPDX-License-Identifier: GPL-3.0-or-later
#include "nanonis_samples.hpp"

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {

std::string nanonis_file(const Array2D& z, const std::string& direction, const std::string& range,
                         const std::string& type) {
    ByteBuilder file(std::endian::big);
    file.text(":NANONIS_VERSION:\n2\n:SCANIT_TYPE:\n              " + type +
              "\n:REC_DATE:\n 23.11.2008\n:REC_TIME:\n10:11:12\n:SCAN_PIXELS:\n       " + std::to_string(z.rows()) +
              "       " + std::to_string(z.cols()) + "\n:SCAN_RANGE:\n           " + range +
              "\n:SCAN_ANGLE:\n            0.000E+0\n:SCAN_DIR:\n" + direction +
              "\n:BIAS:\n            1.000E-1\n:Z-CONTROLLER:\n\tName\ton\n\tlog Current\t1\n\n:DATA_INFO:\n"
              "\tChannel\tName\tUnit\tDirection\tCalibration\tOffset\n"
              "\t14\tZ\tm\tboth\t1.000E+0\t0.000E+0\n\t0\tCurrent\tA\tforward\t1.000E+0\t0.000E+0\n\n"
              ":SCANIT_END:\n\n\n\x1a\x04");
    const Array2D scanned = direction == "up" ? Array2D(z.rowwise().reverse()) : z;
    file.rows<float>(scanned);
    file.rows<float>(Array2D(scanned.colwise().reverse()));
    file.rows<float>(Array2D(0.0 * scanned.isNaN().select(0.0, scanned)));
    return file.content();
}

std::vector<FormatSample> nanonis_samples() {
    Array2D map = lopsided_heights(6, 4, units::nm);
    std::vector<FormatSample> samples;
    for (const char* direction : {"down", "up"})
        for (const std::size_t channel : {std::size_t{0}, std::size_t{1}}) {
            auto scanned = map;
            scanned.col(direction == std::string("up") ? 0 : 3) = undefined;  // the last line was not scanned
            samples.push_back({.format = "nanonis",
                               .name = std::string(direction) + (channel == 0 ? " forward" : " backward"),
                               .content = nanonis_file(scanned, direction, "3.000000E-6         2.000000E-6"),
                               .channel = channel,
                               .shape = {6, 4},
                               .size = {3e-6, 2e-6},
                               .heights = scanned,
                               .tolerance = 1e-6});
        }
    return samples;
}

}  // namespace setae::formats::tests
