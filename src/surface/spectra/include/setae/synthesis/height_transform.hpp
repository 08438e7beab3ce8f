// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"

namespace setae::synthesis {

/// An increasing function g of a standard normal number z whose values have zero mean and unit variance.
using HeightTransform = std::function<double(double)>;

/// Shape of a height distribution; Gaussian heights have 0 and 3.
struct HeightShape {
    double skewness = 0.0;  ///< ⟨g³⟩
    double kurtosis = 3.0;  ///< ⟨g⁴⟩
};

/// Johnson's curve of a given shape, standardised.
///
///   g = (y − ⟨y⟩)/σ_y,  y = sinh((z − γ)/δ)          heavier tails than the log-normal curve of that skewness
///                       y = 1/(1 + exp(−(z − γ)/δ))  lighter tails: y is bounded
///                       y = exp(z/δ)                 on the line between
///
/// The shape is accurate to a relative 1e-6. Domain: |skewness| <= 4; kurtosis from that of the bounded curve with δ =
/// ½ (1.63, 2.85, 6.6, 22.5 at skewness 0, 1, 2, 4) to that of the unbounded one, 4·10⁶; δ below ½ gives two sharp
/// peaks.
/// @throws InvalidArgument for a shape outside the domain, with the range of kurtosis at that skewness.
/// Source: Johnson, Biometrika 36 (1949) 149, eqs. (31), (37).
[[nodiscard]] HeightTransform johnson_heights(const HeightShape& shape);

/// Log-normal heights: long peaks for a positive skewness, long valleys for a negative one; Gaussian for 0.
///
///   g = (exp(σz − σ²/2) − 1)/√(w − 1),  skewness = (w + 2) √(w − 1),  w = exp(σ²)
///
/// @throws InvalidArgument for a skewness that is not finite.
[[nodiscard]] HeightTransform lognormal_heights(double skewness);

/// Shape of the values of a transform, by quadrature over |z| <= 12; relative error below 1e-8 for smooth transforms.
[[nodiscard]] HeightShape shape_of(const HeightTransform& transform);

/// Effect of a transform on autocorrelations.
///
///   ρ_g = Σ_n w_n ρ^n,  w_n = c_n²/Σ c_n²,  c_n = ⟨g(z) He_n(z)⟩/√n!,  n = 1 … 60
///
/// with ρ the autocorrelation of the Gaussian heights. Increasing in ρ; |ρ_g| <= |ρ|: transformed heights decorrelate
/// faster, so part of their power moves to shorter wavelengths.
/// Source: Price, IRE Trans. Inf. Theory 4 (1958) 69; Hermite (Mehler) expansion.
class TransformCorrelation {
public:
    /// @throws InvalidArgument for a transform that is not increasing on the whole, or not finite within |z| <= 12.
    explicit TransformCorrelation(const HeightTransform& transform);

    /// ρ_g of ρ in [−1, 1].
    [[nodiscard]] double transformed(double correlation) const;

    /// dρ_g/dρ.
    [[nodiscard]] double slope(double correlation) const;

    /// ρ for a given ρ_g, to rounding; −1 below ρ_g(−1), the minimum for Gaussian heights, and 1 above 1.
    [[nodiscard]] double parent(double transformed_correlation) const;

private:
    Array1D weights_;  ///< w_1 …
};

}  // namespace setae::synthesis
