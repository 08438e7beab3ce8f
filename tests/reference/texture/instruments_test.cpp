// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/formats/channel.hpp"
#include "setae/texture/height_parameters.hpp"
#include "setae/texture/profile_parameters.hpp"
#include "setae/topography/detrend.hpp"

namespace instruments_test {

using namespace setae;
using namespace setae::texture;

/// A number of the certificate, such as "3.308 µm", in SI, with half its last digit.
struct Printed {
    double value;
    double rounding;
};

Printed printed(const topography::Measurement& measurement, const std::string& name) {
    const auto& text = topography::metadata(measurement).attributes.at(name);
    const auto number = text.substr(0, text.find(' '));
    const auto digits = number.size() - 1 - number.find('.');
    const double unit = text.find("µm") != std::string::npos ? 1e-6 : text.find('%') != std::string::npos ? 1e-2 : 1.0;
    return {std::stod(number) * unit, 0.5001 * std::pow(10.0, -static_cast<double>(digits)) * unit};
}

class SurfTest : public testing::Test {
protected:
    void SetUp() override {
        SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/mitutoyo_2_mock.xlsx");
        line = formats::read(path.string());
        // N 4, cut-off 2.5 mm, ISO 1997: four sections of the filtered profile, parameters of each averaged
        const auto rows = profile_parameters(
            line, {.section_length = 2.5e-3, .averages = Averages::sections, .mean_line = MeanLine::zero});
        for (const auto& row : rows) values[row.quantity.symbol] = row.quantity.estimate.value;
    }
    topography::Measurement line;
    std::map<std::string, double> values;
};

TEST_F(SurfTest, ParametersMatchTheInstrumentToItsLastDigit) {
    const std::map<std::string, std::string> names{{"Ra", "Ra"},      {"Rq", "Rq"}, {"Rsk", "Rsk"}, {"Rku", "Rku"},
                                                   {"Rp", "Rp"},      {"Rv", "Rv"}, {"Rz", "Rz"},   {"Rt", "Rt"},
                                                   {"Rzx", "Rz1max"}, {"Rc", "Rc"}, {"RSm", "RSm"}, {"Rdq", "RDq"}};
    for (const auto& [ours, theirs] : names) {
        const auto expected = printed(line, theirs);
        EXPECT_NEAR(values.at(ours), expected.value, expected.rounding) << ours;
    }
}

TEST_F(SurfTest, CoreParametersAreCloseToThoseOfTheInstrument) {
    // presumably the instrument takes them behind the filter of ISO 13565-1, of a profile the file does not hold
    const std::map<std::string, std::string> names{{"Rk", "Rk"}, {"Rpk", "Rpk"}, {"Rvk", "Rvk"}, {"Rmrk2", "Mr2"}};
    for (const auto& [ours, theirs] : names)
        EXPECT_NEAR(values.at(ours) / printed(line, theirs).value, 1.0, 0.08) << ours;
    // its A1 and A2 are the triangles of its other numbers, as ours are
    EXPECT_NEAR(printed(line, "A1").value, 50.0 * printed(line, "Rpk").value * 1e6 * printed(line, "Mr1").value, 0.01);
    EXPECT_NEAR(values.at("Rak1"), 0.5 * values.at("Rpk") * values.at("Rmrk1"), 1e-12);
}

TEST(Mirrors, RmsHeightsOfDabamMatchPublishedValues) {
    for (const auto& [name, rms, tolerance] : {std::tuple{"dabam-010", 3.048414e-9, 2e-6},
                                               {"dabam-011", 3.23343e-9, 2e-6},
                                               {"dabam-014", 15.372782e-9, 1e-2}}) {
        SETAE_REQUIRE_REFERENCE_DATA(path, std::string("topography/profiles/") + name + ".dat");
        const auto heights =
            height_parameters(topography::detrended(formats::read(path.string()), topography::Trend::parabola));
        const auto n = static_cast<double>(heights.defined);
        EXPECT_NEAR(heights.Sq * std::sqrt(n / (n - 1.0)) / rms, 1.0, tolerance) << name;  // published with n − 1
    }
}

}  // namespace instruments_test
