// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

namespace setae::imaging {

/// Reads lines made of digits and the units of lengths by Tesseract. Starts when first asked; works in one thread;
/// prints nothing.
class TextReader {
public:
    TextReader();
    ~TextReader();
    TextReader(const TextReader&) = delete;
    TextReader& operator=(const TextReader&) = delete;

    /// The line without its blanks, from dark letters on white; nothing where there is no reader (see fault) or no
    /// letter.
    [[nodiscard]] std::optional<std::string> read(const cv::Mat1b& line);
    /// Why nothing can be read; empty as long as nothing is known against it.
    [[nodiscard]] const std::string& fault() const;

private:
    struct Engine;
    std::unique_ptr<Engine> engine_;
};

}  // namespace setae::imaging
