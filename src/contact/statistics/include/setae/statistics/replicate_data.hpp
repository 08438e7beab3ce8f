// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/core/constants.hpp"

namespace setae::statistics {

/// One measured value, such as the result of the fit of one loop.
struct Replicate {
    double value = undefined;           ///< finite
    double standard_error = undefined;  ///< standard error of the fit, >= 0; NaN where unknown
    /// a label for each level, outermost first; labels are unique only within the outer group
    std::vector<std::string> groups;
    std::string name;  ///< name for the reader: a file, a line
};

/// A row that is left out of the mean, with the reason.
struct Exclusion {
    std::size_t row = 0;
    std::string reason;  ///< never empty
};

/// Values of one quantity from all surfaces.
struct ReplicateData {
    std::vector<std::string> levels{"surface", "lens",
                                    "spot"};  ///< outermost first; the first is the surface, a fixed effect
    /// levels whose labels are common to all surfaces, such as a lens that was pressed on all of them; groups of the
    /// others are on one surface
    std::vector<std::string> crossed;
    std::vector<Replicate> rows;
    std::vector<Exclusion> exclusions;
    std::string quantity = "value";  ///< name of the values, for messages and figures
    std::string unit = "1";          ///< unit of value and standard error
};

}  // namespace setae::statistics
