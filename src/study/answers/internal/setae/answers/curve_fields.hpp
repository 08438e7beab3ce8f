// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Outputs of `setae jkr fit` for a force curve, and for all force curves of a file.

#include <optional>
#include <string>

#include "setae/answers/force_curves.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// The fits to a force curve.
struct FittedCurve {
    std::string file;
    const loops::ForceCurveAnalysis* analysis;
};

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<loops::CurveBaseline> {
    using T = loops::CurveBaseline;
    static constexpr std::array rows{
        field<&T::force>("force", "force at the middle of the baseline").in_unit("N"),
        field<&T::slope>("slope", "slope of the baseline against displacement").in_unit("N/m"),
        field<&T::force_noise>("force_noise", "standard deviation of the force about the baseline").in_unit("N"),
        inner<&T::range>(),
    };
    static constexpr Description description{"", "force without contact", rows};
};
static_assert(complete<loops::CurveBaseline>);

template <>
struct Described<loops::CurveSegment> {
    using T = loops::CurveSegment;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const loops::IndexRange& { return of.range; }),
        field<&T::baseline>("baseline", "force without contact"),
        quantity<&T::contact_point>("contact_point_found", "delta0", "m",
                                    "point at which the curve leaves the baseline"),
        quantity<&T::smallest_force>("smallest_force", "F_po", "N", "smallest force of the segment"),
        inner<&T::name>(),
        inner<&T::range>(),
        inner<&T::displacement>(),
        inner<&T::force>(),
    };
    static constexpr Description description{"", "segment of a force curve", rows};
};
static_assert(complete<loops::CurveSegment>);

template <>
struct Described<loops::ForceCurveFit> {
    using T = loops::ForceCurveFit;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const loops::CurveSegment& { return of.segment; }),
        made<T>("tip", "shape of the tip", [](const T& of) { return to_string(of.shape); })
            .one_of(Asked<answers::CurveRequest>::tips),
        made<T>("model", "name of the contact model", [](const T& of) { return to_string(of.model); }),
        field<&T::converged>("converged", "whether the iteration converged"),
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "contact modulus E*"),
        quantity<&T::youngs_modulus>("youngs_modulus", "E", "Pa", "Young's modulus E of the sample"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W", "J/m2",
                                       "work of adhesion W; null for a model without adhesion"),
        quantity<&T::contact_point>("contact_point", "delta0", "m", "contact point δ0"),
        quantity<&T::force_offset>("force_offset", "F0", "N", "force offset of the baseline"),
        quantity<&T::indentation_from>("indentation_from", "delta", "m", "smallest indentation of the fitted points"),
        quantity<&T::indentation_to>("indentation_to", "delta", "m", "largest indentation of the fitted points"),
        field<&T::n>("n", "number of fitted points"),
        field<&T::covariance>("covariance", "covariance of the parameters"),
        quantity<&T::rms_residual>("rms_residual", "rms", "N", "root mean square residual").as("rms_residual_of_force"),
        field<&T::relative_residual>("relative_residual", "rms residual divided by the range of the fitted force"),
        field<&T::residuals>("residuals", "measured minus fitted force of each point").in_unit("N"),
        field<&T::model_fit>("fit",
                             "further results of models with adhesion, and of fits with errors of both channels"),
        inner<&T::segment>(),
        inner<&T::shape>(),
        inner<&T::model>(),
        inner<&T::parameters>(),
        inner<&T::samples>(),
    };
    static constexpr Description description{"", "fit to a segment of a force curve", rows};
};
static_assert(complete<loops::ForceCurveFit>);

template <>
struct Described<loops::NamedCurveFit> {
    using T = loops::NamedCurveFit;
    static constexpr std::array rows{
        field<&T::name>("name", "`approach`, `retract`, or the name in the file"),
        made<T>("reason", "reason for which there is no fit; no further field then",
                [](const T& of) { return of.fit ? std::nullopt : std::optional(of.fit.reason); }),
        fields_of<T>([](const T& of) -> const loops::Outcome<loops::ForceCurveFit>& { return of.fit; }),
        inner<&T::fit>(),
    };
    static constexpr Description description{"", "segment of a force curve, with its fit", rows};
};
static_assert(complete<loops::NamedCurveFit>);

