// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/tables/force_curve.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study {

/// Contact radii in a file of their own, on the camera's clock, or the recording they are measured in.
struct CameraInput {
    std::string file;  ///< table with columns time and contact_radius; or a TIFF stack, an AVI, a folder of pictures
    std::optional<std::string> mapping;  ///< names the columns of a foreign table
    std::optional<double> clock_offset;  ///< [s] added to the camera's times; else found by align_clocks()
    std::optional<double> pixel_size;    ///< [m] of a recording that does not state it
    std::optional<double> frame_rate;    ///< [1/s] of a recording, likewise
    bool fringes = false;                ///< the recording shows Newton's rings around the contact

    friend bool operator==(const CameraInput&, const CameraInput&) = default;
};

/// The files a loop comes from and what they may not say themselves.
struct LoopSource {
    std::string file;                    ///< a loop file, a table, a workbook or a force curve
    std::optional<std::string> mapping;  ///< names the columns of a foreign table
    std::optional<CameraInput> camera;
    tables::ForceCurveOptions force_curve;
    tables::ChosenColumns columns{};  ///< chosen for force, displacement, contact radius or time

    /// Every file it names, those of a folder of pictures one by one.
    [[nodiscard]] std::vector<std::string> files() const;
};

}  // namespace setae::study
