// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// A view of a measurement of any kind: created without a copy, valid during the lifetime of the measurement.
class MeasurementView {
public:
    explicit(false) MeasurementView(const topography::HeightMap& map) : which_(&map) {}
    explicit(false) MeasurementView(const topography::LineScan& scan) : which_(&scan) {}
    explicit(false) MeasurementView(const topography::Profile& profile) : which_(&profile) {}
    explicit(false) MeasurementView(const topography::Measurement& measurement) {
        std::visit([this](const auto& m) { which_ = &m; }, measurement);
    }

    /// visitor(const HeightMap&), visitor(const LineScan&) or visitor(const Profile&).
    template <class Visitor>
    decltype(auto) visit(Visitor&& visitor) const {
        return std::visit([&visitor](const auto* m) -> decltype(auto) { return visitor(*m); }, which_);
    }

    /// nullptr for other kinds.
    template <class Kind>
    [[nodiscard]] const Kind* as() const {
        const auto* pointer = std::get_if<const Kind*>(&which_);
        return pointer ? *pointer : nullptr;
    }

    [[nodiscard]] const topography::Metadata& metadata() const {
        return visit([](const auto& m) -> const topography::Metadata& { return m.metadata; });
    }

private:
    std::variant<const topography::HeightMap*, const topography::LineScan*, const topography::Profile*> which_;
};

}  // namespace setae::texture
