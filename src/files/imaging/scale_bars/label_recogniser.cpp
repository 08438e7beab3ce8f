// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_recogniser.hpp"

#include <omp.h>
#include <tesseract/capi.h>

#include <cctype>
#include <memory>

#include <fmt/format.h>

#include "setae/platform/libraries.hpp"

namespace setae::imaging {
namespace {

/// While it exists, OpenMP regions (Tesseract's inner loops) run in the calling thread.
struct OneThread {
    int before = omp_get_max_active_levels();
    OneThread() { omp_set_max_active_levels(0); }
    ~OneThread() { omp_set_max_active_levels(before); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;
};

/// Functions of Tesseract's library, which stays loaded.
struct Tesseract {
    std::string fault;  ///< why it cannot be called
    void* library = platform::loaded_library("libtesseract.so.5");
#define SETAE_TESSERACT(name) \
    decltype(&TessBaseAPI##name) name = function<decltype(&TessBaseAPI##name)>("TessBaseAPI" #name)
    SETAE_TESSERACT(Create);
    SETAE_TESSERACT(Delete);
    SETAE_TESSERACT(Init2);
    SETAE_TESSERACT(SetVariable);
    SETAE_TESSERACT(SetPageSegMode);
    SETAE_TESSERACT(SetImage);
    SETAE_TESSERACT(SetSourceResolution);
    SETAE_TESSERACT(GetUTF8Text);
    SETAE_TESSERACT(ClearAdaptiveClassifier);
#undef SETAE_TESSERACT
    decltype(&TessDeleteText) DeleteText = function<decltype(&TessDeleteText)>("TessDeleteText");

    static const Tesseract& loaded() {
        static const Tesseract library;
        return library;
    }

private:
    template <class Function>
    Function function(const char* name) {
        void* const found = library ? platform::function_of(library, name) : nullptr;
        if (!found && fault.empty()) {
            const auto reason = platform::loading_error();
            fault =
                fmt::format("Tesseract cannot be loaded ({}); install libtesseract5", reason.empty() ? name : reason);
        }
        return reinterpret_cast<Function>(found);
    }
};

}  // namespace

struct LabelRecogniser::Engine {
    const Tesseract& calls = Tesseract::loaded();
    TessBaseAPI* api = nullptr;
    std::string fault = calls.fault;

    Engine() {
        if (!fault.empty()) return;
        api = calls.Create();
        calls.SetVariable(api, "debug_file", "/dev/null");
        if (calls.Init2(api, nullptr, "eng", tesseract::OEM_LSTM_ONLY) != 0) {
            fault =
                "Tesseract has no data for English; install tesseract-ocr-eng, or set TESSDATA_PREFIX to the "
                "folder of eng.traineddata";
            return;
        }
        calls.SetVariable(api, "debug_file", "/dev/null");
        calls.SetVariable(api, "tessedit_char_whitelist", "0123456789.,/-nmu\u00b5pkA\u00c5");
        calls.SetPageSegMode(api, tesseract::PSM_SINGLE_LINE);
    }
    ~Engine() {
        if (api) calls.Delete(api);
    }
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
};

LabelRecogniser::LabelRecogniser() = default;
LabelRecogniser::~LabelRecogniser() = default;

const std::string& LabelRecogniser::fault() const {
    static const std::string none;
    return engine_ ? engine_->fault : none;
}

std::optional<std::string> LabelRecogniser::read(const cv::Mat1b& line) {
    const OneThread one_thread;
    if (!engine_) engine_ = std::make_unique<Engine>();
    if (!engine_->fault.empty()) return std::nullopt;
    const auto& calls = engine_->calls;
    auto* const api = engine_->api;
    calls.SetImage(api, line.data, line.cols, line.rows, 1, static_cast<int>(line.step));
    calls.SetSourceResolution(api, 300);
    const std::unique_ptr<char, decltype(calls.DeleteText)> words(calls.GetUTF8Text(api), calls.DeleteText);
    std::string text = words ? words.get() : "";
    std::erase_if(text, [](unsigned char letter) { return std::isspace(letter) != 0; });
    calls.ClearAdaptiveClassifier(api);
    if (text.empty()) return std::nullopt;
    return text;
}

}  // namespace setae::imaging
