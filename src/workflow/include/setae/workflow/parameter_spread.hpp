// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::workflow {

/// How uncertain spectral parameters are, and why: bootstrap replicas, and pairs of values a given ± leads to.
struct ParameterSpread {
    struct Source {
        std::string name;  ///< such as "tip radius"
        roughness::SpectralParameters plus, minus;
    };
    using Function = std::function<double(const roughness::SpectralParameters&)>;

    std::vector<roughness::SpectralParameters> replicas;
    std::vector<Source> sources;

    /// Covariance of two functions of the parameters: between replicas, plus ¼ (f₊ − f₋)(g₊ − g₋) of each source.
    [[nodiscard]] double covariance(const Function& f, const Function& g) const;
    [[nodiscard]] double standard_error(const Function& f) const;
    /// A function of the parameters, whose value is given, with what this spread says of it.
    [[nodiscard]] Estimate estimate(double value, const Function& f) const;
};

}  // namespace setae::workflow
