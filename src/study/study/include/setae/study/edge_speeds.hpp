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
/// states the rate dependence.
struct ElastomerEdgeSpeed {
    hysteresis::TracedEdgeSpeed law;
    std::optional<Estimate> threshold;  ///< G of the references' edges at zero speed [J/m²]; absent where the study
                                        ///< states the rate dependence
    int references = 0;                 ///< number of loops on the smooth reference to which it is fitted
};

/// The rate dependence that the study states, else that of all retracting edges of the elastomer's references: G at
/// three speeds by each, loops::fit_crack_speed(), weighted by the inverse of their covariance; where they differ by
/// more than that, their standard errors are increased accordingly.
[[nodiscard]] loops::Outcome<ElastomerEdgeSpeed> edge_speed_of(const StudyResult& result, const std::string& elastomer);

/// Terms of the bulk relaxation, as the study states them.
[[nodiscard]] std::vector<hysteresis::TracedRelaxation> relaxation_of(const StudyResult& result,
                                                                      const std::string& elastomer);

/// Motion and reading of loops of a pair.
struct PairDrive {
    loops::LoopDrive drive;
    double reading_time = 0.0;  ///< time span of the last points of Eq. S2 [s]
};

/// The mean over loops of the pair, else over those of its elastomer, else the values that the study states for
/// predicted loops. Empty where none is known.
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
        made<T>("exponent", "n", "1", "n", [](const T& of) { return of.law.exponent; }).as("speed_exponent"),
        quantity<&T::threshold>("threshold", "G0", "J/m2", "threshold G0 of the references"),
        inner<&T::law>(),
    };
    static constexpr Description description{"", "W_ret(v) = φ W [1 + (v/v0)^n]", rows};
};
static_assert(complete<study::ElastomerEdgeSpeed>);

}  // namespace setae::fields
