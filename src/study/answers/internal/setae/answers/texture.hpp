// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/output/json.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/texture/profile_parameters.hpp"

namespace setae::answers {

/// What `setae params --standard` is asked: which parameters, behind which filters, written how.
struct TextureRequest {
    std::string standard, s_filter, l_filter, section_length, kind, averages, mean_line, between, format,
        material_height, only;
    std::optional<double> material_ratio;

    /// Whether a standard's parameters are asked for.
    /// @throws InvalidArgument where only options of them are given.
    [[nodiscard]] bool asked() const;

    /// Parameters of one measurement; of a map by ISO 21920-2 the mean over its scan lines, with the standard error of
    /// their spread.
    [[nodiscard]] std::vector<texture::TextureParameter> parameters_of(const topography::Measurement& measurement,
                                                                       parallel::Threads threads) const;

    /// Symbols of the table that `only` names. @throws InvalidArgument for others.
    [[nodiscard]] std::vector<std::string> chosen() const;

private:
    [[nodiscard]] texture::Filters filters() const;
    [[nodiscard]] texture::ProfileOptions profile() const;
};

/// Parameters of one measurement.
struct MeasuredTexture {
    std::string file;
    std::string measurement;
    std::vector<texture::TextureParameter> parameters;
};

/// Parameters of all measurements of a surface, and what is wrong with them.
struct TextureAnswer {
    std::vector<MeasuredTexture> list;
    std::vector<Alert> alerts;
    std::vector<std::string> failures;  ///< of measurements that could not be read
};

/// every_measurement: the first failure is thrown. @throws what reading and the parameters throw then.
[[nodiscard]] TextureAnswer texture_of(const study::SurfaceInput& surface, const TextureRequest& request,
                                       parallel::Threads threads = {}, bool every_measurement = false);

/// A list of quantities, each with "filter", "status", "file" and "measurement".
[[nodiscard]] output::Json to_json(const TextureAnswer& answer);

}  // namespace setae::answers
