// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SETAE_COUNTS_BYTES 1
#endif

namespace setae::tests {

/// Bytes that the program has asked malloc for so far, in all its threads; those of Eigen and of `new` are among them.
/// Nothing is counted where sanitizers have a malloc of their own.
inline std::atomic<std::uint64_t> allocated_bytes{0};

/// Exponent p of cost ~ n^p between two sizes.
inline double exponent(double n, double cost, double larger_n, double larger_cost) {
    return std::log(larger_cost / cost) / std::log(larger_n / n);
}

/// Bytes that a call asks for.
template <class Call>
double bytes_of(const Call& call) {
    const auto before = allocated_bytes.load();
    call();
    return static_cast<double>(allocated_bytes.load() - before);
}

}  // namespace setae::tests

#ifdef SETAE_COUNTS_BYTES
extern "C" void* __libc_malloc(std::size_t bytes);
// weak: every file of a program of tests that includes this has one
extern "C" __attribute__((weak)) void* malloc(std::size_t bytes) {
    setae::tests::allocated_bytes.fetch_add(bytes, std::memory_order_relaxed);
    return __libc_malloc(bytes);
}
#endif
