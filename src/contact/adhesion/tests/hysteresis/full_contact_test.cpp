// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/full_contact.hpp"

#include <deque>
#include <string>

#include <gtest/gtest.h>

namespace setae::hysteresis::full_contact_test {
namespace {

const roughness::ParameterSpread none{};

/// A pair whose U_el/(A W) is `share`, E* known to `error` of it by an input of that name.
RetractionPair pair_of(double share, double error, const std::string& input, double work = 0.04,
                       double rms_slope = 1e-9) {
    static std::deque<roughness::SpectralParameters> kept;  // a pair refers to them
    auto& p = kept.emplace_back();
    p.rms_slope = rms_slope;
    p.elastic_energy_per_modulus = 1e-9;
    const double modulus = share * 0.04 / p.elastic_energy_per_modulus;
    return {.rough = {"A", p, none},
            .soft = {"soft", TracedValue(Estimate{.value = modulus, .standard_error = error * modulus}, input), 0.025},
            .work_of_adhesion = work};
}

TEST(PairsInFullContact, CountPairsBelowTheThresholdWithoutErrors) {
    const auto found =
        pairs_in_full_contact({pair_of(0.1, 0.0, "a"), pair_of(0.29, 0.0, "b"), pair_of(0.31, 0.0, "c")});
    EXPECT_EQ(found.lower, 2);
    EXPECT_EQ(found.upper, 2);
}

// at the share itself each of ten is in or out by chance: binomial, 2.5 % below 2 and above 8 where they are
// independent, all or none where one input moves them
TEST(PairsInFullContact, HaveAWiderRangeForSharedInputs) {
    std::vector<RetractionPair> apart, together;
    for (int i = 0; i < 10; ++i) {
        apart.push_back(pair_of(0.3, 0.1, "E of " + std::to_string(i)));
        together.push_back(pair_of(0.3, 0.1, "calibration"));
    }
    const auto of_apart = pairs_in_full_contact(apart), of_together = pairs_in_full_contact(together);
    EXPECT_EQ(of_apart.lower, 2);
    EXPECT_EQ(of_apart.upper, 8);
    EXPECT_EQ(of_together.lower, 0);
    EXPECT_EQ(of_together.upper, 10);
}

TEST(PairsInFullContact, DoNotCountPairsWithoutGain) {
    const auto found = pairs_in_full_contact({pair_of(0.1, 0.1, "a", 1e-9, 2.0)});
    EXPECT_EQ(found.upper, 0);
}

}  // namespace
}  // namespace setae::hysteresis::full_contact_test
