// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/contact_point.hpp"

namespace setae::loops {

/// Estimate of the contact point by one method [m]. @throws UndefinedDataError with the reason where it has no result.
[[nodiscard]] Estimate estimated_contact_point(ContactPointMethod method, const ContactPointInputs& inputs,
                                               const LensAndCounterBody& bodies);

}  // namespace setae::loops
