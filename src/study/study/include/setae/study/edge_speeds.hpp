// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/hysteresis/speed_factor.hpp"
#include "setae/loops/loop_drive.hpp"
#include "setae/loops/outcome.hpp"

namespace setae::study {

struct StudyResult;

/// G(v) = G(0) [1 + (v/v0)^n] of an elastomer's smooth edge; φ(0) = G(0)/W_app of the references, 1 where the study
/// states the law.
struct ElastomerEdgeSpeed {
    hysteresis::TracedEdgeSpeed law;
    std::optional<Estimate>
        threshold;       ///< G of the references' edges at rest [J/m²]; without it the study states the law
    int references = 0;  ///< loops on the smooth standard that it is fitted to
};

/// What the study states, else what the receding edges of the elastomer's references say together: G at three speeds by
/// each, loops::fit_crack_speed(), weighted by the inverse of their covariance; where they differ by more than that,
/// their ± grow by it.
[[nodiscard]] loops::Outcome<ElastomerEdgeSpeed> edge_speed_of(const StudyResult& result, const std::string& elastomer);

/// Terms by which its bulk relaxes, as the study states them.
[[nodiscard]] std::vector<hysteresis::TracedRelaxation> relaxation_of(const StudyResult& result,
                                                                      const std::string& elastomer);

/// How loops of a pair are driven and read.
struct PairDrive {
    loops::LoopDrive drive;
    double reading_time = 0.0;  ///< that the last points of (S2) span [s]
};

/// The mean over loops of the pair, without one over those of its elastomer; what the study states of loops to be
/// predicted in their place. Nothing where neither is known.
[[nodiscard]] std::optional<PairDrive> drive_of(const StudyResult& result, const std::string& surface,
                                                const std::string& elastomer);

}  // namespace setae::study

namespace setae::fields {

template <>
struct Described<study::ElastomerEdgeSpeed> {
    using T = study::ElastomerEdgeSpeed;
    static constexpr std::array rows{
        field<&T::references>("references",
                              "number of loops on the smooth reference to which the dependence is fitted; 0 where the "
                              "study states it"),
        made<T>("rest_factor", "φ", "1",
                "factor φ: work of an edge at zero speed on the smooth reference, divided by W_app",
                [](const T& of) { return of.law.rest_factor; }),
        made<T>("reference_speed", "v0", "m/s", "v0", [](const T& of) { return of.law.reference_speed; }),
        made<T>("exponent", "n", "1", "n", [](const T& of) { return of.law.exponent; }),
        quantity<&T::threshold>("threshold", "G0", "J/m2", "threshold G0 of the references"),
        inner<&T::law>(),
    };
    static constexpr Description description{"", "W_ret(v) = φ W [1 + (v/v0)^n]", rows};
};
static_assert(complete<study::ElastomerEdgeSpeed>);

}  // namespace setae::fields
