// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"

namespace setae::crack_front {

/// Stiffness of a front against waves along it, K: ã_n → q_n ã_n with q_n = n times that of the longest wave.
class LineElasticity {
public:
    LineElasticity(Index points, double longest_wave);

    [[nodiscard]] Index points() const { return forward_.points(); }
    /// K a. `in` and `out` may be the same.
    void stiffened(const Array1D& in, Array1D& out) { filtered(in, out, 0.0, 1.0, false); }
    /// (s + c K)⁻¹ a, s > 0.
    void softened(const Array1D& in, Array1D& out, double s, double c) { filtered(in, out, s, c, true); }
    /// da/dz: waves times i q_n, the shortest left out.
    void slopes(const Array1D& in, Array1D& out);
    /// Part of (K a)_j due to a_j.
    [[nodiscard]] double own() const { return own_; }

private:
    void filtered(const Array1D& in, Array1D& out, double s, double c, bool inverse);

    fourier::RealTransform forward_;
    fourier::InverseRealTransform back_;
    double longest_wave_, own_;
    fourier::Buffer<double> line_;
    fourier::Buffer<fourier::Complex> modes_;
};

}  // namespace setae::crack_front
