// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "setae/core/errors.hpp"
#include "setae/core/special_functions.hpp"
#include "setae/core/summation.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"

namespace setae::core_test {
namespace {

TEST(ParseQuantity, ReadsUsualSpellings) {
    EXPECT_DOUBLE_EQ(parse_quantity("37 mJ/m2", dimension::surface_energy), 0.037);
    EXPECT_DOUBLE_EQ(parse_quantity("37mJ/m²", dimension::surface_energy), 0.037);
    EXPECT_DOUBLE_EQ(parse_quantity("37 mN/m", dimension::surface_energy), 0.037);
    EXPECT_DOUBLE_EQ(parse_quantity("1.1MPa", dimension::pressure), 1.1e6);
    EXPECT_DOUBLE_EQ(parse_quantity(" 8nm ", dimension::length), 8e-9);
    EXPECT_DOUBLE_EQ(parse_quantity("8 A", dimension::length), 8e-10);
    EXPECT_DOUBLE_EQ(parse_quantity("3 nm^-1", dimension::wavevector), 3e9);
    EXPECT_DOUBLE_EQ(parse_quantity("3 nm⁻¹", dimension::wavevector), 3e9);
    EXPECT_DOUBLE_EQ(parse_quantity("2 1/um", dimension::wavevector), 2e6);
    EXPECT_DOUBLE_EQ(parse_quantity("62700 g/mol", dimension::molar_mass), 62.7);
    EXPECT_DOUBLE_EQ(parse_quantity("0.5", dimension::none), 0.5);
}

TEST(ParseQuantity, ReadsEverySpellingOfMicro) {
    for (const std::string text : {"5 um", "5 \u00b5m", "5 \u03bcm", "5 ~m", "5 micron", "5 microns"})
        EXPECT_DOUBLE_EQ(parse_quantity(text, dimension::length), 5e-6) << text;
}

TEST(ParseQuantity, RefusesAMissingUnit) {
    try {
        (void)parse_quantity("37", dimension::surface_energy);
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_STREQ(error.what(), "'37' has no unit; expected an energy per area with its unit, such as \"40 mJ/m2\"");
    }
}

TEST(ParseQuantity, RefusesAnotherDimension) {
    EXPECT_THROW((void)parse_quantity("37 nm", dimension::surface_energy), InvalidArgument);
    EXPECT_THROW((void)parse_quantity("37 furlong", dimension::length), InvalidArgument);
    EXPECT_THROW((void)parse_quantity("nm", dimension::length), InvalidArgument);
}

TEST(ParseUncertainQuantity, ReadsValueAndStandardError) {
    for (const std::string text : {"37.0 ± 3.7 mJ/m2", "37.0 +- 3.7 mJ/m2", "37.0 mJ/m2 ± 3.7 mJ/m2"}) {
        const auto w = parse_uncertain_quantity(text, dimension::surface_energy);
        EXPECT_DOUBLE_EQ(w.value, 0.037) << text;
        EXPECT_DOUBLE_EQ(w.standard_error, 0.0037) << text;
    }
    EXPECT_EQ(parse_uncertain_quantity("1 MPa", dimension::pressure).standard_error, 0.0);
}

TEST(ParseQuantity, RefusesValuesOutsideItsDomain) {
    const auto refusal = [](std::string_view text, const Expected& expected) {
        try {
            (void)parse_uncertain_quantity(text, expected);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal("nan MPa", dimension::pressure), "'nan MPa', expected a finite value");
    EXPECT_EQ(refusal("inf MPa", dimension::pressure), "'inf MPa', expected a finite value");
    EXPECT_EQ(refusal("1e308 km", dimension::length), "'1e308 km', expected a finite value");
    EXPECT_EQ(refusal("-1 nm", dimension::length), "");
    EXPECT_EQ(refusal("-1 nm", positive(dimension::length)), "'-1 nm', expected above 0");
    EXPECT_EQ(refusal("0 nm", positive(dimension::length)), "'0 nm', expected above 0");
    EXPECT_EQ(refusal("0 nm", non_negative(dimension::length)), "");
    EXPECT_EQ(refusal("-1 ± 1 nm", non_negative(dimension::length)), "'-1 ± 1 nm', expected 0 or above");
    EXPECT_EQ(refusal("0.5", {dimension::none, domain::poisson_ratio}), "");
    EXPECT_EQ(refusal("0.51", {dimension::none, domain::poisson_ratio}), "'0.51', expected from 0 to 0.5");
    for (const auto* error : {"1 ± -1 nm", "1 ± nan nm", "1 ± inf nm"})
        EXPECT_NE(refusal(error, dimension::length).find("an uncertainty >= 0"), std::string::npos) << error;
}

TEST(ParseUnit, ReadsWeightForcesAndInches) {
    // CGPM 1901: 9.80665 m/s²; international yard and pound 1959: 25.4 mm, 0.45359237 kg
    for (const auto& [text, newton] :
         {std::pair("gf", 9.80665e-3), std::pair("mgf", 9.80665e-6), std::pair("kgf", 9.80665),
          std::pair("lbf", 0.45359237 * 9.80665), std::pair("ozf", 0.45359237 * 9.80665 / 16.0), std::pair("dyn", 1e-5),
          std::pair("Millinewton", 1e-3)}) {
        EXPECT_NEAR(parse_unit(text).factor / newton, 1.0, 1e-15) << text;
        EXPECT_EQ(parse_unit(text).dimension, dimension::force) << text;
    }
    for (const auto& [text, metre] :
         {std::pair("in", 0.0254), std::pair("inch", 0.0254), std::pair("inches", 0.0254), std::pair("mil", 25.4e-6),
          std::pair("mils", 25.4e-6), std::pair("thou", 25.4e-6), std::pair("µin", 25.4e-9), std::pair("uin", 25.4e-9),
          std::pair("microinches", 25.4e-9), std::pair("Micrometer", 1e-6), std::pair("mikrometer", 1e-6),
          std::pair("Millimetres", 1e-3), std::pair("microns", 1e-6)}) {
        EXPECT_NEAR(parse_unit(text).factor / metre, 1.0, 1e-15) << text;
        EXPECT_EQ(parse_unit(text).dimension, dimension::length) << text;
    }
    EXPECT_EQ(parse_unit("sec").factor, 1.0);
    EXPECT_EQ(parse_unit("min").factor, 60.0);
    EXPECT_EQ(parse_unit("1/in").dimension, dimension::wavevector);
    EXPECT_EQ(parse_unit("lb").dimension, parse_unit("kg").dimension);
    for (const char* none : {"kin", "millimil", "force", "load", "x", "pinch"})
        EXPECT_THROW((void)parse_unit(none), InvalidArgument) << none;
}

TEST(SiUnit, FormatsDerivedUnits) {
    EXPECT_EQ(si_unit(dimension::surface_energy), "J/m2");
    EXPECT_EQ(si_unit(dimension::power_spectrum_1d), "m3");
    EXPECT_EQ(si_unit(dimension::wavevector), "1/m");
    EXPECT_EQ(si_unit(dimension::none), "1");
    for (const auto& d : {dimension::force, dimension::molar_mass, dimension::power_spectrum_2d, dimension::area})
        EXPECT_EQ(parse_unit(si_unit(d)).dimension, d);
}

TEST(FormatValue, ChoosesThePrefix) {
    EXPECT_EQ(format_value(0.037, "J/m2"), "37.00 mJ/m²");
    EXPECT_EQ(format_value(4.6e-9, "m"), "4.600 nm");
    EXPECT_EQ(format_value(-2.1e-6, "N"), "-2.100 µN");
    EXPECT_EQ(format_value(1.3e-9, "1"), "1.300×10⁻⁹");
    EXPECT_EQ(format_value(std::nan(""), "m"), "–");
}

TEST(ScaledComplementaryErrorFunction, AgreesWithTabulatedValues) {
    // 20-digit values from mpmath 1.3, erfc(x)·exp(x²)
    EXPECT_NEAR(scaled_complementary_error_function(0.0), 1.0, 1e-15);
    EXPECT_NEAR(scaled_complementary_error_function(0.5) / 0.61569034419292587487, 1.0, 1e-14);
    EXPECT_NEAR(scaled_complementary_error_function(1.0) / 0.42758357615580700441, 1.0, 1e-14);
    EXPECT_NEAR(scaled_complementary_error_function(2.0) / 0.25539567631050574387, 1.0, 1e-14);
    EXPECT_NEAR(scaled_complementary_error_function(10.0) / 0.056140992743822585858, 1.0, 1e-14);
    EXPECT_NEAR(scaled_complementary_error_function(1e6) * 1e6 * std::sqrt(3.14159265358979323846), 1.0, 1e-12);
}

TEST(PairwiseSum, KeepsPrecisionForManySmallTerms) {
    const Array1D tenth = Array1D::Constant(1'000'000, 0.1);
    EXPECT_NEAR(pairwise_sum(tenth), 1e5, 1e-9);
}

TEST(NearestMatch, FindsTheMisspeltKeyOnly) {
    const std::vector<std::string> keys{"surfaces", "elastomers", "experiments"};
    EXPECT_EQ(nearest_match("surface", keys), "surfaces");
    EXPECT_EQ(nearest_match("elastomer", keys), "elastomers");
    EXPECT_EQ(nearest_match("xyz", keys), "");
}

TEST(FormatErrorMessage, BeginsWithFileAndPosition) {
    EXPECT_STREQ(FormatError("a.txt", {.line = 12}, "got 'x', expected a number").what(),
                 "a.txt:12: got 'x', expected a number");
    EXPECT_STREQ(FormatError("a.di", {.offset = 4096}, "truncated").what(), "a.di: at byte 4096: truncated");
}

TEST(Utf8Length, DistinguishesCharactersFromInvalidBytes) {
    EXPECT_EQ(utf8_length("a"), 1);
    EXPECT_EQ(utf8_length("\u00b5m"), 2);
    EXPECT_EQ(utf8_length("\u2212"), 3);
    EXPECT_EQ(utf8_length("\U0001F98E"), 4);
    for (const char* broken :
         {"\x80", "\xc0\x80", "\xc3", "\xe2\x88", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe0\x80\x80"})
        EXPECT_EQ(utf8_length(broken), 0);
}

TEST(Text, IsPrintedWithoutControlCharacters) {
    EXPECT_EQ(valid_utf8("a\xff\xc3\xa4\xe2\x82"), "a\uFFFDä\uFFFD\uFFFD");
    EXPECT_EQ(printable("red \x1b[31m\n\tb\r\x07\xff"), "red  [31m\n\tb  \uFFFD");
    EXPECT_EQ(one_line("a\nb\tc"), "a b c");
    EXPECT_EQ(one_line("\u202egnp.exe \u0085\u2028 µ 名"), " gnp.exe    µ 名");
    EXPECT_EQ(one_line(std::string_view("a\0b", 3)), "a b");
    EXPECT_EQ(one_line(""), "");
}

TEST(Reason, NamesFileAndCause) {
    EXPECT_EQ(reason_of(FileError("a.csv: no such file")), "a.csv: no such file");
    EXPECT_EQ(reason_of(FileError("a.csv: no such file"), "a.csv"), "a.csv: no such file");
    EXPECT_EQ(reason_of(UndefinedDataError("no heights"), "a.csv"), "a.csv: no heights");
    EXPECT_NE(reason_of(std::bad_alloc(), "a.csv").find("a.csv: memory does not suffice"), std::string::npos);
    EXPECT_NE(reason_of(std::out_of_range("vector")).find("internal error: vector"), std::string::npos);
    EXPECT_NE(reason_of(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)))
                  .find("the operating system refuses"),
              std::string::npos);
}

TEST(ShellWord, QuotesSpecialCharacters) {
    EXPECT_EQ(shell_word("study.toml"), "study.toml");
    EXPECT_EQ(shell_word("my study.toml"), "'my study.toml'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word("$HOME"), "'$HOME'");
    EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace setae::core_test
