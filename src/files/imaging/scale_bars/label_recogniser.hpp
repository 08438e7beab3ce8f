// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

namespace setae::imaging {

/// Recognises lines made of digits and the units of lengths by Tesseract, whose library is loaded on first use. Works
/// in one thread; prints nothing.
class LabelRecogniser {
public:
    LabelRecogniser();
    ~LabelRecogniser();
    LabelRecogniser(const LabelRecogniser&) = delete;
    LabelRecogniser& operator=(const LabelRecogniser&) = delete;

    /// The line without its blanks, from dark letters on white; empty without Tesseract (see fault) or if it recognises
    /// no letter.
    [[nodiscard]] std::optional<std::string> read(const cv::Mat1b& line);
    /// Why nothing can be read; empty if no problem is known.
    [[nodiscard]] const std::string& fault() const;

private:
    struct Engine;
    std::unique_ptr<Engine> engine_;
};

}  // namespace setae::imaging
