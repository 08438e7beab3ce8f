// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/study/study.hpp"

namespace setae::study {

/// Missing metadata of a study's file, and their consequence.
struct StudyGap {
    std::size_t line = 0;  ///< line of the study's file, from 1
    std::string item;      ///< the file, elastomer or table it is about
    std::string message;   ///< "no tip_radius of the afm: waves down to 78.1 nm are used"
};

/// Missing metadata of a study read from `study.path`, by line: files that cannot be opened, instruments and tips that
/// neither file nor study states, sizes and units, moduli of elastomers without loops, radii of spheres, columns and
/// constants of loops, and tables in comments with lines `# KEY = "?"`. For a missing value of a measurement the line
/// with its question is given.
///
/// Opens every file; heights are not read.
/// @throws FileError, FormatError where the study's own file is missing or changed.
[[nodiscard]] std::vector<StudyGap> study_gaps(const Study& study);

}  // namespace setae::study
