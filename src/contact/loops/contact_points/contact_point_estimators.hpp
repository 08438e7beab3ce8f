// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/contact_point.hpp"

namespace setae::loops {

/// What one method says of the contact point [m]. @throws UndefinedDataError with the reason where it says nothing.
[[nodiscard]] Estimate estimated_contact_point(ContactPointMethod method, const ContactPointInputs& inputs,
                                               const LensAndCounterBody& bodies);

}  // namespace setae::loops
