// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/replicates.hpp"

#include <algorithm>

namespace setae::answers {
namespace {

std::vector<std::string> words_of(const std::string& list) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < list.size();) {
        const auto end = std::min(list.find(',', at), list.size());
        if (end > at) words.push_back(list.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

}  // namespace

study::ReplicateColumns ReplicateRequest::columns() const {
    study::ReplicateColumns columns;
    columns.group_by = words_of(group_by);
    columns.quantity = quantity;
    columns.value_column = value;
    columns.error_column = error;
    columns.unit = unit;
    columns.method = method;
    columns.branch = branch;
    columns.elastomer = elastomer;
    return columns;
}

ReplicateSummary replicate_summary(const ReplicateRequest& request) {
    std::vector<study::ExclusionRule> rules;
    if (!request.exclusions.empty()) rules = study::read_exclusions(request.exclusions);
    for (const auto& text : request.exclude) rules.push_back(study::parse_exclusion(text));
    ReplicateSummary summary{.tables = study::read_replicates(request.files, request.columns(), rules), .model = {}};
    auto& data = summary.tables.data;
    data.crossed = words_of(request.crossed);
    summary.model = statistics::mixed_model(
        data, {.pooling = request.each_surface ? statistics::Pooling::none : statistics::Pooling::surfaces});
    return summary;
}

}  // namespace setae::answers
