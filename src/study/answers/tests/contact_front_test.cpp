// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/front_fields.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::answers::contact_front_test {
namespace {

constexpr double W = 0.05, modulus = 1e6, radius = 1e-4, shortest = 1e-6;

FrontRequest asked() {
    FrontRequest request;
    request.radius = "100 um";
    request.contact_modulus = "1 MPa";
    request.work_of_adhesion = "50 mJ/m2";
    request.to_displacement = "0.3 um";
    request.shortest_wavelength = "1 um";
    request.steps = 100;
    return request;
}

/// Waves of 1 to 4 µm that store a share of W where a body of that modulus conforms to them.
topography::HeightMap rough(double energy_share, std::uint64_t seed) {
    const double size = 64e-6;
    const auto density =
        spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / (4.0 * shortest), 0.8, 2.0 * pi / shortest});
    auto map = synthesis::random_surface(density, {256, 256, size, size}, {.key = {seed}});
    const auto intensity = crack_front::stress_intensity_on_parallels(map, {modulus, shortest});
    map.heights *= std::sqrt(energy_share * W / intensity.stored_energy);
    return map;
}

double value_of(const FrontAnswer& answer, const char* name) {
    return std::ranges::find(answer.quantities, name, &Quantity::quantity)->estimate.value;
}

output::Json json_of(const FrontAnswer& answer) {
    const std::vector<processing::StepRecord> none;
    return output::described(ContactOutput{&answer, &none});
}

// hardly any roughness: JKR's own loop, and works of adhesion as told
TEST(ContactFront, OfANearlySmoothSurfaceIsJkr) {
    auto request = asked();
    request.steps = 400;
    const auto answer = contact_front("map", {rough(1e-9, 1)}, request);
    const contact::jkr::Contact smooth{radius, modulus, W};
    EXPECT_NEAR(value_of(answer, "work_of_adhesion_approach") / W, 1.0, 1e-3);
    EXPECT_NEAR(value_of(answer, "work_of_adhesion_retraction") / W, 1.0, 1e-3);
    EXPECT_NEAR(value_of(answer, "pull_off_force") / (1.5 * pi * W * radius), 1.0, 1e-3);
    EXPECT_NEAR(value_of(answer, "energy_loss") / contact::jkr::ideal_loop_loss(smooth).total, 1.0, 2e-3);
    EXPECT_EQ(value_of(answer, "jumps"), 2.0);
    EXPECT_NEAR(value_of(answer, "energy_share"), 1e-9, 1e-11);
}

TEST(ContactFront, OfARoughSurfaceHasHysteresis) {
    const auto answer = contact_front("map", {rough(0.03, 1), rough(0.03, 2)}, asked());
    EXPECT_NEAR(value_of(answer, "energy_share"), 0.03, 1e-3);
    EXPECT_GT(value_of(answer, "work_of_adhesion_retraction"), 1.005 * W);
    EXPECT_LT(value_of(answer, "work_of_adhesion_approach"), 0.995 * W);
    const double k = value_of(answer, "pinning_coefficient");
    EXPECT_GT(k, 0.1);  // of a front that is short, docs/validation/crack-front.md
    EXPECT_LT(k, 1.5);
    EXPECT_GT(value_of(answer, "energy_loss"), value_of(answer, "smooth_sphere_loss"));
    EXPECT_GT(value_of(answer, "jumps"), 10.0);
    ASSERT_EQ(answer.runs.size(), 2U);
    const auto json = json_of(answer);
    EXPECT_GT(json["standard_errors"]["pinning_coefficient"].get<double>(), 0.0);
    EXPECT_EQ(json["runs"].size(), 2U);
}

TEST(ContactFront, IsTheSameForAnyNumberOfThreads) {
    auto request = asked();
    request.steps = 30;
    const std::vector<topography::Measurement> maps{rough(0.03, 1), rough(0.03, 2)};
    EXPECT_EQ(json_of(contact_front("map", maps, request, {1})).dump(),
              json_of(contact_front("map", maps, request, {2})).dump());
}

TEST(ContactFront, TurnsAtTheForceOnAStageAndUnderADeadLoad) {
    auto request = asked();
    request.to_displacement.clear();
    request.to_force = "5 uN";
    request.steps = 60;
    for (const bool dead : {false, true}) {
        request.dead_load = dead;
        request.stage_stiffness = dead ? "" : "100 N/m";
        const auto answer = contact_front("map", {rough(1e-4, 1)}, request);
        EXPECT_NEAR(answer.steps.at("force").maxCoeff(), 5e-6, 5e-8) << dead;
    }
}

void expect_refusal(const FrontRequest& request, const topography::Measurement& map, const char* words) {
    try {
        (void)contact_front("map.npy", {map}, request);
        ADD_FAILURE() << "expected: " << words;
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(ContactFront, RefusesWithAOneLineMessage) {
    const auto map = rough(0.03, 1);
    auto request = asked();
    request.to_force = "1 uN";
    expect_refusal(request, map, "one of `to_force` and `to_displacement`");
    request = asked();
    request.radius.clear();
    expect_refusal(request, map, "`radius = ");
    request = asked();
    request.model = "elastic";
    expect_refusal(request, map, "constant_toughness");
    request = asked();
    request.dead_load = true;
    request.stage_stiffness = "1 N/m";
    expect_refusal(request, map, "a dead load has no stage");
    request = asked();
    request.shortest_wavelength = "2 nm";
    expect_refusal(request, map, "`shortest_wavelength = ");
    auto ended = map;
    ended.periodic = false;
    ended.size = {20e-6, 20e-6};
    expect_refusal(asked(), ended, "the map has roughness for 9");
    auto holed = map;
    holed.heights(3, 4) = undefined;
    expect_refusal(asked(), holed, "fill_undefined");
    expect_refusal(asked(), topography::LineScan{.heights = Array1D::Zero(8), .size = 1e-6}, "no map");
}

TEST(ContactFront, WarnsWhereTheModelIsInvalid) {
    const auto alerts_of = [](double share) {
        auto request = asked();
        request.steps = 20;
        return contact_front("map", {rough(share, 1)}, request).alerts;
    };
    EXPECT_TRUE(alerts_of(0.03).empty());
    const auto beyond = alerts_of(0.4);
    ASSERT_FALSE(beyond.empty());
    EXPECT_EQ(beyond.front().code, "FRONT_THEORY");
    EXPECT_NE(beyond.front().message.find("full contact"), std::string::npos);
}

}  // namespace
}  // namespace setae::answers::contact_front_test
