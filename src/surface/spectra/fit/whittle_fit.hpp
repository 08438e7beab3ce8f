// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/spectral_fit/log_spline.hpp"

namespace setae::spectral_fit {

/// Periodograms that share one expectation: measurements of one shape by one instrument, averaged.
struct PeriodogramClass {
    std::string instrument;  ///< type
    std::string name;        ///< how messages call it
    Array1D wavevector;      ///< of each group of modes [1/m]
    Array1D periodogram;     ///< mean over measurements [m³]
    Array1D freedom;  ///< independent values behind each mean: modes × lines × measurements × ω; 0 leaves it out
    Array1D nodes;    ///< q_j the response refers to [1/m]
    Array2D
        response;  ///< E[P] = response · C(nodes), C(q) = C_iso(q/μ)/μ², the flat part below the first node included
    Array1D lengths;           ///< μ at the nodes: of a stretched surface along the lines; empty: 1
    double surface_end = 0.0;  ///< of C_iso of a stretched surface, beyond which it is 0 [1/m]
    Array1D noise_response;    ///< E[P] of white noise of variance 1 m², of a contour that of its trace's noise as
                               ///< stated; empty where none is fitted
    double noise_known_to = 0.0;  ///< standard deviation of ln σ² about 0 known beforehand, σ² then one for all classes
                                  ///< of an instrument; 0: found from the periodogram
    Array1D log_followed;       ///< ln a² of the tip at the nodes; empty without
    Array1D followed_response;  ///< ∂ ln a²/∂ ln A, A the amplitude below
    Array1D added;              ///< what the tip adds to the periodogram [m³]; empty without
    Array1D added_response;     ///< ∂ ln added/∂ ln A
    Array2D added_errors;  ///< ε_j of E_added = exp(Σ η_j ε_j) added, a row each; η of variance 1 and the same for all
                           ///< classes of a tip
    std::string probe;                 ///< tells tips apart
    double amplitude_order = 1.0;      ///< A = ∫_0^{amplitude_end} q^order C_iso dq
    double amplitude_end = 0.0;        ///< [1/m]
    double reference_amplitude = 0.0;  ///< A that both were simulated at; 0: the tip does not respond
};

/// How smooth ln C_iso is taken to be.
struct Smoothness {
    double bend = 0.25;      ///< standard deviation of the second difference of coefficients (0.1 decade)
    double slope = 0.5;      ///< of the first difference, below `slope_end` alone
    double slope_end = 0.0;  ///< [1/m]
};

/// q/μ of a class's nodes, where C_iso is asked for.
[[nodiscard]] Array1D surface_wavevectors(const PeriodogramClass& c);
/// What C_iso there is multiplied by: 1/μ² up to the surface's end, 0 beyond, in part for the node it falls on.
[[nodiscard]] Array1D surface_factors(const PeriodogramClass& c);
/// Share of a node's width in ln q that lies below an end.
[[nodiscard]] double share_below(double wavevector, double end);

/// A fitted spectrum.
struct WhittleFit {
    Eigen::VectorXd theta;       ///< coefficients of ln C_iso
    Eigen::VectorXd parameters;  ///< theta, then ln σ² and η
    Array1D log_noise;           ///< ln σ² of each class, in the unit of its noise_response; NaN where none
    Eigen::MatrixXd covariance;  ///< of theta, with the tip's response
    Eigen::MatrixXd gain;  ///< ∂theta/∂score: how theta answers to a change Jᵀν δ(ln E) of what is expected
    std::vector<Eigen::MatrixXd> jacobian;  ///< ∂ ln E/∂theta of each class at fixed tip
    std::vector<Array1D> expected;          ///< E[P] of each class
    double log_likelihood = 0.0;
    int iterations = 0;
    bool converged = false;
};

/// Maximises  −Σ ν (ln E + P/E) − ½ Σ (Δ²θ)²/s² − weak terms,  E = K a² C_iso + e^(Σηε) E_added + σ² N,  by Fisher
/// scoring with a step limit.
///
/// a² and E_added answer to the fit's own amplitude, ln a² = ln a_0² + s (ln A − ln A_0), in E and in the step, so that
/// few simulations of the tip suffice. Covariance: H1⁻¹ (J₀ᵀνJ₀ + Q) H1⁻ᵀ, H1 = J₀ᵀν(J₀ + J_T) + Q. start: theta to
/// begin with; empty: from the periodograms.
/// @throws InvalidArgument where no class has a value to fit.
/// Source: Whittle likelihood of expected periodograms, Sykulski et al., Biometrika 106 (2019) 251; response of T
/// derived here.
[[nodiscard]] WhittleFit fit_whittle(const std::vector<PeriodogramClass>& classes, const LogSpline& spline,
                                     const Smoothness& smoothness, const Eigen::VectorXd& start = {});

/// What a fit was made of, an input a small step larger and smaller.
struct MovedClasses {
    std::vector<PeriodogramClass> plus, minus;
};

/// How theta moves with such a step of an input, to first order and with everything that the classes hold:
///
///   δx = H⁻¹ ½ (s₊(x) − s₋(x)),   H = −∂s/∂x = J₀ᵀν(2r − 1)(J₀ + J_T) − Σ ν (r − 1) E_ab/E + Q,   r = P/E
///
/// s: score of the parameters x, which is 0 at the fit. Exact to second order of the step; noise, what tips add and
/// their response to the surface move with theta. classes: those that were fitted, as the moved ones are in their
/// order. Source: the implicit function theorem.
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
