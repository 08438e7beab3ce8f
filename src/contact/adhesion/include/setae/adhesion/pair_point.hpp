// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/estimate.hpp"
#include "setae/core/traced_value.hpp"

namespace setae::adhesion {

/// Prefix of the names of noise that no two pairs share.
inline constexpr const char* own_noise_of = "noise of ";

/// Name of the input that represents the own noise of a measured quantity of a pair: "noise of W_app on S × E".
[[nodiscard]] std::string own_noise_name(const std::string& quantity, const std::string& surface,
                                         const std::string& elastomer);

/// One surface × elastomer pair in a fit of the intrinsic work of adhesion W.
///
///   prediction(W) = max(0, slope · W − offset)
///
/// Full-contact balance (Eq. 7): slope r, offset γ1 (r − 1) + U_el/A.  Persson–Tosatti balance (Eq. S13): slope 1 +
/// h'²/2, offset U_el/A.  True-area loss of loops (Eq. 10): slope A_true, offset 0, or minus the loss of the smooth
/// sphere.
struct PairPoint {
    std::string surface;
    std::string elastomer;
    std::string quantity = "W_app";  ///< measured quantity
    Estimate measured;           ///< measured value; the standard error includes noise and scatter, but not the inputs
    Components in_unitputs;  ///< inputs shared with other pairs: radius of a lens, calibrations
    Components measured_noise;   ///< part of the noise that is shared with other values, such as E of the same fit
    double slope = 0.0;          ///< > 0
    double offset = 0.0;
    Components slope_inputs, offset_inputs;
    /// Deviation of an unmeasured pair from slope · W − offset: departure_from().
    Components departure;
    bool floored = true;  ///< whether predictions have a floor at 0

    /// Variance that is not shared with any other value.
    [[nodiscard]] double own_variance() const;
    [[nodiscard]] double raw_prediction(double work) const { return slope * work - offset; }
    [[nodiscard]] double prediction(double work) const;
    /// Components of slope · W − offset, with exact W.
    [[nodiscard]] Components prediction_inputs(double work) const;
    [[nodiscard]] double prediction_variance(double work) const;
    /// Names of the inputs for the own noise of the pair, and for the scatter of all values between pairs, surfaces or
    /// elastomers.
    [[nodiscard]] std::string own_noise() const;
    [[nodiscard]] std::string scatter_between(const char* groups) const;
};

/// slope · W − offset with all its inputs, including `departure`.
[[nodiscard]] TracedValue raw_prediction(const PairPoint& pair, const TracedValue& work);

/// Own noise of the pair as an input, times a derivative.
[[nodiscard]] Component own_noise(const PairPoint& pair, double derivative);

/// Components of measured − prediction(W), with exact W and without own noise. Relative errors of the measured value
/// are relative to the prediction. Relative to the measured value, pairs with too small measured values would get too
/// large weights.
[[nodiscard]] Components residual_inputs(const PairPoint& pair, double work);

/// Share of an error of slope · W − offset that passes the floor at 0: rectified_share() of its value and its standard
/// error, with exact W.
[[nodiscard]] double share_through_floor(const PairPoint& pair, double work);
/// The share for a given prediction_variance().
[[nodiscard]] double share_through_floor(const PairPoint& pair, double work, double prediction_variance);

/// Factor that converts relative errors of a measured value to errors relative to the prediction.
[[nodiscard]] double predicted_over_measured(const PairPoint& pair, double work);

}  // namespace setae::adhesion
