// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Outputs of `setae jkr fit` and `setae jkr energy` for loops.

#include <optional>
#include <string>

#include "setae/answers/loops.hpp"
#include "setae/fields/describe.hpp"
#include "setae/loops/global_fit.hpp"
#include "setae/output/loop_model_fields.hpp"

namespace setae::answers {

/// A fit of several loops with parameters that they share; the loops are added later.
struct SharedLoops {
    const loops::GlobalFit* fit;
};

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::FittedLoop> {
    using T = answers::FittedLoop;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const loops::LoopAnalysis& { return of.loop->analysis; }),
        made<T>("file", "name of the file as it was given",
                [](const T& of) -> const std::string& { return of.loop->file; }),
        field<&T::models>("models", "contact models that are fitted in addition to JKR"),
        inner<&T::loop>(),
    };
    static constexpr Description description{"fitted_loop", "fits to a loop", rows};
};
static_assert(complete<answers::FittedLoop>);

template <>
struct Described<answers::SharedLoops> {
    using T = answers::SharedLoops;
    static constexpr std::array rows{
        list_filled_later<answers::FittedLoop>("loops", "one entry per loop"),
        made<T>("shared", "fit with parameters that the loops share",
                [](const T& of) -> const loops::GlobalFit& { return *of.fit; }),
        inner<&T::fit>(),
    };
    static constexpr Description description{"", "fits to loops that share parameters", rows};
};
static_assert(complete<answers::SharedLoops>);

}  // namespace setae::fields
