// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/estimate.hpp"

namespace setae::tests {

/// Departures of estimates from the truth over their standard errors: their root mean square is 1 where errors are
/// what estimates scatter by, below it where errors are too large, which no count of intervals that hold tells.
class Pulls {
public:
    void add(double value, double truth, double standard_error) {
        squares_ += std::pow((value - truth) / standard_error, 2);
        ++count_;
    }
    void add(const Estimate& estimate, double truth) { add(estimate.value, truth, estimate.standard_error); }

    [[nodiscard]] double rms() const { return std::sqrt(squares_ / count_); }
    /// Standard deviation of rms() of normal pulls.
    [[nodiscard]] double scatter() const { return 1.0 / std::sqrt(2.0 * count_); }

private:
    double squares_ = 0.0;
    int count_ = 0;
};

/// Expects errors that are neither too small nor too large: an rms of 1 within three and a half of its standard
/// deviations.
inline void expect_honest(const Pulls& pulls, const char* what = "") {
    EXPECT_NEAR(pulls.rms(), 1.0, 3.5 * pulls.scatter()) << what;
}

}  // namespace setae::tests
