// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <nlohmann/json.hpp>

#include "setae/answers/containers.hpp"

namespace setae::answers {
namespace {

output::Json surface_json(const formats::ContainerSurface& surface, std::size_t& index,
                          const std::vector<formats::ChannelInfo>& channels) {
    auto measurements = output::Json::array();
    for (const auto& topography : surface.topographies) {
        const auto& info = channels[index];
        measurements.push_back({{"channel", index++},
                                {"name", topography.name},
                                {"format", info.format},
                                {"shape", info.shape},
                                {"size", info.size},
                                {"unit", info.unit},
                                {"original", topography.datafile.original},
                                {"processed_copy", topography.datafile.squeezed},
                                {"detrend_mode", topography.detrend_mode},
                                {"measurement_date", topography.measurement_date},
                                {"readable", info.is_height}});
    }
    return {
        {"name", surface.name}, {"category", surface.category}, {"tags", surface.tags}, {"measurements", measurements}};
}

}  // namespace

output::Json to_json(const std::string& file, const formats::ContainerReport& report) {
    auto surfaces = output::Json::array();
    std::size_t index = 0;
    for (const auto& surface : report.file.container.surfaces)
        surfaces.push_back(surface_json(surface, index, report.channels));
    return {{"file", file},
            {"generation", formats::describe(report.file.generation)},
            {"created_at", report.file.container.created_at},
            {"surfaces", surfaces},
            {"alerts", output::to_json(report.alerts)},
            {"differences", report.differences}};
}

bool at_fault(const formats::ContainerReport& report) {
    return !report.differences.empty() ||
           std::any_of(report.alerts.begin(), report.alerts.end(), [](const Alert& alert) {
               return alert.code == "UNREADABLE_MEMBER" || alert.code == "COPY_DIFFERS";
           });
}

}  // namespace setae::answers
