// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::benchmarks {

/// Lets the process's peak memory count from now on, where the system has a way.
void forget_peak_memory();

/// Memory of the process [bytes]: held now, and at most since forget_peak_memory(); 0 where the system does not tell.
struct ProcessMemory {
    double held = 0.0;
    double peak = 0.0;
};
[[nodiscard]] ProcessMemory process_memory();

}  // namespace setae::benchmarks
