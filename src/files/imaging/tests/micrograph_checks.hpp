// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "files/micrograph_file.hpp"
#include "micrograph_files.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging::tests {

/// A micrograph from bytes in memory, read as by read_micrograph.
inline Micrograph read_bytes(const std::string& bytes, const MicrographOptions& options = {}) {
    return read_micrograph_file(bytes::memory_source("sample", bytes), options);
}

inline void expect_common_picture(const Micrograph& micrograph, float tolerance = 0) {
    ASSERT_EQ(micrograph.pixels.cols(), columns);
    ASSERT_EQ(micrograph.pixels.rows(), rows);
    for (long i = 0; i < columns * rows; ++i)
        EXPECT_NEAR(micrograph.pixels.data()[i], static_cast<float>(i + 1), tolerance) << i;
}

inline void expect_pixel_size(const Micrograph& micrograph, double x, double y) {
    ASSERT_TRUE(micrograph.pixel_size.has_value());
    EXPECT_NEAR(micrograph.pixel_size->x, x, 1e-9 * x);
    EXPECT_NEAR(micrograph.pixel_size->y, y, 1e-9 * y);
}

inline bool has_alert(const Micrograph& micrograph, const std::string& code) {
    return std::any_of(micrograph.alerts.begin(), micrograph.alerts.end(),
                       [&](const Alert& alert) { return alert.code == code; });
}

/// Message of the refusal of bytes; empty if they are read.
inline std::string refusal(const std::string& bytes, const MicrographOptions& options = {}) {
    try {
        (void)read_bytes(bytes, options);
    } catch (const FormatError& error) {
        return error.what();
    }
    return {};
}

inline void expect_refusal(const std::string& bytes, const std::string& part, const MicrographOptions& options = {}) {
    const auto message = refusal(bytes, options);
    EXPECT_NE(message.find(part), std::string::npos) << "got: " << message << "\nexpected: " << part;
    EXPECT_NE(message.find("at byte"), std::string::npos) << message;
}

}  // namespace setae::imaging::tests
