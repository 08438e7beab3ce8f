// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/study/study.hpp"

namespace setae::study {

/// A file that a study read.
struct InputFile {
    std::string path;         ///< path as named in results
    std::string sha256;       ///< digest of the content, 64 hexadecimal digits; empty where it could not be read
    std::uintmax_t size = 0;  ///< size [bytes]
    std::string state = {};   ///< bytes::file_state() while the digest was taken
    bool settled = true;      ///< false: changed so shortly before that `state` may miss another change
    bool changed = false;     ///< whether another program changed it during the run: its content has no digest then
};

/// Every file that a study names, each once and in its order, the study itself first.
[[nodiscard]] std::vector<InputFile> input_files(const Study& study, parallel::Threads threads = {});

/// Whether a file still has the content whose digest was taken.
[[nodiscard]] bool is_unchanged(const InputFile& input);

/// Release and digest of the build: sources, compiler, flags and libraries, such as "0.1.0+4f1c09ab".
[[nodiscard]] std::string version();

}  // namespace setae::study
