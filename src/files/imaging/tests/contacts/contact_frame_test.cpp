// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contact_frame.hpp"

#include <gtest/gtest.h>

#include "rendered_contact.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging::tests::contact_frame_test {
namespace {

/// Contrast 60 over noise 12: SNR 5 of a pixel, off the grid by another fraction for each seed.
RenderedContact at_snr_5(unsigned seed, double radius = 24) {
    const double s = seed;
    return {.width = 100,
            .height = 90,
            .centre_x = 49 + 0.37 * std::sin(1.7 * s),
            .centre_y = 44 + 0.49 * std::cos(2.3 * s),
            .semi_major = radius + 0.021 * s,
            .slope_x = 0.15,
            .slope_y = -0.1,
            .noise = 12,
            .seed = seed};
}

struct Errors {
    double mean = 0, deviation = 0, largest = 0, pull = 0;  ///< pull: root mean square of error over standard error
    int measured = 0;
};

template <class Make>
Errors errors_of(Make make, unsigned seeds, const ContactFrameOptions& options = {}) {
    Errors errors;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const RenderedContact contact = make(seed);
        const auto found = measure_contact_frame(contact.make(), options);
        if (found.state != FrameState::measured) continue;
        const double minor = contact.semi_minor > 0 ? contact.semi_minor : contact.semi_major;
        const double error = found.radius - std::sqrt(contact.semi_major * minor);
        ++errors.measured;
        errors.mean += error;
        errors.deviation += error * error;
        errors.largest = std::max(errors.largest, std::abs(error));
        errors.pull += std::pow(error / found.radius_standard_error, 2);
    }
    errors.mean /= errors.measured;
    errors.deviation = std::sqrt(errors.deviation / errors.measured);
    errors.pull = std::sqrt(errors.pull / errors.measured);
    return errors;
}

// The share of a pixel in an edge of blur w determines its place to σ/C sqrt(2 sqrt(π) w) = 0.2 sqrt(3.54 · 0.85) =
// 0.35 px, so a radius of 24 px with its 151 px of perimeter is determined to 0.028 px at best; 0.1 px is then 3
// standard deviations of the actual error.
TEST(ContactRadius, IsWithinATenthOfAPixelAtSnrFive) {
    for (const double radius : {17.0, 24.0, 33.0}) {
        const auto errors = errors_of([&](unsigned seed) { return at_snr_5(seed, radius); }, 12);
        EXPECT_EQ(errors.measured, 12) << radius;
        EXPECT_LT(errors.largest, 0.1) << radius;
    }
}

TEST(ContactRadius, OfSmallDiscsIsWithinATenthOfAPixelOnAverage) {
    for (const double radius : {7.0, 11.0}) {
        const auto errors = errors_of([&](unsigned seed) { return at_snr_5(seed, radius); }, 30);
        EXPECT_EQ(errors.measured, 30) << radius;
        EXPECT_LT(errors.deviation, 0.08) << radius;
        EXPECT_LT(std::abs(errors.mean), 3 * 0.06 / std::sqrt(30)) << radius;  // 0.06 px is the scatter of one
    }
}

void expect_stated_errors(double noise_blur) {
    const auto errors = errors_of(
        [&](unsigned seed) {
            auto contact = at_snr_5(seed, 24);
            contact.width = contact.height = 76;
            contact.centre_x -= 11;
            contact.centre_y -= 6;
            contact.slope_x = contact.slope_y = 0;
            contact.noise_blur = noise_blur;
            return contact;
        },
        100);
    EXPECT_EQ(errors.measured, 100);
    EXPECT_GT(errors.pull, 0.8);  // the root mean square of 100 pulls has an error of 0.07
    EXPECT_LT(errors.pull, 1.25);
}

TEST(ContactRadius, HasTheStatedStandardError) { expect_stated_errors(0.0); }

TEST(ContactRadius, HasTheStatedStandardErrorForBlurredNoise) { expect_stated_errors(0.7); }

