// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/workflow/loop_file.hpp"

#include "setae/core/errors.hpp"
#include "setae/io/mapping.hpp"
#include "setae/io/table_file.hpp"

namespace setae::workflow {

experiment::LoopAnalysis analyse_loop_file(const std::string& path, const std::optional<std::string>& mapping_path,
                                           const experiment::LensAndCounterBody& bodies, const experiment::AnalysisOptions& options) {
    const auto table = mapping_path ? io::read_mapped_table(path, io::read_mapping(*mapping_path)) : io::read_loop_table(path);
    try {
        return experiment::analyse(experiment::loop_from_table(table), bodies, options, path);
    } catch (const UndefinedDataError& error) {
        throw UndefinedDataError(path + ": " + error.what());
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(path + ": " + error.what());
    }
}

}  // namespace setae::workflow
