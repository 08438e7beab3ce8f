// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "known_faults.hpp"
#include "setae/diagnostics/diagnose.hpp"

// sanitizers keep freed memory
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace setae::diagnostics::memory_test {
namespace {

/// A line of /proc/self/status [bytes].
double memory(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name)) return 1024.0 * std::stod(line.substr(name.size() + 1));
    return undefined;
}

/// Peak memory in addition to the map during the diagnosis [bytes].
double additional_memory(const topography::HeightMap& heights) {
    const topography::Measurement map = heights;
    std::ofstream("/proc/self/clear_refs") << 5;  // the peak is counted from here
    const double before = memory("VmRSS:");
    EXPECT_FALSE(diagnose(map, {.threads = {1}}).empty());
    return memory("VmHWM:") - before;
}

/// Noise on waves, a few spikes, strokes, gaps, a tilt and a bow.
topography::HeightMap with_every_fault(Index n) {
    topography::HeightMap map{noise(n, n, 3), {1e-5, 1e-5}};
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            const double x = static_cast<double>(i) / static_cast<double>(n);
            map.heights(i, j) += 30.0 * std::sin(0.02 * static_cast<double>(i + j)) + 900.0 * x * x + 700.0 * x;
        }
    map.heights *= 1e-9;
    for (Index k = 0; k < n / 8; ++k) map.heights((k * 37) % n, (k * 91) % n) += 100e-9;
    for (Index k = 0; k < 6; ++k) map.heights.col(20 + 31 * k).segment(10 * k, n / 3) += 60e-9;
    map.heights.block(n / 2, n / 2, 5, 7).setConstant(undefined);
    return map;
}

TEST(Diagnose, UsesMemoryForOneMoreMapAndItsMasks) {
    const auto small = with_every_fault(512), large = with_every_fault(1024);
    const double bytes = 8.0 * static_cast<double>(large.heights.size());
    const double of_small = additional_memory(small), of_large = additional_memory(large);
    EXPECT_LT(of_large, 1.75 * bytes);
    EXPECT_GT(of_large, 0.9 * bytes);
    // exponent of memory over points
    EXPECT_LT(std::log(of_large / of_small) / std::log(4.0), 1.1);
}

}  // namespace
}  // namespace setae::diagnostics::memory_test

#endif
