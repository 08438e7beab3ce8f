// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/contact/relaxation.hpp"
#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// Additional force of a relaxing bulk in the first contact.
struct BulkForce {
    Index first = 0;  ///< sample of the record
    Array1D force;    ///< from there on [N]
    BulkRelaxation relaxation;
};

/// contact::relaxation_force() of the displacements and contact radii of a record, E* of its loading. Radii between
/// frames are straight; noise that would make them turn back is left out.
/// @throws UndefinedDataError without time or displacement, or for a contact that does not part.
[[nodiscard]] BulkForce bulk_force(const LoopAnalysis& analysis, const LensAndCounterBody& bodies,
                                   const std::vector<contact::RelaxationTerm>& terms);

}  // namespace setae::loops
