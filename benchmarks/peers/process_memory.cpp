// SPDX-License-Identifier: GPL-3.0-or-later
#include "process_memory.hpp"

#include <fstream>
#include <string>

namespace setae::benchmarks {

void forget_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

ProcessMemory process_memory() {
    ProcessMemory memory;
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        const auto kibibytes = [&] { return 1024.0 * std::stod(line.substr(line.find(':') + 1)); };
        if (line.starts_with("VmRSS:")) memory.held = kibibytes();
        if (line.starts_with("VmHWM:")) memory.peak = kibibytes();
    }
    return memory;
}

}  // namespace setae::benchmarks
