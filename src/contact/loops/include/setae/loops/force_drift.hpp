// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/fields/describe.hpp"
#include "setae/loops/loop.hpp"

namespace setae::loops {

/// Curve of the zero of force against time.
enum class DriftModel {
    automatic,     ///< the line through the free flight before and after contact; a curve where the line does not fit
    constant,      ///< the zero of the free flight before contact, else of that after it
    linear,        ///< a line through all free flight
    quadratic,     ///< a parabola, which needs free flight before and after contact
    cubic,         ///< a cubic, which needs free flight before and after contact
    extrapolated,  ///< the line through the free flight before contact only
};

/// "auto", "none", "linear", "quadratic", "cubic", "extrapolate".
[[nodiscard]] std::string to_string(DriftModel model);

/// The model of that name. @throws InvalidArgument with a list of all names.
[[nodiscard]] DriftModel drift_model_named(std::string_view name);

/// A sudden change of the force within a section of slow change.
struct ForceStep {
    Index sample = 0;   ///< last sample before the step
    double size = 0.0;  ///< [N]
};

/// Drift of the zero of force, which is subtracted.
///
/// The zero is a polynomial in time, fitted to the free flight before and after contact by least squares (Huber's
/// weights). Its degree is 1. It is increased, to at most 3, where means and slopes of the sections differ from the
/// curve (χ² with p < 0.02, with correlated noise) and the curve deviates from a line within the contact by more than
/// 0.3 % of the largest tension. The choice contributes to the error within contact in addition to the coefficients:
/// for a parabola half of the largest change that a cubic would make, for a cubic, which free flight cannot test, a
/// quarter of the largest change from the line.
struct ForceDrift {
    int degree = 0;                   ///< degree of the subtracted polynomial; 0: a constant
    Estimate change;                  ///< change of the zero from the first sample to the last [N]
    double largest_in_contact = 0.0;  ///< |zero minus that at the first sample|, largest between the sections [N]
    double bend = 0.0;                ///< |zero − line|, largest between the sections [N]; 0 for degree <= 1
    bool irregular = false;           ///< no curve of degree 3 or less fits the free flight; a line was used
    Index stretches = 0;              ///< number of sections of free flight: 0, 1, 2
};

/// The zero of force along a record.
struct ForceZero {
    Array1D value;  ///< at every sample [N]
    Array2D modes;  ///< samples × modes: its independent errors, each of one standard deviation [N]
    ForceDrift drift;
};

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::ForceStep> {
    using T = loops::ForceStep;
    static constexpr std::array rows{field<&T::sample>("sample", "last sample before the step"),
                                     quantity<&T::size>("size", "dF", "N", "change of the force")};
    static constexpr Description description{"", "sudden change of the force", rows};
};
static_assert(complete<loops::ForceStep>);

template <>
struct Described<loops::ForceDrift> {
    using T = loops::ForceDrift;
    static constexpr std::array rows{
        field<&T::degree>("degree", "degree of the polynomial in time that was removed; 0 for a constant"),
        field<&T::stretches>("stretches", "number of sections of free flight that determine the zero: 0, 1 or 2"),
        field<&T::irregular>("irregular", "whether no curve fits the free flight; a line was removed then"),
        quantity<&T::change>("change", "dF0", "N", "change of the zero from the first sample to the last"),
        quantity<&T::largest_in_contact>("largest_in_contact", "dF0", "N",
                                         "largest change of the zero since the first sample within contact"),
        quantity<&T::bend>("bend", "dF0", "N", "largest distance of the zero from a line within contact"),
    };
    static constexpr Description description{"", "drift of the zero of force", rows};
};
static_assert(complete<loops::ForceDrift>);

}  // namespace setae::fields
