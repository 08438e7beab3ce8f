// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "setae/answers/loops.hpp"
#include "setae/fields/describe.hpp"
#include "setae/loops/machine_stiffness.hpp"

namespace setae::answers {

/// Stiffness of the testing machine from its loop on a rigid body.
/// @throws as loops::machine_stiffness_from_rigid_contact().
[[nodiscard]] loops::MachineStiffness machine_stiffness(const study::OpenedLoop& rigid);

/// Output of `setae jkr stiffness` for one file.
struct StiffnessOfFile {
    std::string file;
    loops::MachineStiffness found;
};

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::answers::StiffnessOfFile> {
    using T = answers::StiffnessOfFile;
    static std::optional<Estimate> if_known(const Estimate& estimate) {
        return std::isfinite(estimate.value) ? std::optional(estimate) : std::nullopt;
    }
    static constexpr std::array rows{
        field<&T::file>("file", "name of the file as it was given"),
        made<T>("n", "number of samples", [](const T& of) { return of.found.n; }),
        made<T>("hysteresis",
                "largest difference of the stage between the branches at one force, divided by the deflection; null "
                "without an unloading branch",
                [](const T& of) { return of.found.hysteresis; }),
        made<T>("nonlinearity", "change of slope from the lower to the upper half of the forces, divided by the slope",
                [](const T& of) { return of.found.nonlinearity; }),
        made<T>("machine_stiffness", "k", "N/m", "stiffness k of the testing machine",
                [](const T& of) { return of.found.stiffness; }),
        made<T>("loading", "k", "N/m", "stiffness of the loading branch", [](const T& of) { return of.found.loading; }),
        made<T>("unloading", "k", "N/m", "stiffness of the unloading branch; null without an unloading branch",
                [](const T& of) { return if_known(of.found.unloading); })
            .or_null(),
        inner<&T::found>(),
    };
    static constexpr Description description{"", "stiffness of a testing machine", rows};
};
static_assert(setae::fields::complete<setae::answers::StiffnessOfFile>);
