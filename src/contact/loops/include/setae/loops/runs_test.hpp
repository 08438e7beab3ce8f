// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/fields/describe.hpp"

namespace setae::loops {

/// Number of runs of one sign in the ordered residuals.
struct RunsTest {
    Index runs = 0;
    Index above = 0;             ///< residuals > 0
    Index below = 0;             ///< residuals < 0
    double p_value = undefined;  ///< P(as few runs or fewer); NaN where all residuals have one sign
};

/// Test of Wald and Wolfowitz of whether residuals keep their sign longer than by chance.
///
/// One-sided: a model with a wrong shape of the curve, and correlated noise, give too few runs; too many runs are not
/// tested. Exact for up to 50 residuals, beyond that the normal approximation with half a run's correction. Zeros are
/// left out. Residuals that are correlated by the recording itself (a filter, drift) fail the test, too.
/// Source: Wald, Wolfowitz, Ann. Math. Stat. 11 (1940) 147.
[[nodiscard]] RunsTest runs_test(const ArrayView1D& residuals);

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::RunsTest> {
    using T = loops::RunsTest;
    static constexpr std::array rows{
        field<&T::runs>("runs", "runs of residuals of one sign"),
        field<&T::above>("above", "residuals above 0"),
        field<&T::below>("below", "residuals below 0"),
        field<&T::p_value>("p_value", "probability of so few or so many runs by chance"),
    };
    static constexpr Description description{"runs_test", "test of the signs of residuals (Wald and Wolfowitz)", rows};
};
static_assert(complete<loops::RunsTest>);

}  // namespace setae::fields
