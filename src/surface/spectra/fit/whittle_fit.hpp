// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/spectral_fit/log_spline.hpp"

namespace setae::spectral_fit {

/// Periodograms with one expectation: measurements of one shape by one instrument, averaged.
struct PeriodogramClass {
    std::string instrument;  ///< type
    std::string name;        ///< name in messages
    Array1D wavevector;      ///< of each group of modes [1/m]
    Array1D periodogram;     ///< mean over measurements [m³]
    Array1D freedom;  ///< number of independent values per mean: modes × lines × measurements × ω; 0 excludes it
    Array1D nodes;    ///< q_j of the response [1/m]
    Array2D
        response;  ///< E[P] = response · C(nodes), C(q) = C_iso(q/μ)/μ², the flat part below the first node included
    Array1D lengths;           ///< μ at the nodes: for a stretched surface along the lines; empty: 1
    double surface_end = 0.0;  ///< of C_iso of a stretched surface, which is 0 beyond it [1/m]
    Array1D noise_response;    ///< E[P] of white noise of variance 1 m², for a contour that of the stated noise of its
                               ///< trace; empty if no noise is fitted
    double noise_prior_deviation = 0.0;  ///< prior standard deviation of ln σ² about 0, with one σ² for all classes of
                                         ///< an instrument; 0: from the periodogram
    Array1D log_followed;       ///< ln a² of the tip at the nodes; empty without
    Array1D followed_response;  ///< ∂ ln a²/∂ ln A, A the amplitude below
    Array1D added;              ///< power added by the tip to the periodogram [m³]; empty without
    Array1D added_response;     ///< ∂ ln added/∂ ln A
    Array2D added_errors;  ///< ε_j of E_added = exp(Σ η_j ε_j) added, one row each; η of variance 1, common to all
                           ///< classes of a tip
    std::string probe;     ///< distinguishes tips
    double amplitude_order = 1.0;      ///< A = ∫_0^{amplitude_end} q^order C_iso dq
    double amplitude_end = 0.0;        ///< [1/m]
    double reference_amplitude = 0.0;  ///< A of the simulation of both; 0: the tip does not respond
};

/// Smoothness prior of ln C_iso.
struct Smoothness {
    double bend = 0.25;      ///< standard deviation of the second difference of coefficients (0.1 decade)
    double slope = 0.5;      ///< of the first difference, only below `slope_end`
    double slope_end = 0.0;  ///< [1/m]
};

/// q/μ of the nodes of a class, the arguments of C_iso.
[[nodiscard]] Array1D surface_wavevectors(const PeriodogramClass& c);
/// Factor of C_iso there: 1/μ² up to the end of the surface, 0 beyond, in part for the node at the end.
[[nodiscard]] Array1D surface_factors(const PeriodogramClass& c);
/// Share of the width of a node in ln q below an end.
[[nodiscard]] double share_below(double wavevector, double end);

/// A fitted spectrum.
struct WhittleFit {
    Eigen::VectorXd theta;       ///< coefficients of ln C_iso
    Eigen::VectorXd parameters;  ///< theta, then ln σ² and η
    Array1D log_noise;           ///< ln σ² of each class, in the unit of its noise_response; NaN without noise
    Eigen::MatrixXd covariance;  ///< of theta, with the response of the tip
    Eigen::MatrixXd gain;  ///< ∂theta/∂score: response of theta to a change Jᵀν δ(ln E) of the expectation
    std::vector<Eigen::MatrixXd> jacobian;  ///< ∂ ln E/∂theta of each class at fixed tip
    std::vector<Array1D> expected;          ///< E[P] of each class
    double log_likelihood = 0.0;
    int iterations = 0;
    bool converged = false;
};

/// Maximises  −Σ ν (ln E + P/E) − ½ Σ (Δ²θ)²/s² − weak terms,  E = K a² C_iso + e^(Σηε) E_added + σ² N,  by Fisher
/// scoring with a step limit.
///
/// a² and E_added respond to the amplitude of the fit, ln a² = ln a_0² + s (ln A − ln A_0), in E and in the step, so a
/// few simulations of the tip are sufficient. Covariance: H1⁻¹ (J₀ᵀνJ₀ + Q) H1⁻ᵀ, H1 = J₀ᵀν(J₀ + J_T) + Q. start:
/// initial theta; empty: from the periodograms. @throws InvalidArgument if no class has a value to fit.
/// Source: Whittle likelihood of expected periodograms, Sykulski et al., Biometrika 106 (2019) 251; response of T
/// derived here.
[[nodiscard]] WhittleFit fit_whittle(const std::vector<PeriodogramClass>& classes, const LogSpline& spline,
                                     const Smoothness& smoothness, const Eigen::VectorXd& start = {});

/// Input of a fit with one input variable changed by a small step up and down.
struct MovedClasses {
    std::vector<PeriodogramClass> plus, minus;
};

/// Change of theta with such a step of an input, to first order and with all content of the classes:
///
///   δx = H⁻¹ ½ (s₊(x) − s₋(x)),   H = −∂s/∂x = J₀ᵀν(2r − 1)(J₀ + J_T) − Σ ν (r − 1) E_ab/E + Q,   r = P/E
///
/// s: score of the parameters x, which is 0 at the fit. Exact to second order of the step; noise, power added by tips
/// and their response to the surface change with theta. classes: the fitted ones, in the order of the changed ones.
/// Source: the implicit function theorem.
[[nodiscard]] Eigen::VectorXd theta_moved(const WhittleFit& fit, const std::vector<PeriodogramClass>& classes,
                                          const MovedClasses& moved, const LogSpline& spline,
                                          const Smoothness& smoothness);

/// ∫_0^{end} q^order C_iso dq of a spline, constant below its first knot, and its derivative by theta.
struct SplineMoment {
    double value = 0.0;
    Eigen::VectorXd gradient;
};
[[nodiscard]] SplineMoment spline_moment(const LogSpline& spline, const Eigen::VectorXd& theta, double order,
                                         double end);

}  // namespace setae::spectral_fit
