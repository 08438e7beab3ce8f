// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "fits/correlated_residuals.hpp"
#include "setae/loops/jkr_fits.hpp"

/// Fits of a JKR branch in which each sample has a true contact radius of its own.
///
/// In reduced units, lengths by L and forces by F_s, depths by L²/R, with x the true contact radius:
///
///   f = e x³ − g x^(3/2),  d = x² − (2/3)(g/e) √x + d0,  e = 4E*L³/(3RF_s),  g = √(8πE*W L³)/F_s with the sign of W
///
/// which is smooth in x through the fold at pull-off and, for g <= 0, continues to W <= 0. The sum of squared distances
/// of the samples from this curve, in units of their noise, is minimised over e, g, d0 and all x by the Gauss–Newton
/// method, each x eliminated analytically (Britt, Luecke, Technometrics 15 (1973) 233). Noise along a curved line
/// shifts samples to its outer side by half the curvature on average: this is subtracted (Amemiya, Fuller, Ann. Stat.
/// 16 (1988) 147).
namespace setae::loops::errors_in_variables {

struct Channels {
    bool displacement = false;
    bool contact_radius = false;
};

/// Samples in reduced units, and the inverse of their noise.
struct Points {
    Channels channels;
    double radius = 0.0;      ///< radius of the sphere [m]
    double force_unit = 0.0;  ///< F_s [N]
    double length = 0.0;      ///< L [m]
    double depth_unit = 0.0;  ///< L²/R [m]
    double origin = 0.0;      ///< zero of displacements [m]
    double shared = 0.0;  ///< σ_Fδ/σ_F² in reduced units: the noise of d − shared·f is independent of that of f
    double force_weight = 0.0, depth_weight = 0.0,
           radius_weight = 0.0;            ///< 1/σ in reduced units; for depth, of d − shared·f
    Array1D force, depth, contact_radius;  ///< reduced
};

using Parameters = Eigen::Vector3d;  ///< e, g, d0

/// Fixed parameter.
enum class Held { none, modulus, work };

struct Options {
    Held held = Held::none;
    bool curvature = true;  ///< whether the offset by curvature is subtracted
    int max_rounds = 100;
};

struct Solution {
    Parameters parameters;
    Array1D x;  ///< true contact radii
    double squares = 0.0;
    bool converged = false;
    int rounds = 0;
};

/// @throws UndefinedDataError for missing channels and constant ones; InvalidArgument where their noise is unknown.
[[nodiscard]] Points points(const BranchData& data, const LensAndCounterBody& bodies, Channels channels);

/// Means of a number of neighbours each, whose noise is smaller and which lie on the curve except for its curvature
/// between them.
[[nodiscard]] Points averaged(const Points& points, Index neighbours);

/// e, g and d0 of a contact.
[[nodiscard]] Parameters reduced_parameters(const Points& points, double contact_modulus, double work_of_adhesion,
                                            double contact_point);

/// True radii to begin with: the measured ones kept from the inner end of the curve, else those of the forces.
[[nodiscard]] Array1D first_radii(const Points& points, const Parameters& parameters);

[[nodiscard]] Solution solve(const Points& points, const Parameters& start, Array1D radii, const Options& options = {});

/// The same by Levenberg and Marquardt's method, the nearest points found in every step, without the offset of
/// curvature: slower, from a start far off.
[[nodiscard]] Solution solve_carefully(const Points& points, const Parameters& start, Array1D radii,
                                       const Options& options = {});

/// All samples with their nearest points on the curve of a solution for means of them.
[[nodiscard]] Solution projected(const Points& points, const Solution& solution);

/// The samples with the mean offset by curvature subtracted, for a sum of squares with its minimum at the solution.
[[nodiscard]] Points straightened(const Points& points, const Solution& solution);

/// Effects of noise along the curve at a solution, in units of the noise.
struct AlongTheCurve {
    double curvature = 0.0;     ///< the largest: |γ''⊥|/|γ'|²
    Eigen::MatrixXd pretended;  ///< Σ j'j'ᵀ/|γ'|², j' the change along the curve of the derivatives across it
};
/// Nearest points scatter along the curve by 1/|γ'|, and so do the derivatives at these points: JᵀJ is too large by
/// `pretended` on average, and the information is JᵀJ minus that.
[[nodiscard]] AlongTheCurve along_the_curve(const Points& points, const Solution& solution);

/// Residuals in the directions across the curve, of unit variance where the noise is as given, with their derivatives.
struct Across {
    std::vector<Eigen::MatrixXd> jacobians;  ///< n × (2 or 3), one per direction
    std::vector<Eigen::VectorXd> residuals;
    Array1D force,
        depth;  ///< F − F(a) and δ − δ(a) − δ0 in SI units, along the tangent; empty where a was not measured
};
[[nodiscard]] Across across(const Points& points, const Solution& solution);

/// JᵀJ of all directions.
[[nodiscard]] Eigen::MatrixXd across_information(const Across& noise);

}  // namespace setae::loops::errors_in_variables
