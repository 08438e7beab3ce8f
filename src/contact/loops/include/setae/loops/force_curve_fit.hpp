// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/loops/model_fits.hpp"
#include "setae/loops/outcome.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {

/// A tip pressed into a flat, E* the contact modulus. The half-angle of a cone is that between its axis and its side;
/// that of a pyramid the inclination of its faces to the flat.
enum class TipShape {
    paraboloid,           ///< F = 4/3 E* √R δ^(3/2), and every model of contact
    cone,                 ///< F = (2/π) tan(θ) E* δ²: Hertz only
    three_sided_pyramid,  ///< F = 0.887 tan(θ) E* δ²: Hertz only
};
/// "paraboloid", "cone", "three_sided_pyramid".
[[nodiscard]] std::string to_string(TipShape shape);
/// The shape of that name. @throws InvalidArgument with the nearest name and all names.
[[nodiscard]] TipShape tip_shape_named(std::string_view name);

/// Begin and end of a fit, by one of three measures; the larger end is included.
struct CurveRange {
    enum class Measure {
        indentation,           ///< δ − δ0 [m]; negative before contact
        force,                 ///< F [N] above the baseline
        share_of_indentation,  ///< (δ − δ0) divided by the largest indentation
    };
    Measure measure = Measure::share_of_indentation;
    double from = -1.0;  ///< a value below the range of the curve is no error
    double to = 1.0;
};

struct ForceCurveFitOptions {
    TipShape shape = TipShape::paraboloid;
    double half_angle = 0.0;  ///< [rad], for cone and pyramid
    ContactModel model = ContactModel::hertz;
    FitErrors errors = FitErrors::force_only;
    CurveRange range{};
    std::optional<double> contact_point;     ///< δ0 [m] where given
    bool fit_contact_point = true;           ///< otherwise fixed at the given or determined value
    bool fit_force_offset = false;           ///< a constant added to the model; Hertz only
    double baseline_share = 0.2;             ///< share of the segment, at its free end
    bool subtract_baseline_slope = true;     ///< drift and interference: a line against displacement, else its mean
    std::optional<double> work_of_adhesion;  ///< W [J/m²] where given
    std::optional<double> cohesive_stress;   ///< σ0 [Pa] of Maugis–Dugdale where given
};

/// A straight line through the free end of a segment.
struct CurveBaseline {
    IndexRange range;          ///< samples of the table
    double force = 0.0;        ///< force at the middle of the range [N]
    double slope = 0.0;        ///< [N/m], against displacement
    double force_noise = 0.0;  ///< scatter about the line [N]
};

/// One segment of a force curve: approach, or retraction in reverse order so that displacement increases.
struct CurveSegment {
    std::string name;  ///< "approach", "retract", "pause"
    IndexRange range;  ///< samples of the table
    CurveBaseline baseline;
    double contact_point =
        0.0;  ///< displacement beyond which the force stays above three times its noise [m]; NaN where none does
    Array1D displacement;         ///< [m], in the record's order
    Array1D force;                ///< [N], baseline subtracted
    double smallest_force = 0.0;  ///< for a retraction: pull-off [N], 0 where none exceeds the noise
};

struct ForceCurveFit {
    CurveSegment segment;
    TipShape shape = TipShape::paraboloid;
    ContactModel model = ContactModel::hertz;
    Estimate contact_modulus;  ///< E* [Pa]
    Estimate youngs_modulus;   ///< E of the sample [Pa]
    Outcome<Estimate> work_of_adhesion;
    Estimate contact_point;  ///< δ0 [m]
    Estimate force_offset;   ///< [N]; 0 without error where not fitted
    std::optional<ModelFit>
        model_fit;  ///< all other results, for the models with adhesion and for Hertz with errors in both channels
    std::vector<std::string>
        parameters;  ///< rows of the covariance: "contact_modulus", "contact_point", "force_offset", …
    Eigen::MatrixXd covariance;
    bool converged = false;
    Index n = 0;
    std::vector<Index> samples;                           ///< fitted samples of the segment
    double indentation_from = 0.0, indentation_to = 0.0;  ///< range of the fitted samples [m]
    Array1D residuals;                                    ///< F − fitted [N]
    double rms_residual = 0.0;                            ///< [N]
    double relative_residual = 0.0;                       ///< divided by the range of the fitted force
};

/// Segments by the column "segment" (0, 1, …), or, without it, split at the largest force; names from metadata
/// "segments". Those without motion are pauses.
/// @throws InvalidArgument without columns "force" and "displacement"; UndefinedDataError for fewer than 20 samples.
[[nodiscard]] std::vector<CurveSegment> segments_of_curve(const Table& curve, const ForceCurveFitOptions& options = {});

/// Fits one segment: radius of the tip, Poisson's ratio of the sample and the tip's elasticity from the bodies.
///
/// The range is relative to the given or determined contact point, and stays while that is fitted. Hertz's force is 0
/// before contact, so a range that begins there helps to determine the contact point; with adhesion only the samples
/// between the smallest force and the turning point belong to the model's curve, and the others are left out.
/// @throws InvalidArgument for options the shape does not have; UndefinedDataError for fewer than 5 samples in range.
[[nodiscard]] ForceCurveFit fit_force_curve(const CurveSegment& segment, const LensAndCounterBody& bodies,
                                            const ForceCurveFitOptions& options = {});

/// A segment's fit, or the reason for which there is none.
struct NamedCurveFit {
    std::string name;
    Outcome<ForceCurveFit> fit;
};
/// Fits of all moving segments. @throws as segments_of_curve.
[[nodiscard]] std::vector<NamedCurveFit> fit_force_curve(const Table& curve, const LensAndCounterBody& bodies,
                                                         const ForceCurveFitOptions& options = {});

}  // namespace setae::loops
