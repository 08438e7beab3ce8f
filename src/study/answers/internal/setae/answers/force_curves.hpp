// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "setae/answers/loops.hpp"
#include "setae/fields/option.hpp"
#include "setae/loops/force_curve_summary.hpp"
#include "setae/study/force_map.hpp"

namespace setae::answers {

/// Request of `setae jkr fit` for force curves: only force and displacement, contact where the force leaves the
/// baseline.
struct CurveRequest {
    bool curve = false;
    std::string tip = "paraboloid";
    double half_angle = 0.0;  ///< degrees
    std::string model = "hertz", range, contact_point = "fit";
    bool keep_baseline_slope = false;

    /// Whether a file is treated as a force curve: on request, or by its format.
    [[nodiscard]] bool concerns(const std::string& file) const;
    /// Whether all of several force curves in a file are requested.
    [[nodiscard]] bool concerns_map(const std::string& file, const LoopFiles& loops) const;
    /// @throws InvalidArgument for a malformed text.
    [[nodiscard]] loops::ForceCurveFitOptions options() const;
    /// The tip and the sample; a tip that is no paraboloid needs no radius.
    /// @throws InvalidArgument for a value with ±, which fits of force curves take for exact.
    [[nodiscard]] loops::LensAndCounterBody bodies(const LoopBodies& given, const Table& of_curve) const;
};

/// Every segment of a curve with its fit, and their common result. @throws what reading and fitting throw.
[[nodiscard]] loops::ForceCurveAnalysis fit_curve(const std::string& file, const LoopFiles& loops,
                                                  const LoopBodies& bodies, const CurveRequest& curve);

/// Every curve of a file with several.
[[nodiscard]] study::ForceMap fit_map(const std::string& file, const LoopFiles& loops, const LoopBodies& bodies,
                                      const CurveRequest& curve, parallel::Threads threads = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::CurveRequest> {
    using R = answers::CurveRequest;
    static constexpr std::array<std::string_view, 3> tips{"paraboloid", "cone", "three_sided_pyramid"};
    static constexpr std::array options{
        option<&R::curve>("curve",
                          "tables are force curves: force and displacement without visible adhesion; AFM files always "
                          "are"),
        option<&R::tip>("tip", "shape of the tip of a force curve").one_of(tips).default_shown(),
        option<&R::half_angle>("half_angle",
                               "half angle of a conical tip, or inclination of a pyramid's faces, in degrees"),
        option<&R::model>("curve_model",
                          "contact model of a force curve: hertz, dmt, jkr, maugis_dugdale or large_strain")
            .default_shown()
            .in_python("model"),
        option<&R::range>("fit_range",
                          "range of a force curve that is fitted, FROM:TO in indentation, force or shares of the "
                          "largest indentation")
            .such_as("0 nm:500 nm")
            .or_else("-1:1"),
        option<&R::contact_point>(
            "curve_contact_point",
            "contact point of a force curve: fit, found (where the force leaves the baseline), or a length")
            .default_shown()
            .in_python("contact_point"),
        option<&R::keep_baseline_slope>("keep_baseline_slope",
                                        "only the mean of free flight is removed from a force curve, not the slope")
            .advanced(),
    };
};
