// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::several_contacts_test {
namespace {

using tests::rubber_on_diamond;
using tests::SyntheticLoop;

Array1D both(const Array1D& a, const Array1D& b) {
    Array1D all(a.size() + b.size());
    all << a, b;
    return all;
}

const Alert* alert_of(const LoopAnalysis& analysis, const std::string& code) {
    const auto found =
        std::find_if(analysis.alerts.begin(), analysis.alerts.end(), [&](const Alert& a) { return a.code == code; });
    return found == analysis.alerts.end() ? nullptr : &*found;
}

TEST(TwoContacts, AreBothAnalysed) {
    const SyntheticLoop weak{.samples = 400},
        strong{.retraction_work = 0.070, .largest_radius = 1.1e-4, .samples = 400};
    const Loop first = weak.make(), second = strong.make();
    const Loop loop{.force = both(first.force, second.force),
                    .displacement = both(first.displacement, second.displacement),
                    .contact_radius = both(first.contact_radius, second.contact_radius)};
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
    ASSERT_EQ(analysis.further_contacts.size(), 1u);
    ASSERT_TRUE(analysis.further_contacts[0]) << analysis.further_contacts[0].reason;
    const ContactAnalysis& other = *analysis.further_contacts[0];
    EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_NEAR(other.loading.primary().work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_NEAR(other.loading.primary().contact_modulus.value / 0.92e6, 1.0, 1e-8);
    EXPECT_NEAR(other.unloading->force_displacement->work_of_adhesion.value / 0.070, 1.0, 1e-4);
    EXPECT_NEAR(other.pull_off->work_of_adhesion.value / 0.070, 1.0, 1e-4);
    EXPECT_NEAR(other.context.largest_contact_radius / 1.1e-4, 1.0, 1e-6);
    // the trapezoid rule of 400 samples a branch
    EXPECT_NEAR(analysis.loop->energy / weak.loss(), 1.0, 1e-3);
    EXPECT_NEAR(other.loop->energy / strong.loss(), 1.0, 1e-3);
    EXPECT_NEAR(other.budget->loop.energy, other.loop->energy, 0.0);
    ASSERT_EQ(analysis.cycles.size(), 2u);
    EXPECT_NEAR(*analysis.cycles[1].energy, other.loop->energy, 0.0);
    EXPECT_NEAR(analysis.cycles[1].unloading->force_displacement->work_of_adhesion.value / 0.070, 1.0, 1e-4);
    const Alert* alert = alert_of(analysis, "TWO_CONTACTS");
    ASSERT_NE(alert, nullptr);
    EXPECT_NE(alert->message.find("2 contacts"), std::string::npos);
    EXPECT_NE(alert->message.find("samples 401 to"), std::string::npos);
    EXPECT_EQ(alert_of(analyse(first, rubber_on_diamond()), "TWO_CONTACTS"), nullptr);
}

}  // namespace
}  // namespace setae::loops::several_contacts_test
