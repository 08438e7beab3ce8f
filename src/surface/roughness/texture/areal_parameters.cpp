// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/areal_parameters.hpp"

#include <cmath>

#include <fmt/format.h>

#include "feature_parameters.hpp"
#include "filtered.hpp"
#include "hybrid_parameters.hpp"
#include "parameter_rows.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/texture/height_parameters.hpp"
#include "spatial_parameters.hpp"

namespace setae::texture {
namespace {

/// Minimum number of independent patches for reliable parameters.
constexpr double min_patches = 10.0;

/// Standard errors of Gaussian heights from the autocorrelation of the map.
class HeightErrors {
public:
    HeightErrors(const SpatialParameters& spatial, double area) : areas_(spatial.correlation_areas), area_(area) {}

    [[nodiscard]] Estimate of_scale(double value) const {
        return with(value, value * std::sqrt(areas_[0] / (2.0 * area_)));
    }
    [[nodiscard]] Estimate of_skewness(double value) const { return with(value, std::sqrt(6.0 * areas_[1] / area_)); }
    [[nodiscard]] Estimate of_kurtosis(double value) const { return with(value, std::sqrt(24.0 * areas_[2] / area_)); }

    /// Equivalent number of independent patches.
    [[nodiscard]] double patches() const { return area_ / areas_[0]; }

private:
    static Estimate with(double value, double error) {
        return {.value = value, .standard_error = error, .method = "autocorrelation, Gaussian heights"};
    }

    std::array<double, 3> areas_;
    double area_;
};

/// Spatial parameters of a constant map.
SpatialParameters no_spatial_parameters(const topography::HeightMap& map) {
    SpatialParameters none;
    none.Sal = none.Str = none.Std = none.longest = undefined;
    none.correlation_areas.fill(undefined);
    none.alerts.push_back({"CONSTANT", topography::label(map.metadata),
                           "all heights are equal, so that there is no autocorrelation",
                           "check that the right channel was read and that the instrument was in contact"});
    return none;
}

void add_heights(ParameterRows& rows, const HeightParameters& heights, const HeightErrors& errors,
                 std::vector<Alert> alerts) {
    rows.add("Sq", errors.of_scale(heights.Sq), alerts);
    rows.add("Ssk", errors.of_skewness(heights.Ssk), alerts);
    rows.add("Sku", errors.of_kurtosis(heights.Sku), alerts);
    rows.add("Sp", {heights.Sp});
    rows.add("Sv", {heights.Sv});
    rows.add("Sz", {heights.Sz});
    rows.add("Sa", errors.of_scale(heights.Sa), std::move(alerts));
}

void add_features(ParameterRows& rows, const FeatureParameters& features) {
    rows.add("Spd", {features.Spd});
    rows.add("Svd", {features.Svd});
    rows.add("Spc", {features.Spc});
    rows.add("Svc", {features.Svc});
    rows.add("S5p", {features.S5p});
    rows.add("S5v", {features.S5v});
    rows.add("S10z", {features.S10z});
}

/// The warnings that begin with a symbol, and those on all three.
std::vector<Alert> alerts_of(const SpatialParameters& spatial, std::string_view prefix) {
    std::vector<Alert> some;
    for (const auto& alert : spatial.alerts)
        if (alert.code.starts_with(prefix) || alert.code == "CONSTANT") some.push_back(alert);
    return some;
}

}  // namespace

std::vector<TextureParameter> areal_parameters(const MeasurementView& measurement, const ArealOptions& options,
                                               parallel::Threads threads) {
    if (!measurement.as<topography::HeightMap>())
        throw InvalidArgument(topography::label(measurement.metadata()) +
                              ": parameters of ISO 25178-2 need a map, and this is a line; use those of ISO 21920-2");
    const auto own = filtered(measurement, options.filters, ProfileKind::roughness, threads);
    const MeasurementView view = own ? MeasurementView(*own) : measurement;
    const auto& map = *view.as<topography::HeightMap>();
    const auto heights = height_parameters(view, threads);
    const auto& only = options.only;
    const auto hybrid =
        is_requested(only, {"Sdq", "Sdr", "Sdq_c", "Sdr_c"}) ? hybrid_parameters(map, threads) : HybridParameters{};
    const bool correlated = is_requested(only, {"Sq", "Ssk", "Sku", "Sa", "Sal", "Str", "Std"});
    const auto spatial = !correlated        ? SpatialParameters{}
                         : heights.Sq > 0.0 ? spatial_parameters(map, {.threshold = options.threshold}, threads)
                                            : no_spatial_parameters(map);
    auto ratios = options.ratios;
    ratios.inverse = options.material_ratio;
    ratios.height = heights.mean + options.material_height;
    const bool with_curve = is_requested(only, {"Smr(c)", "Smc(p)", "Sdc", "Sxp", "Sk", "Spk", "Svk", "Smrk1", "Smrk2",
                                                "Spkx", "Svkx", "Sak1", "Sak2", "Vmp", "Vmc", "Vvc", "Vvv"});
    const auto functional =
        with_curve ? functional_parameters(view, ratios, options.between, threads) : FunctionalParameters{};

    const double pixel = map.pixel_size()[0] * map.pixel_size()[1];
    const HeightErrors errors(spatial, pixel * static_cast<double>(heights.defined));
    std::vector<Alert> few;
    if (correlated && errors.patches() < min_patches)
        few.push_back({"FEW_PATCHES", topography::label(map.metadata),
                       fmt::format("the map contains {:.1f} independent patches", errors.patches()),
                       "measure a larger map, or remove long waves with an L-filter"});
    ParameterRows rows(Standard::iso25178, description(options.filters, ProfileKind::roughness),
                       bandwidth(measurement, options.filters, ProfileKind::roughness, threads),
                       undefined_alerts(measurement), heights.defined, only);
    add_heights(rows, heights, errors, few);
    rows.add("Sal", {spatial.Sal}, alerts_of(spatial, "SAL"));
    rows.add("Str", {spatial.Str}, alerts_of(spatial, "STR"));
    rows.add("Std", {spatial.Std}, alerts_of(spatial, "STD"));
    rows.add("Sdq", {hybrid.Sdq});
    rows.add("Sdr", {hybrid.Sdr});
    rows.add("Sdq_c", {hybrid.Sdq_central});
    rows.add("Sdr_c", {hybrid.Sdr_central});
    rows.add("Smr(c)", {functional.Smr});
    rows.add("Smc(p)", {functional.Smc - heights.mean});
    rows.add("Sdc", {functional.Sdc});
    rows.add("Sxp", {functional.Sxp});
    rows.add("Sk", {functional.Sk});
    rows.add("Spk", {functional.Spk});
    rows.add("Svk", {functional.Svk});
    rows.add("Smrk1", {functional.Smrk1});
    rows.add("Smrk2", {functional.Smrk2});
    rows.add("Spkx", {functional.Spkx});
    rows.add("Svkx", {functional.Svkx});
    rows.add("Sak1", {functional.Sak1});
    rows.add("Sak2", {functional.Sak2});
    rows.add("Vmp", {functional.Vmp});
    rows.add("Vmc", {functional.Vmc});
    rows.add("Vvc", {functional.Vvc});
    rows.add("Vvv", {functional.Vvv});
    if (is_requested(only, {"Spd", "Svd", "Spc", "Svc", "S5p", "S5v", "S10z"}))
        add_features(rows, feature_parameters(map, {}, threads));
    return rows.take();
}

}  // namespace setae::texture
