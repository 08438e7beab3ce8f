// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "setae/topography/polynomial_surface.hpp"

namespace setae::topography {

/// Powers (a, b) of a polynomial, and the highest of each.
struct Terms {
    std::vector<std::array<Index, 2>> powers;
    Index x = 0, y = 0;

    [[nodiscard]] Index count() const { return static_cast<Index>(powers.size()); }
};

/// @throws InvalidArgument as fitted_polynomial.
[[nodiscard]] Terms terms_of(const PolynomialDegrees& degrees, bool line);
/// For a line along the columns of its only row.
[[nodiscard]] Terms turned(Terms terms);

/// Normal equations of the Legendre coefficients of a polynomial, heights relative to an origin.
struct NormalEquations {
    Array2D gram;
    Array1D moments;
    double origin = 0.0;
    Index points = 0;  ///< number of points used
};

/// The matrix of coefficients from a solution of the normal equations.
[[nodiscard]] Array2D arranged(const Terms& terms, const Array1D& solution, double origin);

/// Sums over the used points of a map, band by band of its scan lines.
class PolynomialFit {
public:
    PolynomialFit(Terms terms, Index ny);

    /// Adds the scan lines first, first + 1, …; chosen: of the band's shape, or null for all points. Same bytes for any
    /// number of threads.
    void add(const ArrayView2D& band, Index first, const std::uint8_t* chosen, parallel::Threads threads);
    [[nodiscard]] NormalEquations equations() const;

private:
    Terms terms_;
    Array2D table_;                 // of Legendre polynomials at the scan lines
    std::optional<double> origin_;  // a used height: sums about it lose no digits to an offset
    Array2D heights_, points_;  // Σ h P_a P_b; Σ P_k P_l up to twice the degrees, of which products of terms are sums
};

/// Positions of the points of a polyline: u = (x − middle)/half.
struct PolylinePlaces {
    explicit PolylinePlaces(const Profile& profile);
    double middle, half;
    Array1D u;
};

/// Integrals over the segments with both ends selected; all segments if the mask is empty.
[[nodiscard]] NormalEquations polyline_equations(const Profile& profile, const PolylinePlaces& places,
                                                 const Terms& terms, const Mask& chosen);

/// An origin and a polynomial that are subtracted from rows of a map; a large origin causes no loss of digits.
class PolynomialRows {
public:
    PolynomialRows(double origin, Array2D coefficients, Index rows, Index ny);

    /// Heights of row i at the scan lines first … first + n − 1 without both; `rest` may be `heights`.
    void take_from(Index i, Index first, const double* heights, double* rest, Index n) const;
    [[nodiscard]] Index lines() const { return table_.cols(); }

private:
    double origin_;
    Array2D coefficients_;
    Array2D table_;  // of Legendre polynomials at the scan lines
    Index rows_;
};

/// Subtracts an origin and a polynomial from the scan lines first, first + 1, … of a map with ny.
void subtract(double origin, const Array2D& coefficients, Eigen::Ref<Array2D> band, Index first, Index ny,
              parallel::Threads threads);

}  // namespace setae::topography
