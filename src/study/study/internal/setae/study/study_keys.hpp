// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace setae::study {

/// A key of a study's file as a page shows it.
struct KeyDescription {
    std::string key;
    std::string type;      ///< such as "quantity ± error", or the words it takes
    std::string unit;      ///< SI, of quantities: any unit of that dimension may be written
    std::string standard;  ///< default; "required"; empty where the meaning states the effect of a missing key
    std::string meaning;
};

/// The keys of one table.
struct KeyTable {
    std::string name;  ///< name in the file, such as "[surfaces.NAME]"
    std::string meaning;
    std::vector<KeyDescription> keys;
};

/// Every table of a study's file with every key it may hold: those that read_study() reads by.
[[nodiscard]] std::vector<KeyTable> study_keys();

}  // namespace setae::study