TEST(ContactRadius, IsExactToAHundredthOfAPixelWithoutNoise) {
    for (const double blur : {0.0, 0.8, 2.0})
        for (const double radius : {10.0, 27.3}) {
            const auto errors = errors_of(
                [&](unsigned seed) {
                    auto contact = at_snr_5(seed, radius);
                    contact.noise = 0;
                    contact.blur = blur;
                    return contact;
                },
                3);
            EXPECT_EQ(errors.measured, 3);
            EXPECT_LT(errors.largest, 0.012)
                << blur << ' ' << radius;  // half a grey level of 60 over the gradient, averaged
        }
}

TEST(ContactRadius, IsTheSameForBrightContacts) {
    auto contact = at_snr_5(3);
    contact.inside = 140;
    contact.contrast = -60;
    const auto found = measure_contact_frame(contact.make());
    EXPECT_EQ(found.polarity, Polarity::bright);
    EXPECT_NEAR(found.radius, contact.semi_major, 0.1);
    EXPECT_EQ(measure_contact_frame(contact.make(), {.polarity = Polarity::bright}).radius, found.radius);
    EXPECT_NE(measure_contact_frame(contact.make(), {.polarity = Polarity::dark}).state, FrameState::measured);
}

TEST(ContactRadius, IsIndependentOfAStrongIlluminationGradient) {
    auto contact = at_snr_5(5);
    contact.slope_x = 0.7;
    contact.slope_y = 0.5;
    contact.noise = 6;
    EXPECT_NEAR(measure_contact_frame(contact.make()).radius, contact.semi_major, 0.05);
}

TEST(ContactEllipse, RecoversAxesAngleAndRoundness) {
    double pulls = 0;
    constexpr int seeds = 12;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        auto contact = at_snr_5(seed);
        contact.semi_major = 33;
        contact.semi_minor = 27;
        contact.angle = 0.25 * seed - 1.5;
        const auto found = measure_contact_frame(contact.make());
        EXPECT_NEAR(found.ellipse.semi_major, 33, 0.2) << seed;
        EXPECT_NEAR(found.ellipse.semi_minor, 27, 0.2) << seed;
        EXPECT_NEAR(std::remainder(found.ellipse.angle - contact.angle, 3.14159265358979), 0, 0.03) << seed;
        EXPECT_NEAR(found.roundness, 27.0 / 33, 4 * found.roundness_standard_error) << seed;
        pulls += std::pow((found.ellipse.semi_major - 33) / found.ellipse.semi_major_standard_error, 2) +
                 std::pow((found.ellipse.semi_minor - 27) / found.ellipse.semi_minor_standard_error, 2);
    }
    EXPECT_GT(std::sqrt(pulls / (2 * seeds)), 0.7);  // of 24 pulls: 1 ± 0.14
    EXPECT_LT(std::sqrt(pulls / (2 * seeds)), 1.4);
}

TEST(ContactRadius, OfAPartlyVisibleContactIsThatOfTheCircle) {
    auto contact = at_snr_5(2, 30);
    contact.centre_x = 10;
    const auto found = measure_contact_frame(contact.make());
    ASSERT_EQ(found.state, FrameState::measured) << found.reason;
    EXPECT_TRUE(found.partial);
    EXPECT_NEAR(found.radius, contact.semi_major, 4 * found.radius_standard_error);
    EXPECT_LT(found.radius_standard_error, 0.2);
    EXPECT_LT(found.visible_share, 0.8);
    EXPECT_NE(found.reason.find("beyond the frame"), std::string::npos);
    EXPECT_FALSE(measure_contact_frame(at_snr_5(2).make()).partial);
}

/// Brightness of two-beam interference over the gap of a JKR contact, d pixels outside its edge of `radius` pixels.
///
///   gap = (a² sqrt(r²/a² − 1) + (r² − 2a²) acos(a/r))/(πR) + (2/π) δ1 acos(a/r),  δ1 = sqrt(2π a W/E*)
///   (Johnson, Contact Mechanics, 1985, (3.42a) and (3.38) for the two parts), I = ½ (1 − V cos(4π gap/λ))
double interference(double d, double radius, double pixel_size, double pull) {
    constexpr double sphere_radius = 1.25e-3, wavelength = 0.55e-6, coherence = 5e-6, pi = 3.14159265358979;
    const double a = radius * pixel_size, r = a + d * pixel_size;
    const double gap = (a * std::sqrt(r * r - a * a) + (r * r - 2 * a * a) * std::acos(a / r)) / (pi * sphere_radius) +
                       2 / pi * pull * std::acos(a / r);
    return 0.5 * (1 - 0.9 * std::exp(-gap / coherence) * std::cos(4 * pi * gap / wavelength));
}

