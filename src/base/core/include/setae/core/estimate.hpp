// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "setae/core/constants.hpp"

namespace setae {

/// Lower and upper end of an interval at the given confidence level.
struct Interval {
    double lower = 0.0;
    double upper = 0.0;
    double level = 0.95;
};

/// A value and its uncertainty; the only type for this purpose.
///
/// `method` is the origin of the uncertainty: "given", "delta", "fit covariance", "bootstrap bca", "jackknife t", …
/// Without a stored interval, interval_of() computes one from the standard error.
struct Estimate {
    double value = 0.0;
    double standard_error = undefined;  ///< NaN if unknown; 0 if the value is exact
    std::string method{};
    std::optional<Interval> interval{};
    std::optional<double> degrees_of_freedom{};  ///< of the standard error; absent if the standard error is exact
    std::optional<std::uint64_t> seed{};         ///< of the random numbers used
    std::string input{};  ///< name of the input variable, if the value is one: two values with one name are the same
                          ///< input

    /// Whether there is a standard error > 0.
    [[nodiscard]] bool uncertain() const { return standard_error > 0.0; }
    /// Square of the standard error, as a term of a sum of variances: 0 if unknown.
    [[nodiscard]] double variance() const { return uncertain() ? standard_error * standard_error : 0.0; }
};

/// The interval of the estimate if it has one, otherwise value ± t SE with Student's t at its degrees of freedom (the
/// normal quantile if they are absent); empty without a standard error > 0.
[[nodiscard]] std::optional<Interval> interval_of(const Estimate& estimate, double level = 0.95);

/// The estimate in another unit: value, standard error and interval times a factor; the ends of the interval are
/// exchanged for factors < 0.
[[nodiscard]] Estimate scaled(Estimate estimate, double factor);

/// later − earlier of independent estimates; method "delta", Welch–Satterthwaite degrees of freedom if at least one has
/// them.
[[nodiscard]] Estimate difference(const Estimate& later, const Estimate& earlier);

}  // namespace setae
