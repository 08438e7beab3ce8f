// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// A possible next measurement.
struct Candidate {
    enum class Kind {
        input,    ///< an input with half its standard error
        loop,     ///< one more loop on a pair
        spectrum  ///< a repetition of all measurements of a surface
    };
    Kind kind = Kind::input;
    std::string name;               ///< name of the input or the surface; for a loop, name of its surface
    std::string elastomer{};        ///< elastomer of a loop
    int loops = 1;                  ///< number of loops that the pair has already
    std::optional<double> hours{};  ///< duration in hours, where it is given
};

/// Expected result of a candidate.
struct NextMeasurement {
    Candidate candidate;
    double standard_error = 0.0;  ///< standard error of the target with the candidate
    double gain = 0.0;            ///< relative reduction of the standard error
};

/// Returns a pair as changed by a candidate.
using Change = std::function<PairPoint(const PairPoint&)>;

/// A number that depends on pairs, as a function of a change of all pairs.
using Target = std::function<TracedValue(const Change&)>;

/// W of a fit, fitted again with fixed scatter.
[[nodiscard]] Target work_target(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit);

/// A prediction at that W.
[[nodiscard]] Target prediction_target(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit,
                                       const PairPoint& line);

/// W of one fit minus W of another, as a test of whether two balances, or approach and loss, agree.
[[nodiscard]] Target difference_target(const Target& one, const Target& other);

/// The number without a change.
[[nodiscard]] TracedValue value_of(const Target& target);

/// Standard error of a number with each candidate, by the same model: all fits are made again with the components that
/// the candidate reduces; scatter and expected values are fixed. Sorted by gain, or by gain per hour where every
/// candidate has its hours.
///
///   input: components × ½;  loop: own variance × m/(m + 1);  spectrum: components × 1/√2
///
/// @throws as fit_generalised().
[[nodiscard]] std::vector<NextMeasurement> next_measurements(const Target& target,
                                                             const std::vector<Candidate>& candidates);

}  // namespace setae::adhesion
