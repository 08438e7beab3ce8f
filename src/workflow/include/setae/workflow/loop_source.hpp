// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/io/force_curve.hpp"

namespace setae::workflow {

/// Contact radii in a file of their own, on the camera's clock.
struct CameraInput {
    std::string file;                    ///< table with columns time and contact_radius
    std::optional<std::string> mapping;  ///< names the columns of a foreign table
    std::optional<double> clock_offset;  ///< [s] added to the camera's times; else found by align_clocks()

    friend bool operator==(const CameraInput&, const CameraInput&) = default;
};

/// The files a loop comes from and what they may not say themselves.
struct LoopSource {
    std::string file;                    ///< a loop file, a table, a workbook or a force curve
    std::optional<std::string> mapping;  ///< names the columns of a foreign table
    std::optional<CameraInput> camera;
    io::ForceCurveOptions force_curve;

    /// Every file it names.
    [[nodiscard]] std::vector<std::string> files() const;
};

}  // namespace setae::workflow
