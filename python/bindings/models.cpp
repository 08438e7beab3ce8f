// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "bindings.hpp"
#include "setae/contact/dmt.hpp"
#include "setae/contact/hertz.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/contact/layer.hpp"
#include "setae/contact/maugis_dugdale.hpp"

namespace setae::python {
namespace {

using contact::AdhesiveContact, contact::Branch, contact::SphereOnFlat;
using Values = nb::ndarray<nb::numpy, const double, nb::ndim<1>, nb::c_contig>;
using NewArray = nb::ndarray<nb::numpy, double, nb::ndim<1>>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// An array of NumPy that owns its values.
NewArray owned(Array1D values) {
    auto kept = std::make_unique<Array1D>(std::move(values));
    const nb::capsule owner(kept.get(), [](void* array) noexcept { delete static_cast<Array1D*>(array); });
    auto& array = *kept.release();
    return NewArray(array.data(), {static_cast<std::size_t>(array.size())}, owner);
}

/// f(x) for every x, NaN for NaN, without the lock of the interpreter. The caller holds the array.
template <class Function>
NewArray each(const Values& x, const Function& f) {
    Array1D result(static_cast<Index>(x.size()));
    {
        const nb::gil_scoped_release released;
        for (Index i = 0; i < result.size(); ++i) result[i] = std::isnan(x.data()[i]) ? none : f(x.data()[i]);
    }
    return owned(std::move(result));
}

Branch branch(bool inner) { return inner ? Branch::inner : Branch::outer; }

void bind_hertz(nb::module_& module) {
    module.def(
        "hertz_force",
        [](const Values& displacement, double radius, double contact_modulus) {
            const SphereOnFlat body{radius, contact_modulus};
            return each(displacement, [&](double d) { return d >= 0.0 ? contact::hertz::force(d, body) : none; });
        },
        nb::arg("displacement"), nb::arg("radius"), nb::arg("contact_modulus"));
    module.def(
        "hertz_contact_radius",
        [](const Values& force, double radius, double contact_modulus) {
            const SphereOnFlat body{radius, contact_modulus};
            return each(force, [&](double f) { return f >= 0.0 ? contact::hertz::contact_radius(f, body) : none; });
        },
        nb::arg("force"), nb::arg("radius"), nb::arg("contact_modulus"));
}

void bind_dmt(nb::module_& module) {
    module.def(
        "dmt_force",
        [](const Values& displacement, double radius, double contact_modulus, double work_of_adhesion) {
            const AdhesiveContact body{radius, contact_modulus, work_of_adhesion};
            return each(displacement, [&](double d) { return contact::dmt::force_at_displacement(d, body); });
        },
        nb::arg("displacement"), nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"));
    module.def(
        "dmt_contact_radius",
        [](const Values& force, double radius, double contact_modulus, double work_of_adhesion) {
            const AdhesiveContact body{radius, contact_modulus, work_of_adhesion};
            return each(force, [&](double f) { return contact::dmt::contact_radius_at_force(f, body); });
        },
        nb::arg("force"), nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"));
}

void bind_jkr(nb::module_& module) {
    module.def(
        "jkr_force",
        [](const Values& displacement, double radius, double contact_modulus, double work_of_adhesion, bool inner) {
            const AdhesiveContact body{radius, contact_modulus, work_of_adhesion};
            return each(displacement,
                        [&](double d) { return contact::jkr::force_at_displacement(d, body, branch(inner)); });
        },
        nb::arg("displacement"), nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"),
        nb::arg("inner"));
    module.def(
        "jkr_contact_radius",
        [](const Values& force, double radius, double contact_modulus, double work_of_adhesion, bool inner) {
            const AdhesiveContact body{radius, contact_modulus, work_of_adhesion};
            return each(force, [&](double f) { return contact::jkr::contact_radius_at_force(f, body, branch(inner)); });
        },
        nb::arg("force"), nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"), nb::arg("inner"));
}

void bind_maugis_dugdale(nb::module_& module) {
    using contact::maugis_dugdale::Contact;
    module.def(
        "maugis_dugdale_force",
        [](const Values& displacement, double radius, double contact_modulus, double work_of_adhesion,
           double cohesive_stress, bool inner) {
            const Contact body{radius, contact_modulus, work_of_adhesion, cohesive_stress};
            return each(displacement, [&](double d) {
                return contact::maugis_dugdale::force_at_displacement(d, body, branch(inner));
            });
        },
        nb::arg("displacement"), nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"),
        nb::arg("cohesive_stress"), nb::arg("inner"));
    module.def(
        "maugis_dugdale_contact_radius",
        [](const Values& force, double radius, double contact_modulus, double work_of_adhesion, double cohesive_stress,
           bool inner) {
            const Contact body{radius, contact_modulus, work_of_adhesion, cohesive_stress};
            return each(force, [&](double f) {
                return contact::maugis_dugdale::contact_radius_at_force(f, body, branch(inner));
            });
        },
        nb::arg("force"), nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"),
        nb::arg("cohesive_stress"), nb::arg("inner"));
    module.def(
        "maugis_dugdale_pull_off",
        [](double radius, double contact_modulus, double work_of_adhesion, double cohesive_stress) {
            const Contact body{radius, contact_modulus, work_of_adhesion, cohesive_stress};
            return contact::maugis_dugdale::pull_off_at_fixed_load(body).force;
        },
        nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"), nb::arg("cohesive_stress"));
}

void bind_layer(nb::module_& module) {
    using contact::layer::Layer;
    module.def(
        "layer_force",
        [](const Values& displacement, double radius, double contact_modulus, double work_of_adhesion, double thickness,
           double poisson_ratio, bool inner) {
            const AdhesiveContact body{radius, contact_modulus, work_of_adhesion};
            const Layer layer(thickness, poisson_ratio);
            return each(displacement, [&](double d) {
                const double a = contact::layer::contact_radius_at_displacement(d, body, layer, branch(inner));
                return a >= 0.0 ? contact::layer::force(a, body, layer) : none;
            });
        },
        nb::arg("displacement"), nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"),
        nb::arg("thickness"), nb::arg("poisson_ratio"), nb::arg("inner"));
    module.def(
        "layer_contact_radius",
        [](const Values& force, double radius, double contact_modulus, double work_of_adhesion, double thickness,
           double poisson_ratio, bool inner) {
            const AdhesiveContact body{radius, contact_modulus, work_of_adhesion};
            const Layer layer(thickness, poisson_ratio);
            return each(force, [&](double f) {
                return contact::layer::contact_radius_at_force(f, body, layer, branch(inner));
            });
        },
        nb::arg("force"), nb::arg("radius"), nb::arg("contact_modulus"), nb::arg("work_of_adhesion"),
        nb::arg("thickness"), nb::arg("poisson_ratio"), nb::arg("inner"));
}

}  // namespace

void bind_models(nb::module_& module) {
    bind_hertz(module);
    bind_dmt(module);
    bind_jkr(module);
    bind_maugis_dugdale(module);
    bind_layer(module);
}

}  // namespace setae::python
