// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/options.hpp"
#include "setae/answers/self_affine.hpp"

namespace setae::cli {

/// --fit and what belongs to it.
struct FitOptions : answers::SelfAffineRequest {
    void add_to(Options& options);
};

}  // namespace setae::cli
