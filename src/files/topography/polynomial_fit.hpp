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
/// Of a line that lies along the columns of its one row.
[[nodiscard]] Terms turned(Terms terms);

/// Normal equations of a polynomial's Legendre coefficients, heights counted from an origin.
struct NormalEquations {
    Array2D gram;
    Array1D moments;
    double origin = 0.0;
    Index points = 0;  ///< that count
};

/// The matrix of coefficients from a solution of the normal equations.
[[nodiscard]] Array2D arranged(const Terms& terms, const Array1D& solution, double origin);

/// Sums over a map's points that count, band by band of its scan lines.
class PolynomialFit {
public:
    PolynomialFit(Terms terms, Index ny);

    /// Adds the scan lines first, first + 1, …; chosen: of the band's shape, or null for all points. Same bytes for any
    /// number of threads.
    void add(const ArrayView2D& band, Index first, const std::uint8_t* chosen, parallel::Threads threads);
    [[nodiscard]] NormalEquations equations() const;

private:
    Terms terms_;
    Array2D table_;                 // of Legendre's polynomials at the scan lines
    std::optional<double> origin_;  // a height that counts: sums about it lose no digits to an offset
    Array2D heights_, points_;  // Σ h P_a P_b; Σ P_k P_l up to twice the degrees, of which products of terms are sums
};

/// Where a polyline's points lie: u = (x − middle)/half.
struct PolylinePlaces {
    explicit PolylinePlaces(const Profile& profile);
    double middle, half;
    Array1D u;
};

/// Integrals over the segments whose both ends are chosen, all where the mask is empty.
[[nodiscard]] NormalEquations polyline_equations(const Profile& profile, const PolylinePlaces& places,
                                                 const Terms& terms, const Mask& chosen);

/// An origin and a polynomial that are taken from rows of a map; a large origin costs no digits.
class PolynomialRows {
public:
    PolynomialRows(double origin, Array2D coefficients, Index rows, Index ny);

    /// Heights of row i at the scan lines first … first + n − 1 without both; `rest` may be `heights`.
    void take_from(Index i, Index first, const double* heights, double* rest, Index n) const;
    [[nodiscard]] Index lines() const { return table_.cols(); }

private:
    double origin_;
    Array2D coefficients_;
    Array2D table_;  // of Legendre's polynomials at the scan lines
    Index rows_;
};

/// Takes an origin, then a polynomial from the scan lines first, first + 1, … of a map with ny.
void subtract(double origin, const Array2D& coefficients, Eigen::Ref<Array2D> band, Index first, Index ny,
              parallel::Threads threads);

}  // namespace setae::topography
