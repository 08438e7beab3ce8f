// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "jkr/loop_arguments.hpp"
#include "program/options.hpp"
#include "setae/loops/force_curve_fit.hpp"

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
    [[nodiscard]] loops::ForceCurveFitOptions options() const;
};

/// Every segment of a curve with its fit.
[[nodiscard]] std::vector<loops::NamedCurveFit> fit_curve(const std::string& file, const LoopArguments& loops,
                                                          const BodyArguments& bodies, const CurveArguments& curve);
void print_curve(const std::string& file, const std::vector<loops::NamedCurveFit>& segments);

}  // namespace setae::cli
