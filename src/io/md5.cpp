// SPDX-License-Identifier: GPL-3.0-or-later
#include "md5.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "bytes.hpp"

namespace setae::io {
namespace {

using State = std::array<std::uint32_t, 4>;
constexpr std::size_t block_bytes = 64;

/// floor(2^32 |sin(i + 1)|), RFC 1321 section 3.4.
std::array<std::uint32_t, 64> sine_table() {
    std::array<std::uint32_t, 64> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<std::uint32_t>(std::floor(4294967296.0 * std::abs(std::sin(static_cast<double>(i + 1)))));
    return table;
}

void transform(State& state, const char* block) {
    static const auto sine = sine_table();
    static constexpr std::array<std::array<int, 4>, 4> shifts{{{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}}};
    auto [a, b, c, d] = state;
    for (std::size_t i = 0; i < 64; ++i) {
        std::uint32_t mixed = 0;
        std::size_t word = i;
        switch (i / 16) {
            case 0: mixed = (b & c) | (~b & d); break;
            case 1: mixed = (d & b) | (~d & c); word = (5 * i + 1) % 16; break;
            case 2: mixed = b ^ c ^ d; word = (3 * i + 5) % 16; break;
            default: mixed = c ^ (b | ~d); word = (7 * i) % 16; break;
        }
        mixed += a + sine[i] + load<std::uint32_t>(block + 4 * word, std::endian::little);
        a = d;
        d = c;
        c = b;
        b += std::rotl(mixed, shifts[i / 16][i % 4]);
    }
    state[0] += a;
    state[1] += b;
    state[2] += c;
    state[3] += d;
}

}  // namespace

std::string md5(std::string_view bytes) {
    State state{0x67452301u, 0xefcdab89u, 0x98badcfeu, 0x10325476u};
    const auto whole = bytes.size() / block_bytes * block_bytes;
    for (std::size_t at = 0; at < whole; at += block_bytes) transform(state, bytes.data() + at);
    std::string tail(bytes.substr(whole));
    tail += '\x80';
    tail.resize((tail.size() + 8 + block_bytes - 1) / block_bytes * block_bytes - 8, '\0');
    const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
    for (int i = 0; i < 8; ++i) tail += static_cast<char>((bits >> (8 * i)) & 0xff);
    for (std::size_t at = 0; at < tail.size(); at += block_bytes) transform(state, tail.data() + at);
    std::string digest;
    for (const auto word : state)
        for (int shift = 0; shift < 32; shift += 8) digest += fmt::format("{:02x}", (word >> shift) & 0xffu);
    return digest;
}

}  // namespace setae::io
