// SPDX-License-Identifier: GPL-3.0-or-later
#include "refined_curve.hpp"

#include <cmath>
#include <vector>

namespace setae::spectra {
namespace {

constexpr double per_decade = 20.0;
constexpr int smooth_rounds = 6, rounds = 16;

struct Node {
    double q, value;
};

class Refinement {
public:
    Refinement(const std::function<double(double)>& function, double tolerance)
        : function_(function), tolerance_(tolerance) {}

    void begin(double q) { nodes_.push_back({q, function_(q)}); }

    /// Nodes from the last one to q; false if the function ends before.
    bool go_to(double q) {
        Node to{q, function_(q)};
        const bool ends = !(to.value > 0.0);
        if (ends) {
            // bisected, so the end is not moved to a node
            Node outside = to;
            to = nodes_.back();
            for (int round = 0; round < 60; ++round) {
                const double middle = 0.5 * (to.q + outside.q), value = function_(middle);
                (value > 0.0 ? to : outside) = {middle, value};
            }
            if (!(to.q > nodes_.back().q)) return false;
        }
        refine(nodes_.back(), to, 0, 0.0);
        return !ends;
    }

    [[nodiscard]] RefinedCurve curve() const {
        const auto n = static_cast<Index>(nodes_.size());
        RefinedCurve result{Array1D(n), Array1D(n)};
        for (Index i = 0; i < n; ++i) {
            result.nodes[i] = nodes_[static_cast<std::size_t>(i)].q;
            result.values[i] = nodes_[static_cast<std::size_t>(i)].value;
        }
        return result;
    }

private:
    void refine(const Node& from, const Node& to, int round, double deviation_before) {
        const double q = std::sqrt(from.q * to.q);
        if (round < rounds && q > from.q && q < to.q) {
            const Node middle{q, function_(q)};
            const double between = std::sqrt(from.value) * std::sqrt(to.value),
                         deviation = std::abs(middle.value - between) / between;
            // the deviation of a smooth curve decreases to a quarter with each halving, that of a bent one to a half,
            // at a jump it is constant
            const bool helps_little = deviation > deviation_before / 3.0;
            if (middle.value > 0.0 && deviation > tolerance_ && (round < smooth_rounds || helps_little)) {
                refine(from, middle, round + 1, deviation);
                refine(middle, to, round + 1, deviation);
                return;
            }
        }
        nodes_.push_back(to);
    }

    const std::function<double(double)>& function_;
    double tolerance_;
    std::vector<Node> nodes_;
};

}  // namespace

RefinedCurve refined_curve(const std::function<double(double)>& function, double lower, double upper,
                           double tolerance) {
    if (!(function(lower) > 0.0)) return {};
    Refinement refinement(function, tolerance);
    refinement.begin(lower);
    const int steps = static_cast<int>(std::ceil(per_decade * std::log10(upper / lower)));
    for (int step = 1; step <= steps; ++step)
        if (!refinement.go_to(step == steps ? upper
                                            : lower * std::pow(upper / lower, static_cast<double>(step) / steps)))
            break;
    return refinement.curve();
}

}  // namespace setae::spectra
