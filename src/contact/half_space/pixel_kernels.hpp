// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Displacements of a half-space of contact modulus 1 Pa under pressure on one pixel.
namespace setae::half_space {

/// Half widths of a pixel [m].
struct HalfPixel {
    double x = 0.0, y = 0.0;
};

/// Displacement [m] at (x, y) from the centre of a rectangle under a pressure of 1 Pa.
///
///   u = 1/π ∫∫ dx' dy'/√((x − x')² + (y − y')²)
///
/// Relative error below 1e-13 at any distance, corners and edges included, for pixels up to 10 times as long as wide:
/// the closed form near by, with differences of asinh that do not cancel; a Gauss rule, whose terms are all positive,
/// beyond eight half-widths.
/// Source: Love, Phil. Trans. R. Soc. A 228 (1929) 377; Johnson, Contact Mechanics (1985), eq. 3.25.
[[nodiscard]] double rectangle_displacement(double x, double y, const HalfPixel& half);

/// Displacement amplitude [m] at y from the middle of a strip |y'| < half_width under a pressure of 1 Pa cos(qx).
///
///   u = 2/π ∫ K_0(q |y − y'|) dy'                  q > 0
///     = −2/π ∫ (ln(|y − y'|/2L) + γ) dy'           q = 0
///
/// A pressure that does not vary along x moves the whole body: the zero of u is that of a row of point forces with
/// spacing L, Σ 1/√((x + nL)² + y²) − Σ 1/|nL|. Relative error below 1e-13 (q = 0: of the largest term).
/// Source: DLMF 10.32.9 integrated over y, by the trapezoidal rule, which converges exponentially here.
[[nodiscard]] double strip_displacement(double wavevector, double y, double half_width, double repeat);

}  // namespace setae::half_space
