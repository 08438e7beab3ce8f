// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/synthesis/random_surface.hpp"

namespace setae::synthesis {

/// An increasing function g of a standard normal number z whose values have zero mean and unit variance.
using HeightTransform = std::function<double(double)>;

/// Shape of a height distribution: skewness ⟨g³⟩ and kurtosis ⟨g⁴⟩ (3 for Gaussian heights).
struct HeightShape {
    double skewness = 0.0;
    double kurtosis = 3.0;
};

/// Johnson's curve with the given shape: sinh((z − γ)/δ) above the log-normal line, a logistic curve of (z − γ)/δ with
/// bounded heights below it, the identity for a Gaussian.
/// Domain: |skewness| <= 4, kurtosis > 1.8 + skewness² for curves with one peak; solved to 1e-8 in both.
/// @throws InvalidArgument where no such curve has that shape.
/// Source: Johnson, Biometrika 36 (1949) 149.
[[nodiscard]] HeightTransform johnson_heights(const HeightShape& shape);

/// (exp(σz − σ²/2) − 1)/√(e^σ² − 1), with σ from the skewness (w + 2)√(w − 1), w = e^σ²; mirrored for a negative one.
[[nodiscard]] HeightTransform lognormal_heights(double skewness);

/// Shape of the values of a transform, by quadrature.
[[nodiscard]] HeightShape shape_of(const HeightTransform& transform);

/// Autocorrelation of g(z) where that of z is ρ.
///
///   ρ_g = Σ_n c_n² ρ^n/Σ_n c_n²,  c_n = ⟨g(z) He_n(z)⟩/√n!
///
/// Increasing in ρ, |ρ_g| <= |ρ| for ρ >= 0. parent_correlation is the inverse on [ρ_g(−1), 1]; below it −1 is returned,
/// since no Gaussian parent is more opposed. Terms up to n = 60.
class CorrelationOfTransform {
public:
    explicit CorrelationOfTransform(const HeightTransform& transform);
    [[nodiscard]] double transformed(double parent_correlation) const;
    [[nodiscard]] double parent(double transformed_correlation) const;

private:
    Array1D weights_;  ///< c_n²/Σ
};

/// Every height h replaced by h_rms g(h/h_rms): same mean 0 and rms in the ensemble, other shape.
///
/// The spectrum changes: the autocorrelation becomes that of CorrelationOfTransform. map: heights whose ensemble rms is
/// gaussian_rms_height [m].
[[nodiscard]] topography::HeightMap transformed_heights(const topography::HeightMap& map, const HeightTransform& transform,
                                                        double gaussian_rms_height);

/// A non-Gaussian surface with the spectrum wanted.
struct NonGaussianSurface {
    topography::HeightMap map;
    /// Share of the parent's variance that had to be dropped, since no Gaussian surface has that autocorrelation; the
    /// spectrum of the map is off by about as much. 0 where the route is exact.
    double dropped_share = 0.0;
};

/// The Gaussian parent whose heights, transformed, have C_iso: the autocorrelation of the wanted spectrum on the grid is
/// taken back through the inverse of CorrelationOfTransform, its transform is the parent's spectrum, negative modes are
/// dropped.
/// @throws InvalidArgument as random_surface does.
/// Source: Grigoriu, Applied Non-Gaussian Processes (1995), translation processes.
[[nodiscard]] NonGaussianSurface non_gaussian_surface(const SpectralDensity& C_iso, const SurfaceGrid& grid,
                                                      const HeightTransform& transform, const SurfaceOptions& options = {});

}  // namespace setae::synthesis
