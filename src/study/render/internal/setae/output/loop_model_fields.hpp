// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Contact models fitted to a loop beside JKR, as JSON has them.

#include <string>

#include "setae/fields/describe.hpp"
#include "setae/loops/crack_speed_fit.hpp"
#include "setae/loops/model_fits.hpp"
#include "setae/loops/profile_likelihood.hpp"
#include "setae/output/json.hpp"
#include "setae/study/loop_models.hpp"

namespace setae::output {

/// A parameter with its profile likelihood.
struct ProfiledQuantity {
    Quantity value;
    const loops::ParameterProfile* profile;
};

}  // namespace setae::output

namespace setae::fields {

template <>
struct Described<output::ProfiledQuantity> {
    using T = output::ProfiledQuantity;
    static constexpr std::array rows{
        quantity_fields<T>([](const T& of) -> const Quantity& { return of.value; }),
        made<T>("values", "values at which the other parameters were fitted",
                [](const T& of) -> const Array1D& { return of.profile->values; }),
        made<T>("chi_squared_rise", "χ² above its minimum at each value",
                [](const T& of) -> const Array1D& { return of.profile->chi2_rise; }),
        made<T>("threshold", "rise of χ² at the ends of the interval",
                [](const T& of) { return of.profile->threshold; }),
        inner<&T::value>(),
        inner<&T::profile>(),
    };
    static constexpr Description description{"profiled_quantity", "a quantity with its profile likelihood", rows};
};
static_assert(complete<output::ProfiledQuantity>);

template <>
struct Described<loops::ProfileLikelihood> {
    using T = loops::ProfileLikelihood;
    static constexpr std::array rows{
        made<T>("method", "fit method", [](const T& of) { return of.fit.method; }),
        made<T>("contact_modulus", "E*, in Pa",
                [](const T& of) {
                    return output::ProfiledQuantity{
                        output::quantity("contact_modulus", "E*", of.contact_modulus.estimate, "Pa"),
                        &of.contact_modulus};
                }),
        made<T>("work_of_adhesion", "W, in J/m²",
                [](const T& of) {
                    return output::ProfiledQuantity{
                        output::quantity("work_of_adhesion", "W", of.work_of_adhesion.estimate, "J/m2"),
                        &of.work_of_adhesion};
                }),
        inner<&T::contact_modulus>(),
        inner<&T::work_of_adhesion>(),
        inner<&T::fit>(),
    };
    static constexpr Description description{"", "intervals by profile likelihood", rows};
};
static_assert(complete<loops::ProfileLikelihood>);

template <>
struct Described<study::LoopModels> {
    using T = study::LoopModels;
    static constexpr std::array rows{
        field<&T::fits>("fits", "fits of contact models").with(Missing::left_out),
        field<&T::comparison>("comparison", "models compared by Akaike's criterion"),
        field<&T::profile>("profile_likelihood", "intervals by profile likelihood"),
        field<&T::crack_speed>("crack_speed", "fit of the energy release rate against the speed of the crack"),
        field<&T::failures>("failures", "models that could not be fitted, with the reason").with(Missing::left_out),
    };
    static constexpr Description description{"loop_models", "contact models fitted beside JKR", rows};
};
static_assert(complete<study::LoopModels>);

}  // namespace setae::fields
