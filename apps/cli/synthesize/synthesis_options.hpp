// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/options.hpp"
#include "setae/answers/synthesis.hpp"

namespace setae::cli {

/// Options of commands that make surfaces.
struct SynthesisOptions : answers::SynthesisRequest {
    void add_to(Options& options) { options.ask<answers::SynthesisRequest>(*this); }
};

}  // namespace setae::cli
