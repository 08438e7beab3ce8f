// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "setae/adhesion/generalised_fit.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::adhesion {

/// Effects of pairs, surfaces and elastomers, drawn on request: each group has one number.
class ScatterEffects {
public:
    ScatterEffects(const ModelScatter& scatter, numerics::RandomKey key) : scatter_(scatter), key_(key) {}

    /// Sum of the effects of a pair, its surface and its elastomer.
    [[nodiscard]] double of(const std::string& surface, const std::string& elastomer) {
        const double pair = scatter_.pair * one(surface + '\n' + elastomer);
        const double of_surface = scatter_.surface * one("s" + surface);
        return pair + of_surface + scatter_.elastomer * one("e" + elastomer);
    }

private:
    double one(const std::string& name) {
        const auto [at, fresh] = known_.try_emplace(name, 0.0);
        if (fresh) at->second = numerics::normal_number(key_, known_.size());
        return at->second;
    }

    ModelScatter scatter_;
    numerics::RandomKey key_;
    std::map<std::string, double> known_;
};

}  // namespace setae::adhesion
