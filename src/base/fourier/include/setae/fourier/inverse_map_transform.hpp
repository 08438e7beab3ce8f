// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "setae/core/arrays.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::fourier {

/// Writes line m of a half spectrum: the modes H(0 … nx − 1, m). Called once per line, from any thread.
using SpectrumLine = std::function<void(Index m, Complex* modes)>;

/// The map of a half spectrum, without a prefactor: the inverse of transform_map.
///
///   h_ij = sum_{k,m} H(k, m) exp(2πi (ik/nx + jm/ny)),  m = 0 … ny/2 given, H(nx − k, ny − m) = conj H(k, m)
///
/// Lines 0 and, for even ny, ny/2 hold both members of such a pair and must satisfy the condition; the map is real by
/// construction. Lines are computed, transformed along x and stored in the map, whose rows are then transformed in
/// place. Memory: the map and one block per thread, in two passes. O(nx ny log(nx ny)). Same bytes for any number of
/// threads.
/// @throws InvalidArgument for a map without points; exceptions of `load` are passed on.
void inverse_transform_map(const SpectrumLine& load, Eigen::Ref<Array2D> map, parallel::Threads threads);

/// inverse_transform_map in two steps, for a map of which only some rows are needed: the transform along x in the
/// constructor, that along y for the requested rows.
class InverseMapTransform {
public:
    /// map: outlives this object; its rows are heights only after make_rows(), the others are undefined.
    InverseMapTransform(const SpectrumLine& load, Eigen::Ref<Array2D> map, parallel::Threads threads);
    ~InverseMapTransform();
    InverseMapTransform(InverseMapTransform&&) noexcept;
    InverseMapTransform& operator=(InverseMapTransform&&) noexcept;

    /// Computes rows first … last − 1; each row once.
    void make_rows(Index first, Index last, parallel::Threads threads);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace setae::fourier
