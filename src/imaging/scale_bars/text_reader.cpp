// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_reader.hpp"

#include <cctype>

#include <omp.h>
#include <tesseract/baseapi.h>

namespace setae::imaging {

namespace {

/// As long as it lives, OpenMP's regions (Tesseract's inner loops) run in the thread that calls.
struct OneThread {
    int before = omp_get_max_active_levels();
    OneThread() { omp_set_max_active_levels(0); }
    ~OneThread() { omp_set_max_active_levels(before); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;
};

}  // namespace

struct TextReader::Engine {
    tesseract::TessBaseAPI api;
    bool started = false;
    std::string fault;
};

TextReader::TextReader() : engine_(std::make_unique<Engine>()) {}
TextReader::~TextReader() = default;

const std::string& TextReader::fault() const { return engine_->fault; }

std::optional<std::string> TextReader::read(const cv::Mat1b& line) {
    const OneThread one_thread;
    auto& engine = *engine_;
    if (!engine.started) {
        engine.started = true;
        engine.api.SetVariable("debug_file", "/dev/null");
        if (engine.api.Init(nullptr, "eng", tesseract::OEM_LSTM_ONLY) != 0) {
            engine.fault =
                "no data of Tesseract for English; install tesseract-ocr-eng, or set TESSDATA_PREFIX to the folder of eng.traineddata";
        } else {
            engine.api.SetVariable("debug_file", "/dev/null");
            engine.api.SetVariable("tessedit_char_whitelist", "0123456789.,/-nmu\u00b5pkA\u00c5");
            engine.api.SetPageSegMode(tesseract::PSM_SINGLE_LINE);
        }
    }
    if (!engine.fault.empty()) return std::nullopt;
    engine.api.SetImage(line.data, line.cols, line.rows, 1, static_cast<int>(line.step));
    engine.api.SetSourceResolution(300);
    const std::unique_ptr<char[]> words(engine.api.GetUTF8Text());
    std::string text = words ? words.get() : "";
    std::erase_if(text, [](unsigned char letter) { return std::isspace(letter) != 0; });
    engine.api.ClearAdaptiveClassifier();
    if (text.empty()) return std::nullopt;
    return text;
}

}  // namespace setae::imaging
