// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/contact/elasticity.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/table.hpp"
#include "setae/fields/describe.hpp"

namespace setae::loops {

/// Samples first … last, both included.
struct IndexRange {
    Index first = 0;
    Index last = 0;

    [[nodiscard]] Index count() const { return last - first + 1; }
    [[nodiscard]] bool contains(Index sample) const { return first <= sample && sample <= last; }
    friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

/// Record of a contact experiment, sample by sample: approach, contact, retraction.
///
/// Series that were not measured are empty; all others have equal length. Force is required, and displacement or
/// contact radius or both.
struct Loop {
    Array1D time;            ///< [s]
    Array1D force;           ///< F [N], pressing positive, any offset
    Array1D displacement;    ///< δ [m], increasing into the contact, any offset
    Array1D contact_radius;  ///< a [m]; 0 out of contact, NaN where a frame is missing
};

/// Loop from the table's columns "time", "force", "displacement" and "contact_radius" (SI), those that it has.
/// @throws InvalidArgument where the force is missing, or both displacement and contact radius.
[[nodiscard]] Loop loop_from_table(const Table& table);

/// The two bodies: a soft one whose modulus is determined and a counter-body with known elasticity. The contact does
/// not depend on which of them is the sphere.
struct LensAndCounterBody {
    double radius = 0.0;                    ///< R of the sphere [m], > 0
    double lens_poisson_ratio = 0.5;        ///< ν of the soft body; 1/2 for rubber
    double counter_youngs_modulus = 0.0;    ///< E of the counter-body [Pa], > 0; infinity for a rigid one
    double counter_poisson_ratio = 0.0;     ///< ν of the counter-body
    std::optional<double> lens_height;      ///< height of the soft lens above its mount [m]
    std::optional<double> layer_thickness;  ///< thickness of the soft body where it is a layer on a rigid base [m]

    /// h of the soft body above its fixed base [m]; empty where neither is known: a half-space.
    [[nodiscard]] std::optional<double> soft_height() const { return layer_thickness ? layer_thickness : lens_height; }

    [[nodiscard]] contact::ElasticSolid counter_body() const {
        return {.youngs_modulus = counter_youngs_modulus, .poisson_ratio = counter_poisson_ratio};
    }
};

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::IndexRange> {
    using T = loops::IndexRange;
    static constexpr std::array rows{field<&T::first>("first", "index of the first sample"),
                                     field<&T::last>("last", "index of the last sample")};
    static constexpr Description description{"samples", "range of samples", rows};
};
static_assert(complete<loops::IndexRange>);

}  // namespace setae::fields
