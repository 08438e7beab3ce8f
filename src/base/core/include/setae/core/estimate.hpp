// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "setae/core/constants.hpp"

namespace setae {

/// Lower and upper end of an interval at the confidence level named.
struct Interval {
    double lower = 0.0;
    double upper = 0.0;
    double level = 0.95;
};

/// A value with what is known of its uncertainty: the one type for it, everywhere.
///
/// `method` says how the uncertainty was found: "given", "delta", "fit covariance", "bootstrap bca", "jackknife t", …
/// Without an interval of its own, interval_of() makes one from the standard error.
struct Estimate {
    double value = 0.0;
    double standard_error = undefined;  ///< NaN where none is known; 0 where the value counts as exact
    std::string method{};
    std::optional<Interval> interval{};
    std::optional<double> degrees_of_freedom{};  ///< of the standard error; absent where it counts as known
    std::optional<std::uint64_t> seed{};         ///< of the random numbers behind it
    std::string input{};  ///< name of the input that it is, where it is one: two values of one name are one input

    /// Whether there is a standard error > 0.
    [[nodiscard]] bool uncertain() const { return standard_error > 0.0; }
    /// Square of the standard error, as a term of a sum of variances: 0 where none is known.
    [[nodiscard]] double variance() const { return uncertain() ? standard_error * standard_error : 0.0; }
};

/// The estimate's own interval where it has one, else value ± t SE with Student's t at its degrees of freedom (the
/// normal quantile where they are absent); nothing without a standard error > 0.
[[nodiscard]] std::optional<Interval> interval_of(const Estimate& estimate, double level = 0.95);

/// The estimate in another unit: value, standard error and interval times a factor, the interval turned for factors <
/// 0.
[[nodiscard]] Estimate scaled(Estimate estimate, double factor);

/// later − earlier of independent estimates; method "delta", Welch–Satterthwaite degrees of freedom where one has any.
[[nodiscard]] Estimate difference(const Estimate& later, const Estimate& earlier);

}  // namespace setae
