// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// Something that could be measured next.
struct Candidate {
    enum class Kind {
        input,    ///< an input known to half its ±
        loop,     ///< one more loop on a pair
        spectrum  ///< as many measurements of a surface again
    };
    Kind kind = Kind::input;
    std::string name;               ///< of the input or the surface; of a loop its surface
    std::string elastomer{};        ///< of a loop
    int loops = 1;                  ///< that the pair has already
    std::optional<double> hours{};  ///< that it takes, where somebody says so
};

/// What a candidate promises.
struct NextMeasurement {
    Candidate candidate;
    double standard_error = 0.0;  ///< of the target with it
    double gain = 0.0;            ///< share by which it is smaller than without
};

/// A pair as it would be with something else known of it.
using Change = std::function<PairPoint(const PairPoint&)>;

/// A number that rests on pairs, as it would be with all of them changed.
using Target = std::function<TracedValue(const Change&)>;

/// W of a fit: made anew, scatter held.
[[nodiscard]] Target work_target(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit);

/// A prediction at that W.
[[nodiscard]] Target prediction_target(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit,
                                       const PairPoint& line);

/// W of one fit less that of another: whether two balances, or approach and loss, say the same.
[[nodiscard]] Target difference_target(const Target& one, const Target& other);

/// The number itself.
[[nodiscard]] TracedValue value_of(const Target& target);

/// What each candidate would leave of the standard error of a number, by the same model: all fits made anew with the
/// components that the candidate shrinks, scatter and expected values held. The largest gain first, or the largest gain
/// an hour where every candidate has its hours.
///
///   input: components × ½;  loop: own variance × m/(m + 1);  spectrum: components × 1/√2
///
/// @throws as fit_generalised().
[[nodiscard]] std::vector<NextMeasurement> next_measurements(const Target& target,
                                                             const std::vector<Candidate>& candidates);

}  // namespace setae::adhesion
