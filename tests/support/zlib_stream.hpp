// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <zlib.h>

#include <string>

namespace setae::tests {

/// Content as a zlib stream.
[[nodiscard]] inline std::string zlib_stream(const std::string& content) {
    auto size = compressBound(content.size());
    std::string stream(size, '\0');
    compress(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
             content.size());
    stream.resize(size);
    return stream;
}

}  // namespace setae::tests
