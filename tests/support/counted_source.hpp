// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "setae/bytes/source.hpp"

namespace setae::tests {

/// A source that counts how many of its bytes are read: bytes in memory, or a file larger than the memory of a test,
/// zeros but for its beginning and its end.
class CountedSource {
public:
    explicit CountedSource(std::string content) : CountedSource(bytes::memory_source("counted", std::move(content))) {}
    /// `size` bytes that begin with `head`.
    CountedSource(const std::string& head, std::uint64_t size) : CountedSource(head, size - head.size(), "") {}
    CountedSource(const std::string& begin, std::uint64_t zeros, const std::string& end)
        : CountedSource(with_zeros(begin, zeros, end)) {}

    [[nodiscard]] const bytes::Source& source() const { return source_; }
    [[nodiscard]] std::uint64_t bytes() const { return *count_; }
    void reset() { *count_ = 0; }

private:
    explicit CountedSource(bytes::Source source) : source_(std::move(source)) {
        source_.read_into = [read = source_.read_into, count = count_](std::uint64_t offset, std::uint64_t bytes,
                                                                       char* target) {
            *count += bytes;
            read(offset, bytes, target);
        };
    }

    static bytes::Source with_zeros(const std::string& begin, std::uint64_t zeros, const std::string& end) {
        const auto tail = begin.size() + zeros;
        return {"large",
                tail + end.size(),
                {},
                [begin, end, tail](std::uint64_t offset, std::uint64_t count, char* target) {
                    std::memset(target, 0, count);
                    for (auto at = offset; at < offset + count && at < begin.size(); ++at)
                        target[at - offset] = begin[at];
                    for (auto at = offset < tail ? tail : offset; at < offset + count; ++at)
                        target[at - offset] = end[at - tail];
                }};
    }

    std::shared_ptr<std::atomic<std::uint64_t>> count_ = std::make_shared<std::atomic<std::uint64_t>>(0);
    bytes::Source source_;
};

}  // namespace setae::tests
