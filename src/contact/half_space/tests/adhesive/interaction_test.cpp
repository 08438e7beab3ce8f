// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/interaction.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::half_space::interaction_test {
namespace {

constexpr double w = 0.05, range = 2e-9;
constexpr AttractionLaw laws[] = {AttractionLaw::exponential, AttractionLaw::cubic, AttractionLaw::dugdale,
                                  AttractionLaw::lennard_jones};

TEST(Attraction, HasItsWorkAndMaximumTensionInContact) {
    for (const auto law : laws) {
        const auto here = attraction(0.0, {w, range, law});
        EXPECT_NEAR(here.energy / w, -1.0, 1e-15) << name_of(law);
        EXPECT_NEAR(here.tension / (w / range), 1.0, 1e-15) << name_of(law);
        EXPECT_NEAR(attraction(1e5 * range, {w, range, law}).energy / w, 0.0, 1e-9) << name_of(law);
        EXPECT_EQ(attraction_law_named(name_of(law)), law);
    }
    EXPECT_THROW((void)attraction_law_named("magnetic"), InvalidArgument);
}

TEST(Attraction, HasTheDerivativesOfItsEnergyAndIsConcave) {
    for (const auto law : laws) {
        const Interaction interaction{w, range, law};
        const double step = 1e-5 * range;
        for (const double gap : {0.1, 0.7, 1.3, 2.5, 3.5}) {
            const auto below = attraction(gap * range - step, interaction), at = attraction(gap * range, interaction),
                       above = attraction(gap * range + step, interaction);
            EXPECT_NEAR((above.energy - below.energy) / (2.0 * step), at.tension, 1e-8 * w / range) << name_of(law);
            EXPECT_NEAR((above.tension - below.tension) / (2.0 * step), at.slope, 1e-8 * w / (range * range));
            EXPECT_LE(at.slope, 0.0);
        }
    }
}

TEST(Attraction, OfARowEqualsThatOfItsPoints) {
    const Array1D gaps = Array1D::LinSpaced(7, 0.0, 5.0 * range);
    for (const auto law : laws) {
        const Interaction interaction{w, range, law};
        const double slope_unit = w / (range * range);
        Array1D tensions(7);
        Eigen::ArrayXf slopes(7);
        const double energy = attraction(7, gaps.data(), interaction, tensions.data(), slopes.data(), slope_unit);
        double sum = 0.0;
        for (Index i = 0; i < 7; ++i) {
            const auto one = attraction(gaps[i], interaction);
            sum += one.energy;
            EXPECT_NEAR(tensions[i], one.tension, 1e-15 * w / range) << name_of(law);
            EXPECT_NEAR(slopes[i], one.slope / slope_unit, 1e-7) << name_of(law);
        }
        EXPECT_NEAR(energy, sum, 1e-14 * w) << name_of(law);
    }
}

TEST(Resolution, RefusesPixelsThatPinTheEdge) {
    const Body body{.contact_modulus = 1e9};
    const Interaction interaction{w, range};
    const double limit = range * range * 1e9 / w;
    const Grid fine{64, 64, 64.0 * limit, 32.0 * limit};
    EXPECT_NEAR(resolution_of(interaction, body, fine).squared_ratio, 1.0, 1e-12);
    EXPECT_NO_THROW(require(interaction, body, fine));
    try {
        require(interaction, body, {64, 64, 32.0 * limit, 128.0 * limit});
        FAIL() << "two limits a pixel";
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("128 x 128 points"), std::string::npos) << error.what();
    }
    EXPECT_NO_THROW(require(interaction, body, {1, 64, 1.0, 64.0 * limit}));  // its length has no pixels
    EXPECT_THROW(require({0.0, range}, body, fine), InvalidArgument);
    EXPECT_THROW(require({w, -range}, body, fine), InvalidArgument);
}

}  // namespace
}  // namespace setae::half_space::interaction_test
