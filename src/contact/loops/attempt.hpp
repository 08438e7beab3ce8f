// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/errors.hpp"
#include "setae/loops/outcome.hpp"

namespace setae::loops {

/// The result of a computation, or the message of the missing data that made it impossible.
template <class Computation>
auto attempt(Computation&& computation) -> Outcome<decltype(computation())> {
    try {
        return {computation()};
    } catch (const UndefinedDataError& error) {
        return Outcome<decltype(computation())>::missing(error.what());
    }
}

}  // namespace setae::loops
