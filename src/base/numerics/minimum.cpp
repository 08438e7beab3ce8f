// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/numerics/minimum.hpp"

#include <cstdint>

#include <boost/math/tools/minima.hpp>

#include "setae/parallel/cancellation.hpp"

namespace setae::numerics {

Minimum minimum_between(const std::function<double(double)>& function, double lower, double upper, int bits) {
    std::uintmax_t rounds = 200;
    const auto evaluated = [&](double place) {
        parallel::stop_if_cancelled();
        return function(place);
    };
    const auto [place, value] = boost::math::tools::brent_find_minima(evaluated, lower, upper, bits, rounds);
    return {place, value};
}

}  // namespace setae::numerics
