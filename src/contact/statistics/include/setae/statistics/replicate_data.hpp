// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/core/constants.hpp"

namespace setae::statistics {

/// One measured value: the fit of one loop, say.
struct Replicate {
    double value = undefined;           ///< finite
    double standard_error = undefined;  ///< within the fit, >= 0; NaN where unknown
    std::vector<std::string> groups;  ///< a label for each level, outermost first; the same label within another outer
                                      ///< group is another group
    std::string name;                 ///< for the reader: a file, a line
};

/// A row that is left out of the mean, and why.
struct Exclusion {
    std::size_t row = 0;
    std::string reason;  ///< never empty
};

/// Values of one quantity from all surfaces.
struct ReplicateData {
    std::vector<std::string> levels{"surface", "lens",
                                    "spot"};  ///< outermost first; the first is the surface, a fixed effect
    std::vector<std::string> crossed;  ///< levels whose labels name the same group on every surface, such as a lens
                                       ///< that was pressed on all of them; groups of the others lie on one surface
    std::vector<Replicate> rows;
    std::vector<Exclusion> exclusions;
    std::string quantity = "value";  ///< what the values are, for messages and figures
    std::string unit = "1";          ///< of value and standard error
};

}  // namespace setae::statistics
