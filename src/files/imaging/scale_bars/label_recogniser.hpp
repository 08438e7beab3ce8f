// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

namespace setae::imaging {

/// Recognises lines made of digits and the units of lengths by Tesseract, whose library is loaded when first asked.
/// Works in one thread; prints nothing.
class LabelRecogniser {
public:
    LabelRecogniser();
    ~LabelRecogniser();
    LabelRecogniser(const LabelRecogniser&) = delete;
    LabelRecogniser& operator=(const LabelRecogniser&) = delete;

    /// The line without its blanks, from dark letters on white; nothing where Tesseract is not there (see fault) or
    /// knows no letter.
    [[nodiscard]] std::optional<std::string> read(const cv::Mat1b& line);
    /// Why nothing can be read; empty as long as nothing is known against it.
    [[nodiscard]] const std::string& fault() const;

private:
    struct Engine;
    std::unique_ptr<Engine> engine_;
};

}  // namespace setae::imaging
