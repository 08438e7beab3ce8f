// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/diagnostics/diagnose.hpp"

namespace setae::diagnostics {

/// @throws InvalidArgument for options outside their domain.
void check(const DiagnosisOptions& options);

}  // namespace setae::diagnostics
