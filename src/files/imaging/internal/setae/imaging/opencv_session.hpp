// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "setae/parallel/for_each.hpp"

namespace setae::imaging {

/// After this call OpenCV writes nothing to the streams of the program and uses the number of threads of Threads{}; its
/// exceptions are reported where they are caught.
inline void limit_opencv() {
    static const bool quiet = [] {
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
        cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; });
        return true;
    }();
    static_cast<void>(quiet);
    const int threads = parallel::Threads{}.resolved();
    if (cv::getNumThreads() != threads) cv::setNumThreads(threads);
}

}  // namespace setae::imaging
