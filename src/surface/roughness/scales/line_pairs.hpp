// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/fourier/fast_length.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::scales {

/// Sums over all pairs of defined points of lines, by lag: ½ Σ (h_i − h_{i+k})² and the number of pairs.
///
/// Lines without holes add |G|² to one spectrum and their squares to one series; lines with holes, w = 1 at defined
/// points, g = w h, s = w h², add Re(conj(W) S) − |G|² and |W|². Two inverse transforms at the end are sufficient for
/// all lines.
class LinePairs {
public:
    LinePairs(Index points, bool periodic);

    /// Lines of shape (points, any). Each is centred on its mean.
    void add(const ArrayView2D& lines, parallel::Threads threads);

    struct Sums {
        Array1D squares;  ///< of lags 0 … points − 1, periodic 0 … points/2
        Array1D pairs;
    };
    [[nodiscard]] Sums sums() const;

private:
    struct Part;
    void add_line(const double* line, Part& part) const;
    [[nodiscard]] Array1D correlation(const Array1D& spectrum) const;

    Index points_, padded_;
    bool periodic_;
    fourier::RealTransform transform_;
    double whole_lines_ = 0.0;
    Array1D whole_power_, whole_squares_, holed_spectrum_, holed_pairs_;
};

}  // namespace setae::scales
