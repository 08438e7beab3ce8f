// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/constants.hpp"
#include "setae/texture/material_ratio.hpp"

namespace setae::texture {

/// Ratios of functional parameters; the defaults are those of the standards.
struct MaterialRatios {
    double peaks = 0.10;             ///< of Vmp, Vmc, Vvc
    double valleys = 0.80;           ///< of Vmc, Vvc, Vvv
    double extreme = 0.025;          ///< upper end of Sxp
    double extreme_reference = 0.5;  ///< lower end of Sxp
    double upper = 0.02;             ///< upper end of Sdc
    double lower = 0.98;             ///< lower end of Sdc
    double inverse = 0.5;            ///< p of Smc(p)
    std::optional<double> height;    ///< of Smr(c), a height of the measurement [m]; without it Smr is NaN
};

/// Parameters of peaks, core and valleys from the material ratio curve H(p); heights [m] from the mean, volumes per
/// area [m³/m²].
///
///   straight line through the 40 % of the curve with the smallest secant, by least squares of heights;
///   at p = 0 and 1 its heights are c1 and c2
///   Sk = c1 − c2,  Smrk1 = P(c1),  Smrk2 = P(c2)
///   Spk = 2/Smrk1 ∫_c1^∞ P dh,  Svk = 2/(1 − Smrk2) ∫_−∞^c2 (1 − P) dh
///   Vm(p) = ∫_H(p)^∞ P dh,  Vv(p) = ∫_−∞^H(p) (1 − P) dh
///   Vmp = Vm(10 %),  Vmc = Vm(80 %) − Vm(10 %),  Vvc = Vv(10 %) − Vv(80 %),  Vvv = Vv(80 %)
///   Sxp = H(2.5 %) − H(50 %)
///
/// For lines R replaces S. Members have the names of the areal parameters.
/// Source: ISO 25178-2:2021, 4.5 and annex B; ISO 21920-2:2021, 4.5.3 and 4.5.5; ISO 13565-2:1996.
struct FunctionalParameters {
    double Sk = 0.0;
    double Spk = 0.0;
    double Svk = 0.0;
    double Smrk1 = 0.0;  ///< Smr1 of older editions [1]
    double Smrk2 = 0.0;  ///< Smr2 of older editions [1]
    double Spkx = 0.0;   ///< highest point above c1 [m]
    double Svkx = 0.0;   ///< deepest point below c2 [m]
    double Sak1 = 0.0;   ///< ½ Spk Smrk1 [m³/m²]
    double Sak2 = 0.0;   ///< ½ Svk (1 − Smrk2) [m³/m²]
    double Vmp = 0.0, Vmc = 0.0, Vvc = 0.0, Vvv = 0.0;
    double Sxp = 0.0;
    double Sdc = 0.0;
    double Smr = undefined;  ///< P at the requested height [1]
    double Smc = 0.0;        ///< H(p), a height of the measurement [m]
};

/// The line of the core is fitted to the curve between nodes at which it falls by at most 1/1024; heights at ratios and
/// volumes are exact. Cost: about five passes over the heights.
/// @throws UndefinedDataError as bearing_area. For a constant surface all are 0 except Smrk2 = 1.
[[nodiscard]] FunctionalParameters functional_parameters(const MeasurementView& measurement,
                                                         const MaterialRatios& ratios = {},
                                                         Between between = Between::linear,
                                                         parallel::Threads threads = {});

}  // namespace setae::texture
