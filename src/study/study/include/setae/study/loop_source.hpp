// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/tables/force_curve.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study {

/// Contact radii in a separate file, with the camera's clock, or the recording in which they are measured.
struct CameraInput {
    std::string file;  ///< table with columns time and contact_radius; or a TIFF stack, an AVI, a folder of pictures
    std::optional<std::string> mapping;  ///< mapping of the columns of a foreign table
    std::optional<double> clock_offset;  ///< [s] added to the camera's times; else determined by align_clocks()
    std::optional<double> pixel_size;    ///< [m] for a recording that does not state it
    std::optional<double> frame_rate;    ///< [1/s] for a recording that does not state it
    bool fringes = false;                ///< whether the recording contains Newton's rings around the contact

    friend bool operator==(const CameraInput&, const CameraInput&) = default;
};

/// The files of a loop and metadata that they may not contain.
struct LoopSource {
    std::string file;                    ///< a loop file, a table, a workbook or a force curve
    std::optional<std::string> mapping;  ///< mapping of the columns of a foreign table
    std::optional<CameraInput> camera;
    tables::ForceCurveOptions force_curve;
    tables::ChosenColumns columns{};  ///< columns chosen for force, displacement, contact radius or time

    /// Every file of the loop, including those of a folder of pictures.
    [[nodiscard]] std::vector<std::string> files() const;
};

}  // namespace setae::study
