// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/rubber.hpp"

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {

double rubber_modulus(double density, double temperature, double molar_mass_between_crosslinks) {
    if (!(density > 0.0 && temperature > 0.0 && molar_mass_between_crosslinks > 0.0))
        throw InvalidArgument(
            fmt::format("density, temperature and molar mass must be > 0, got {} kg/m3, {} K, {} kg/mol", density,
                        temperature, molar_mass_between_crosslinks));
    return density * molar_gas_constant * temperature / molar_mass_between_crosslinks;
}

}  // namespace setae::loops
