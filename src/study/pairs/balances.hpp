// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study/study_result.hpp"

namespace setae::study {

/// Whether (7) can be evaluated for a pair: a spectrum and a modulus.
[[nodiscard]] bool predictable(const SurfaceResult& surface, const ElastomerResult& elastomer);

/// Balances of one pair as lines in W_int, with the covariances their uncertain inputs give them.
class Balances {
public:
    /// Of a surface with parameters of its own choice, such as those of its spectrum cut elsewhere. Keeps references.
    Balances(const SurfaceResult& surface, const ElastomerResult& elastomer,
             const roughness::SpectralParameters& parameters)
        : surface_(surface), elastomer_(elastomer), parameters_(parameters) {}

    [[nodiscard]] adhesion::PairPoint modified() const;             ///< (7)
    [[nodiscard]] adhesion::PairPoint persson_tosatti() const;      ///< (S13)
    [[nodiscard]] adhesion::PairPoint without_area_change() const;  ///< (2)

private:
    using AreaRatio = double (*)(double);

    /// prediction = W r − γ1 (r − 1) − E* u; its variance is quadratic in W − γ1
    [[nodiscard]] adhesion::PairPoint point(AreaRatio area_ratio, const Estimate& surface_energy) const;

    const SurfaceResult& surface_;
    const ElastomerResult& elastomer_;
    const roughness::SpectralParameters& parameters_;
};

}  // namespace setae::study
