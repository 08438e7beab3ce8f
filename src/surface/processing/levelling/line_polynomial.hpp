// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "scan_lines.hpp"

namespace setae::processing {

/// Polynomials of lines with the same number of points.
class LinePolynomial {
public:
    /// @throws InvalidArgument for a degree outside 0 … 12.
    LinePolynomial(Index degree, Index points);

    /// Legendre coefficients of the best fit to the used points of a line; empty if the points do not determine them.
    [[nodiscard]] std::optional<Array1D> fitted(LineBand& band, Index line) const;
    /// Subtracts them from a line.
    void subtract(const Array1D& coefficients, double* heights) const;

private:
    Index degree_;
    Array2D table_;                   // up to twice the degree
    std::optional<Array2D> inverse_;  // of the normal equations for a line without gaps
};

}  // namespace setae::processing
