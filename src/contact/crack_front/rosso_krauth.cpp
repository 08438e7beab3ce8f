// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "front_equation.hpp"

namespace setae::crack_front {
namespace {

/// One search: a front, the cells its points are in, and the one way they go.
class OneWaySearch {
public:
    OneWaySearch(FrontEquation& equation, Array1D& front, const SearchLimits& limits)
        : equation_(equation), front_(front), limits_(limits), cells_(static_cast<std::size_t>(front.size())) {}

    Equilibrium run() {
        const auto& pinning = equation_.pinning();
        for (Index j = 0; j < front_.size(); ++j) cell(j) = pinning.cell(front_[j]);
        if (!held()) return found_;
        evaluate();
        if (found_.converged) return found_;
        go(-balance_.residual.minCoeff() >= balance_.residual.maxCoeff() ? 1 : -1);
        if (found_.left) return found_;
        int sweeps_to_closing = first_closing;
        while (found_.iterations < limits_.max_iterations) {
            for (int k = 0; k < sweeps_to_closing; ++k) {
                if (!sweep()) return found_;
                if (found_.converged) return found_;
            }
            const bool whole = close();
            if (found_.converged || !held()) return found_;
            // the rest is far from linear: more sweeps before the next try
            sweeps_to_closing = whole ? 1 : std::min(2 * sweeps_to_closing, last_closing);
        }
        return found_;
    }

private:
    static constexpr int first_closing = 4, last_closing = 64;

    Index& cell(Index j) { return cells_[static_cast<std::size_t>(j)]; }

    bool held() {
        for (const Index k : cells_) found_.left = found_.left || !equation_.pinning().holds(k);
        return !found_.left;
    }

    void evaluate() {
        equation_.evaluate(front_, cells_, balance_);
        ++found_.iterations;
        found_.residual = balance_.residual.abs().maxCoeff();
        found_.converged = found_.residual <= limits_.tolerance;
    }

    /// A point between two cells is in the cell ahead of its motion.
    void go(int way) {
        way_ = way;
        for (Index j = 0; j < front_.size(); ++j) {
            cell(j) = equation_.pinning().cell(front_[j]);
            if (way < 0 && front_[j] <= equation_.pinning().begin(cell(j))) --cell(j);
        }
        if (held()) evaluate();
    }

    [[nodiscard]] double end_of_cell(Index j) { return equation_.pinning().begin(way_ > 0 ? cell(j) + 1 : cell(j)); }

    /// Every point that is pulled the way it may go moves once; where none is and others are pulled back, as of a front
    /// that begins anywhere, all turn. False where one has left its line.
    bool sweep() {
        const double own = balance_.kernel * equation_.elasticity().own();
        if (!((-way_ * balance_.residual).maxCoeff() > limits_.tolerance)) go(-way_);
        if (found_.left) return false;
        for (Index j = 0; j < front_.size(); ++j) {
            const double pull = -way_ * balance_.residual[j];
            if (!(pull > 0.0)) continue;
            const double stiffness = balance_.stiffness[j] + own;
            const double end = end_of_cell(j);
            if (stiffness > 0.0 && pull < stiffness * std::abs(end - front_[j])) {
                front_[j] += way_ * pull / stiffness;
                continue;
            }
            front_[j] = end;
            cell(j) += way_;
            if (!equation_.pinning().holds(cell(j))) {
                found_.left = true;
                return false;
            }
        }
        evaluate();
        return true;
    }

    /// The linear problem of the cells as they are: all the way where no point leaves its cell, which is then the
    /// equilibrium, else until the first one does. False where it does not help.
    bool close() {
        constexpr double accurate = 1e-10, small = 1e-3;
        // points that would go the other way: not before those that go this way are at rest
        const double own = balance_.kernel * equation_.elasticity().own();
        if ((way_ * balance_.residual).maxCoeff() > small * own * equation_.pinning().points().spacing) return false;
        const auto newton =
            newton_step(equation_.elasticity(), balance_, std::numeric_limits<double>::infinity(), accurate);
        if (!newton.stable) return false;
        double share = 1.0;
        Index first = -1;
        for (Index j = 0; j < front_.size(); ++j) {
            const double begin = equation_.pinning().begin(cell(j)), end = equation_.pinning().begin(cell(j) + 1);
            const double room = newton.step[j] > 0.0 ? end - front_[j] : begin - front_[j];
            if (newton.step[j] == 0.0 || room / newton.step[j] >= share) continue;
            if (way_ * newton.step[j] < 0.0) return false;
            share = room / newton.step[j];
            first = j;
        }
        front_ += share * newton.step;
        if (first >= 0) {
            front_[first] = end_of_cell(first);
            cell(first) += way_;
            if (!held()) return false;
        }
        evaluate();
        return first < 0;
    }

    FrontEquation& equation_;
    Array1D& front_;
    SearchLimits limits_;
    std::vector<Index> cells_;
    Balance balance_;
    Equilibrium found_;
    int way_ = 1;
};

}  // namespace

Equilibrium rosso_krauth(FrontEquation& equation, Array1D& front, const SearchLimits& limits) {
    return OneWaySearch(equation, front, limits).run();
}

}  // namespace setae::crack_front
