// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::adhesion {

/// Places of all inputs' directions in one vector of deviates.
class Deviates {
public:
    void add(const Components& inputs) {
        for (const auto& [name, component] : inputs) {
            const auto [at, fresh] = places_.try_emplace(name, Place{size_, component.rectangular});
            if (fresh) size_ += component.directions.size();
        }
    }

    /// Inputs of the measured value of a pair, and of its line.
    void add_inputs_of(const PairPoint& pair) {
        for (const auto* inputs :
             {&pair.in_unitputs, &pair.measured_noise, &pair.slope_inputs, &pair.offset_inputs})
            add(*inputs);
    }

    void draw(numerics::RandomKey key) {
        values_ = numerics::normal_numbers(key, 0, size_);
        for (const auto& [name, place] : places_)
            if (place.rectangular)  // one direction each
                values_[place.first] = std::sqrt(12.0) * (normal_probability(values_[place.first]) - 0.5);
    }

    /// Registers a shift of inputs by their components times a number; take_pulls() applies all shifts together.
    void pull(const Components& inputs, double by) {
        if (pulls_.size() != size_) pulls_ = Array1D::Zero(size_);
        for (const auto& [name, component] : inputs)
            pulls_.segment(places_.at(name).first, component.directions.size()) += by * component.directions;
    }
    void take_pulls() {
        if (pulls_.size() == size_) values_ += pulls_;
        pulls_.resize(0);
    }

    /// Shift of a value by the drawn inputs.
    [[nodiscard]] double moved(const Components& inputs) const {
        double sum = 0.0;
        for (const auto& [name, component] : inputs)
            sum += (component.directions * values_.segment(places_.at(name).first, component.directions.size())).sum();
        return sum;
    }

private:
    struct Place {
        Index first = 0;
        bool rectangular = false;
    };
    std::map<std::string, Place> places_;
    Index size_ = 0;
    Array1D values_, pulls_;
};

}  // namespace setae::adhesion
