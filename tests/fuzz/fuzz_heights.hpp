// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

#include "fuzz_input.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"

namespace setae::fuzz {

/// What the user says of heights whose file leaves it open.
inline const formats::ReadOptions given{.size = {{1e-6, 1e-6}}, .unit = "nm"};

/// A channel's heights are as it said, or refused; anything else ends the program.
inline void read_heights(const formats::Channel& channel) {
    try {
        const auto measurement = channel.read();
        topography::validate(measurement);
        const auto shape = topography::shape(measurement);
        if (!channel.info.shape.empty() && channel.info.shape[0] != shape[0]) std::abort();
    } catch (const Error&) {
    }
}

}  // namespace setae::fuzz
