// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the table of docs/concepts/tem-projection.md: projection_table > table.md
#include "projection_table.hpp"

#include <fmt/format.h>

int main() {
    using namespace setae;
    bool first = true;
    for (const auto& row : tests::projection_cases()) {
        const auto bias = tests::simulated(row, 8, 1);
        if (first) {
            fmt::print("| H | λ_r, nm | foil, nm | correlation, nm | h_rms | slope |");
            for (const double q : bias.wavevector) fmt::print(" {:.1e} |", q);
            fmt::print("\n|---|---|---|---|---|---|");
            for (Index b = 0; b < bias.wavevector.size(); ++b) fmt::print("---|");
            fmt::print("\n");
            first = false;
        }
        fmt::print("| {} | {:.0f} | {:.1f} | {:.1f} | {:.3f} ± {:.3f} | {:.3f} ± {:.3f} |", row.hurst_exponent,
                   row.rolloff_wavelength * 1e9, row.thickness * 1e9, bias.correlation_length * 1e9,
                   bias.rms_height.value, bias.rms_height.standard_error, bias.rms_slope.value,
                   bias.rms_slope.standard_error);
        for (Index b = 0; b < bias.C1D.size(); ++b)
            fmt::print(" {:.2f} ± {:.2f} |", bias.C1D[b], bias.C1D_standard_error[b]);
        fmt::print("\n");
    }
}