TEST(ContactRadius, IsWithinHalfAPixelForFringesOfAJkrContact) {
    // 50 mJ/m² on 1 MPa at 50 µm: δ1 = 4 µm; a stiffer, less sticky contact: 0.5 µm
    for (const auto& [pixel_size, pull] : {std::pair{3e-6, 4e-6}, std::pair{1e-6, 1.5e-6}, std::pair{1e-6, 0.5e-6}})
        for (unsigned seed = 1; seed <= 3; ++seed) {
            auto contact = at_snr_5(seed, 26);
            contact.noise = 6;
            contact.outside = [&, size = pixel_size, d1 = pull](double d) {
                return interference(d, contact.semi_major, size, d1);
            };
            const auto found = measure_contact_frame(contact.make(), {.fringes = true});
            ASSERT_EQ(found.state, FrameState::measured) << found.reason;
            EXPECT_NEAR(found.radius, contact.semi_major, 0.5) << pull << ' ' << seed;
        }
}

TEST(ContactFrame, WithoutContactHasRadiusZero) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        auto contact = at_snr_5(seed);
        contact.contrast = 0;
        contact.inside = 120;
        contact.slope_x = 0.3;
        const auto found = measure_contact_frame(contact.make());
        EXPECT_EQ(found.state, FrameState::no_contact) << found.reason;
        EXPECT_EQ(found.radius, 0.0);
        EXPECT_TRUE(std::isnan(found.radius_standard_error));
    }
}

TEST(ContactFrame, WithOtherShapesThanADiscIsNotMeasured) {
    auto contact = at_snr_5(1);
    contact.contrast = 0;
    auto pixels = contact.make();
    pixels.rightCols(40) += 60;                             // a straight edge
    for (long i = 0; i < 90; ++i) pixels(i, i / 2) += 120;  // a scratch
    const auto found = measure_contact_frame(pixels);
    EXPECT_EQ(found.state, FrameState::not_found);
    EXPECT_TRUE(std::isnan(found.radius));
    EXPECT_FALSE(found.reason.empty());
}

TEST(ContactFrame, ToleratesDustAndGlareOnTheEdge) {
    auto contact = at_snr_5(6, 28);
    auto pixels = contact.make();
    const long x = std::lround(contact.centre_x), y = std::lround(contact.centre_y);
    pixels.block(y - 4, x + 24, 9, 9) = 255;  // glare
    pixels.block(y + 22, x - 6, 10, 6) = 20;  // dust
    const auto found = measure_contact_frame(pixels);
    ASSERT_EQ(found.state, FrameState::measured) << found.reason;
    EXPECT_NEAR(found.radius, contact.semi_major, 0.15);
    EXPECT_LT(found.agreeing_rays, 0.97);
    EXPECT_GT(found.confidence, 0.6);
}

TEST(ContactFrame, ReportsContrastAndWidthOfTheEdge) {
    const auto found = measure_contact_frame(at_snr_5(7, 33).make());
    EXPECT_NEAR(found.contrast_to_noise, 5.0, 0.4);
    EXPECT_NEAR(found.edge_width, std::hypot(0.8, std::sqrt(1.0 / 12)), 0.15);  // the blur and the area of a pixel
}

TEST(ContactFrame, RefusesOptionsOutsideTheirDomain) {
    const auto pixels = at_snr_5(1).make();
    EXPECT_THROW((void)measure_contact_frame(pixels, {.smallest_radius = 1}), InvalidArgument);
    EXPECT_THROW((void)measure_contact_frame(pixels, {.min_confidence = 1.5}), InvalidArgument);
    EXPECT_THROW((void)measure_contact_frame(FramePixels::Zero(10, 40)), InvalidArgument);
}

}  // namespace
}  // namespace setae::imaging::tests::contact_frame_test
