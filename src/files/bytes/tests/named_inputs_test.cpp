// SPDX-License-Identifier: GPL-3.0-or-later
// Named inputs that several keys of a TOML file refer to.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "setae/bytes/toml_reader.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes::named_inputs_test {
namespace {

/// A file's text with the key to be read, as an uncertain length above 0.
Estimate radius_of(const std::string& text) {
    const auto table = toml::parse(text);
    TomlReader reader(table, "study.toml", "");
    reader.name_inputs("inputs");
    std::optional<Estimate> radius;
    reader.table("sphere", [&](TomlReader inner) {
        if (inner.contains("again")) (void)inner.uncertain("again", positive(dimension::length));
        radius = inner.uncertain("radius", positive(dimension::length));
    });
    reader.finish();
    reader.require_inputs_used();
    return *radius;
}

std::string message_of(const std::string& text) {
    try {
        (void)radius_of(text);
    } catch (const FormatError& error) {
        return error.what();
    }
    return "";
}

TEST(NamedInputs, AreReferencedByName) {
    for (const char* text :
         {"inputs.lens = '1.25 ± 0.01 mm'\nsphere.radius = 'lens'", "sphere.radius = 'lens = 1.25 ± 0.01 mm'",
          "sphere.again = 'lens = 1.25 ± 0.01 mm'\nsphere.radius = 'lens'",
          "sphere.again = 'lens = 1.25 ± 0.01 mm'\nsphere.radius = 'lens = 1250 ± 10 um'"}) {
        SCOPED_TRACE(text);
        const auto radius = radius_of(text);
        EXPECT_NEAR(radius.value, 1.25e-3, 1e-18);
        EXPECT_NEAR(radius.standard_error, 1e-5, 1e-18);
        EXPECT_EQ(radius.input, "lens");
    }
}

TEST(NamedInputs, WithoutANameAreNamedByTheirKey) {
    EXPECT_EQ(radius_of("sphere.radius = '1.25 ± 0.01 mm'").input, "sphere.radius");
    EXPECT_EQ(radius_of("sphere.radius = '1.25 mm'").input, "") << "what is exact is no input";
}

TEST(NamedInputs, AreRefusedWithAMessageOfOneLine) {
    EXPECT_EQ(
        message_of("sphere.again = 'lens = 1.25 ± 0.01 mm'\nsphere.radius = 'lens = 1.3 mm'"),
        "study.toml:2: sphere.radius: input 'lens' is '1.3 mm' here and '1.25 ± 0.01 mm' in line 1; expected one value per "
        "name");
    EXPECT_EQ(message_of("sphere.radius = '1 mm'\n[inputs]\nlens = '1.25 mm'"),
              "study.toml:3: no key uses the input 'lens'; write its name in place of its value, such as "
              "surface_energy = \"lens\"");
    EXPECT_EQ(message_of("inputs.lens_3 = '1.25 mm'\nsphere.again = 'lens_3'\nsphere.radius = 'lens3'"),
              "study.toml:3: sphere.radius: 'lens3' does not begin with a number; write number and unit, such as 37 "
              "mJ/m2; did you mean the input 'lens_3'?");
    EXPECT_EQ(message_of("sphere.radius = ' = 1.25 mm'"),
              "study.toml:1: sphere.radius: '= 1.25 mm', expected a name before '='");
    EXPECT_EQ(
        message_of("sphere.radius = '1.25 ± 2 mm'"),
        "study.toml:1: sphere.radius: '1.25 ± 2 mm', the uncertainty is larger than the value, which must be above "
        "0");
    EXPECT_EQ(message_of("sphere.radius = '1.25 ± -1 mm'"),
              "study.toml:1: sphere.radius: '1.25 ± -1 mm', expected an uncertainty >= 0");
    EXPECT_EQ(
        message_of("sphere.radius = '1.25 ± 0.01'"),
        "study.toml:1: sphere.radius: '1.25 ± 0.01' has no unit; expected a length with its unit, such as \"5 um\"");
    EXPECT_EQ(message_of("inputs.lens = true\nsphere.radius = '1 mm'"),
              "study.toml:1: inputs.lens: expected a value with its ± and unit in quotes");
}

}  // namespace
}  // namespace setae::bytes::named_inputs_test
