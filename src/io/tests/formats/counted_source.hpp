// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "setae/io/source.hpp"

namespace setae::io::tests {

/// Bytes in memory that count how many of them are read.
class CountedSource {
public:
    explicit CountedSource(std::string content) : source_(memory_source("counted", std::move(content))) {
        source_.read_into = [read = source_.read_into, count = count_](std::uint64_t offset, std::uint64_t bytes, char* target) {
            *count += bytes;
            read(offset, bytes, target);
        };
    }

    [[nodiscard]] const Source& source() const { return source_; }
    [[nodiscard]] std::uint64_t bytes() const { return *count_; }
    void reset() { *count_ = 0; }

private:
    std::shared_ptr<std::atomic<std::uint64_t>> count_ = std::make_shared<std::atomic<std::uint64_t>>(0);
    Source source_;
};

}  // namespace setae::io::tests