template <>
struct Described<loops::ForceCurveSummary> {
    using T = loops::ForceCurveSummary;
    static constexpr std::array rows{
        field<&T::fitted_segment>("fitted_segment", "name of the segment whose fit is the result"),
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "contact modulus E*"),
        quantity<&T::youngs_modulus>("youngs_modulus", "E", "Pa", "Young's modulus E of the sample"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W", "J/m2",
                                       "work of adhesion W: of the fit if the model has one, else by Eq. S1 of [D19] "
                                       "from the pull-off force"),
        quantity<&T::pull_off_force>("pull_off_force", "F_po", "N", "smallest force of the retraction"),
        quantity<&T::energy_loss>("energy_loss", "E_loss", "J", "energy loss E_loss of approach and retraction"),
        inner<&T::work_by_pull_off>(),
    };
    static constexpr Description description{"", "result of both segments of a force curve", rows};
};
static_assert(complete<loops::ForceCurveSummary>);

template <>
struct Described<answers::FittedCurve> {
    using T = answers::FittedCurve;
    static constexpr std::array rows{
        field<&T::file>("file", "name of the file as it was given"),
        made<T>("segments", "approach and retraction",
                [](const T& of) -> const auto& { return of.analysis->segments; }),
        made<T>("summary", "result of both segments together",
                [](const T& of) -> const auto& { return of.analysis->summary; }),
        inner<&T::analysis>(),
    };
    static constexpr Description description{"", "fits to a force curve", rows};
};
static_assert(complete<answers::FittedCurve>);

template <>
struct Described<study::MappedCurve> {
    using T = study::MappedCurve;
    static constexpr std::array rows{
        field<&T::number>("number", "number of the curve in the file, counted from 0"),
        field<&T::x>("x", "coordinate along x").in_unit("m"),
        field<&T::y>("y", "coordinate along y").in_unit("m"),
        field<&T::pixel>("pixel", "column and row of the curve on the grid"),
        fields_of<T>([](const T& of) -> const loops::Outcome<loops::ForceCurveSummary>& { return of.summary; }),
        made<T>("reason", "reason for which the curve has no result",
                [](const T& of) { return of.summary ? std::nullopt : std::optional(of.summary.reason); }),
        inner<&T::summary>(),
    };
    static constexpr Description description{"", "force curve of a file", rows};
};
static_assert(complete<study::MappedCurve>);

template <>
struct Described<tables::MapGrid> {
    using T = tables::MapGrid;
    static constexpr std::array rows{
        field<&T::columns>("columns", "number of columns"),
        field<&T::rows>("rows", "number of rows"),
        field<&T::width>("width", "extent along the rows").in_unit("m"),
        field<&T::height>("height", "extent along the columns").in_unit("m"),
        field<&T::x>("x", "coordinate of the centre along x").in_unit("m"),
        field<&T::y>("y", "coordinate of the centre along y").in_unit("m"),
        field<&T::angle>("angle", "angle between the x axis and the rows").in_unit("rad"),
    };
    static constexpr Description description{"", "grid of a force map", rows};
};
static_assert(complete<tables::MapGrid>);

template <>
struct Described<study::ForceMap> {
    using T = study::ForceMap;
    static constexpr std::array rows{
        field<&T::file>("file", "name of the file as it was given"),
        field<&T::format>("format", "identifier of the format"),
        field<&T::curves>("curves", "one entry per curve"),
        field<&T::grid>("grid", "grid of the curves, if the file states one"),
    };
    static constexpr Description description{"", "fits to a file of many force curves", rows};
};
static_assert(complete<study::ForceMap>);

}  // namespace setae::fields
