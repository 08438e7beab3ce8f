// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/options.hpp"
#include "setae/answers/texture.hpp"

namespace setae::cli {

/// Options of `setae params --standard`.
struct TextureOptions : answers::TextureRequest {
    void add_to(Options& options);
};

}  // namespace setae::cli
