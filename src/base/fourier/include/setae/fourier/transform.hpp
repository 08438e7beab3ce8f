// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <memory>

#include "setae/core/arrays.hpp"

namespace setae::fourier {

template <class Real>
using ComplexOf = std::complex<Real>;
using Complex = ComplexOf<double>;

// Transforms of double; of float only for search directions.

/// The half spectrum of n real values.
///
///   out_k = sum_{j=0}^{n−1} in_j exp(−2πi jk/n),  k = 0 … n/2
///
/// No prefactor: the physical transform of heights a step Δ apart is Δ · out_k. The rest of the spectrum follows from
/// out_{n−k} = conj(out_k). Plans never depend on timing, so every run gives the same bytes for the same input.
template <class Real>
class RealTransformOf {
public:
    /// @throws InvalidArgument for n < 1.
    explicit RealTransformOf(Index n);
    ~RealTransformOf();
    RealTransformOf(RealTransformOf&&) noexcept;
    RealTransformOf& operator=(RealTransformOf&&) noexcept;

    [[nodiscard]] Index points() const { return points_; }
    [[nodiscard]] Index modes() const { return points_ / 2 + 1; }

    /// `in` (n values) and `out` (modes() values) do not overlap and are aligned to 16 bytes, as in a Buffer. Any
    /// number of threads may call it simultaneously. O(n log n).
    void forward(const Real* in, ComplexOf<Real>* out) const;

private:
    struct Plan;
    Index points_;
    std::unique_ptr<Plan> plan_;
};
using RealTransform = RealTransformOf<double>;

/// The n real values of a half spectrum.
///
///   out_j = sum_{k=0}^{n−1} in_k exp(2πi jk/n),  in_{n−k} = conj(in_k)
///
/// Takes in_0 … in_{n/2}; the imaginary parts of in_0 and, for even n, of in_{n/2} are ignored. No prefactor.
template <class Real>
class InverseRealTransformOf {
public:
    /// @throws InvalidArgument for n < 1.
    explicit InverseRealTransformOf(Index n);
    ~InverseRealTransformOf();
    InverseRealTransformOf(InverseRealTransformOf&&) noexcept;
    InverseRealTransformOf& operator=(InverseRealTransformOf&&) noexcept;

    [[nodiscard]] Index points() const { return points_; }
    [[nodiscard]] Index modes() const { return points_ / 2 + 1; }

    /// `in` (modes() values) is overwritten; see RealTransform::forward.
    void apply(ComplexOf<Real>* in, Real* out) const;

private:
    struct Plan;
    Index points_;
    std::unique_ptr<Plan> plan_;
};
using InverseRealTransform = InverseRealTransformOf<double>;

/// Sign of i in the exponent.
enum class TransformSign { minus, plus };

/// The spectrum of n complex values, in place: z_k = sum_j z_j exp(∓2πi jk/n), no prefactor.
template <class Real>
class ComplexTransformOf {
public:
    using Sign = TransformSign;

    /// @throws InvalidArgument for n < 1.
    explicit ComplexTransformOf(Index n, Sign sign = Sign::minus);
    ~ComplexTransformOf();
    ComplexTransformOf(ComplexTransformOf&&) noexcept;
    ComplexTransformOf& operator=(ComplexTransformOf&&) noexcept;

    [[nodiscard]] Index points() const { return points_; }

    /// `values` are aligned to 16 bytes. Any number of threads may call it simultaneously.
    void apply(ComplexOf<Real>* values) const;

private:
    struct Plan;
    Index points_;
    std::unique_ptr<Plan> plan_;
};
using ComplexTransform = ComplexTransformOf<double>;

/// The spectrum of an even periodic sequence from half of it, in place.
///
///   z_k = x_0 + (−1)^k x_N + 2 sum_{j=1}^{N−1} x_j cos(πjk/N),  k = 0 … N,  x_j = x_{2N−j}
class EvenTransform {
public:
    /// points = N + 1. @throws InvalidArgument for points < 2.
    explicit EvenTransform(Index points);
    ~EvenTransform();
    EvenTransform(EvenTransform&&) noexcept;
    EvenTransform& operator=(EvenTransform&&) noexcept;

    [[nodiscard]] Index points() const { return points_; }

    /// Any number of threads may call it simultaneously.
    void apply(double* values) const;

private:
    struct Plan;
    Index points_;
    std::unique_ptr<Plan> plan_;
};

}  // namespace setae::fourier
