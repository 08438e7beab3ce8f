// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/outcome.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {

/// Methods for δ0, the displacement at first contact of the undeformed bodies.
enum class ContactPointMethod {
    force_departure,     ///< where the force leaves the baseline: a jump, or first contact without attraction
    broken_line,         ///< baseline and F = C (δ − δ0)^(3/2) joined at δ0; without attraction
    jump_in,             ///< first sample after the jump, along the testing machine's line: δ + F/k
    force_displacement,  ///< fitted with E* and W to F(δ) of loading
    pointwise,           ///< from F, δ and a, independent of W: F = 2aE* (δ − δ0 − a²/(3R))
    zero_force,          ///< δ0 = δ(F=0) − a²/(3R), a(F=0) measured or JKR's (9πWR²/(2E*))^(1/3)
    pull_off,            ///< at separation, with the instability for the stiffness of the testing machine
};

/// Every method with its name in texts and JSON: "force_departure", …
[[nodiscard]] const std::vector<ContactPointMethod>& contact_point_methods();
[[nodiscard]] std::string contact_point_name(ContactPointMethod method);

/// Origin of the contact point of F–δ fits.
struct ContactPointChoice {
    enum class Mode {
        automatic,  ///< fitted where the data determine it; else the estimate with the smallest standard error, fixed
        fit,        ///< a parameter of every F–δ fit
        estimator,  ///< result of one method, fixed in every F–δ fit
        value,      ///< given value, fixed in every F–δ fit
    };
    Mode mode = Mode::automatic;
    ContactPointMethod estimator = ContactPointMethod::force_displacement;
    double value = 0.0;  ///< [m], of the record's displacement with the deflection of the testing machine subtracted

    friend bool operator==(const ContactPointChoice&, const ContactPointChoice&) = default;
};

/// "auto", "fit", the name of a method, or a length such as "1.25 um". @throws InvalidArgument for anything else.
[[nodiscard]] ContactPointChoice parse_contact_point(std::string_view text);

/// One estimate of the contact point with the resulting E* and W.
struct ContactPointEstimate {
    ContactPointMethod method{};
    Outcome<Estimate> contact_point;  ///< [m], with standard error; or the reason for which the method has no result
    Outcome<JkrFit> fit;              ///< F–δ of loading with fixed δ0
};

/// All estimates.
struct ContactPoints {
    std::vector<ContactPointEstimate> estimates;  ///< estimates of every method, in order
    std::optional<ContactPointMethod> chosen;     ///< none where a value was given
    Estimate contact_point;                       ///< the chosen estimate [m]
    double spread = 0.0;                          ///< largest minus smallest [m]
    double spread_share = 0.0;                    ///< share of the largest penetration
    double chi2 = 0.0;                            ///< Σ (δ0 − mean)²/σ², about the weighted mean
    Index degrees_of_freedom = 0;                 ///< estimates with a standard error, minus one
    double work_by_contact_point = 0.0;     ///< dW/dδ0 [J/m³] at the chosen estimate; NaN where no fit is possible
    double modulus_by_contact_point = 0.0;  ///< dE*/dδ0 [Pa/m]

    /// The estimate of a method. @throws InternalError where it is not among them.
    [[nodiscard]] const ContactPointEstimate& of(ContactPointMethod method) const;
};

/// Inputs of the estimators, in addition to the record.
struct ContactPointInputs {
    const Loop& loop;  ///< force relative to its zero
    const Segments& segments;
    const ForceZero& force_zero;
    Index contact = 0;
    BranchData loading;                       ///< samples of the loading fit
    Outcome<JkrFit> force_displacement;       ///< fit of loading, δ0 free
    Outcome<PointwiseModulus> pointwise;      ///< fit of loading
    std::optional<JkrFit> unloading;          ///< the best fit of W and E* of the retraction
    std::optional<double> machine_stiffness;  ///< [N/m] where it is known; else that of the jump out
};

/// Every estimate of the contact point, the chosen one, and the dependence of E* and W on it.
/// @throws UndefinedDataError without displacement, or where the chosen method has no result.
[[nodiscard]] ContactPoints contact_points(const ContactPointInputs& inputs, const LensAndCounterBody& bodies,
                                           const ContactPointChoice& choice = {});

/// Force against displacement with a fixed contact point, least squares in force, each residual weighted by the noise
/// of both channels; unknown E* and W.
///
///   F = E* [4a³/(3R) − √(8πωa³)],  a from δ − δ0 = a²/R − √(2πωa),  ω = W/E*
///
/// The covariance is that of E* and W with δ0 exact. Samples below the fitted pull-off under fixed grips have the force
/// at that state.
/// @throws as fit_force_displacement.
[[nodiscard]] JkrFit fit_with_contact_point(const BranchData& data, const LensAndCounterBody& bodies,
                                            double contact_point);

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::ContactPointEstimate> {
    using T = loops::ContactPointEstimate;
    static constexpr std::array rows{
        made<T>("method", "method of the estimate", [](const T& of) { return loops::contact_point_name(of.method); }),
        made<T>("contact_point", "delta0", "m", "δ0", [](const T& of) { return of.contact_point.value; }),
        made<T>("reason", "reason for which it is missing or left out",
                [](const T& of) { return of.contact_point ? std::nullopt : std::optional(of.contact_point.reason); }),
        fields_of<T>(Described<loops::JkrFit>::moduli,
                     [](const T& of) -> const loops::Outcome<loops::JkrFit>& { return of.fit; }),
        inner<&T::method>(),
        inner<&T::contact_point>(),
        inner<&T::fit>(),
    };
    static constexpr Description description{"", "one estimate of the contact point", rows};
};
static_assert(complete<loops::ContactPointEstimate>);

template <>
struct Described<loops::ContactPoints> {
    using T = loops::ContactPoints;
    static constexpr std::array rows{
        made<T>("chosen", "estimate that is used, or `given`",
                [](const T& of) { return of.chosen ? loops::contact_point_name(*of.chosen) : std::string("given"); }),
        quantity<&T::contact_point>("contact_point", "delta0", "m", "δ0"),
        field<&T::estimates>("estimates", "one entry per method"),
        quantity<&T::spread>("spread", "spread", "m", "spread of the estimates"),
        quantity<&T::spread_share>("spread_share", "spread", "1",
                                   "spread of the estimates divided by the largest indentation"),
        field<&T::chi2>("chi_squared", "χ²"),
        field<&T::degrees_of_freedom>("degrees_of_freedom", "degrees of freedom of the estimates"),
        quantity<&T::work_by_contact_point>("work_by_contact_point", "dW/d(delta0)", "J/m3", "dW/dδ0"),
        quantity<&T::modulus_by_contact_point>("modulus_by_contact_point", "dE*/d(delta0)", "Pa/m", "dE*/dδ0"),
        inner<&T::chosen>(),
    };
    static constexpr Description description{"contact_points", "displacements at first contact", rows};
};
static_assert(complete<loops::ContactPoints>);

}  // namespace setae::fields
