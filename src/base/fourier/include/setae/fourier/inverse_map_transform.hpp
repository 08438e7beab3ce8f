// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "setae/core/arrays.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::fourier {

/// Writes line m of a half spectrum: the modes H(0 … nx − 1, m). Called once a line, from any thread.
using SpectrumLine = std::function<void(Index m, Complex* modes)>;

/// The map of a half spectrum, without a factor in front: transform_map the other way.
///
///   h_ij = sum_{k,m} H(k, m) exp(2πi (ik/nx + jm/ny)),  m = 0 … ny/2 given, H(nx − k, ny − m) = conj H(k, m)
///
/// Lines 0 and, for even ny, ny/2 hold both members of such a pair and have to obey it; the map is real by
/// construction. Lines are made, transformed along x and put into the map itself, whose rows are then transformed in
/// place: the map and one block a thread is all the memory there is, and it is passed over twice. O(nx ny log(nx ny)).
/// Same bytes for any number of threads.
/// @throws InvalidArgument for a map without points; what `load` throws.
void inverse_transform_map(const SpectrumLine& load, Eigen::Ref<Array2D> map, parallel::Threads threads);

/// The same in two steps, for a map of which some rows are wanted: the transform along x at once, that along y of the
/// rows asked for.
class InverseMapTransform {
public:
    /// map: lives as long as this; of its rows those made by make_rows() are heights, the others are not to be read.
    InverseMapTransform(const SpectrumLine& load, Eigen::Ref<Array2D> map, parallel::Threads threads);
    ~InverseMapTransform();
    InverseMapTransform(InverseMapTransform&&) noexcept;
    InverseMapTransform& operator=(InverseMapTransform&&) noexcept;

    /// Rows first … last − 1, each once.
    void make_rows(Index first, Index last, parallel::Threads threads);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace setae::fourier
