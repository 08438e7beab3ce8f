// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "jkr/loop_arguments.hpp"
#include "program/options.hpp"
#include "setae/loops/force_curve_summary.hpp"
#include "setae/study/force_map.hpp"

namespace setae::cli {

/// Options of `setae jkr fit` for force curves: force and displacement alone, contact found where the force leaves the
/// baseline.
struct CurveArguments {
    bool curve = false;
    std::string tip = "paraboloid";
    double half_angle = 0.0;  ///< degrees
    std::string model = "hertz", range, contact_point = "fit";
    bool keep_baseline_slope = false;

    void add_to(Options& options);
    /// Whether a file is treated as one: asked for, or a force curve by its format.
    [[nodiscard]] bool concerns(const std::string& file) const;
    /// Whether all of several force curves in a file are wanted.
    [[nodiscard]] bool concerns_map(const std::string& file, const LoopArguments& loops) const;
    [[nodiscard]] loops::ForceCurveFitOptions options() const;
    /// The tip and the sample; a tip that is no paraboloid needs no radius.
    [[nodiscard]] loops::LensAndCounterBody bodies(const BodyArguments& given, const Table& of_curve) const;
};

/// Every segment of a curve with its fit, and what they say together.
[[nodiscard]] loops::ForceCurveAnalysis fit_curve(const std::string& file, const LoopArguments& loops,
                                                  const BodyArguments& bodies, const CurveArguments& curve);
void print_curve(const std::string& file, const loops::ForceCurveAnalysis& analysis);

/// Every curve of a file of several.
[[nodiscard]] study::ForceMap fit_map(const std::string& file, const LoopArguments& loops, const BodyArguments& bodies,
                                      const CurveArguments& curve, parallel::Threads threads);
void print_map(const study::ForceMap& map);

}  // namespace setae::cli
