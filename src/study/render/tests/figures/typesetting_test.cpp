// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/figures/typesetting.hpp"

#include <gtest/gtest.h>

namespace setae::figures::typesetting_test {
namespace {

/// Spans in brackets: italic ones with a slash, lowered with _, raised with ^.
std::string shown(std::string_view quantity) {
    std::string text;
    for (const auto& span : spans_of(quantity))
        text += std::string("[") + (span.italic ? "/" : "") +
                (span.place == Span::Place::lowered  ? "_"
                 : span.place == Span::Place::raised ? "^"
                                                     : "") +
                span.text + "]";
    return text;
}

std::string shown_unit(std::string_view unit) {
    std::string text;
    for (const auto& factor : factors_of(unit)) text += "[" + factor.symbol + "|" + factor.exponent + "]";
    return text;
}

TEST(SpansOf, SeparatesItalicSubscriptAndSuperscript) {
    EXPECT_EQ(shown("rms slope *h*'_{rms}"), "[rms slope ][/h]['][_rms]");
    EXPECT_EQ(shown("*C*_1D"), "[/C][_1D]");
    EXPECT_EQ(shown("*q^2*"), "[/q][/^2]");
    EXPECT_EQ(shown("plain"), "[plain]");
    EXPECT_EQ(shown(""), "");
}

TEST(SpansOf, BackslashEscapesTheNextLetter) {
    EXPECT_EQ(shown("a\\_b"), "[a_b]");
    EXPECT_EQ(shown("a\\"), "[a\\]");
}

TEST(PlainText, HasNoMarkup) {
    EXPECT_EQ(plain_text("rms slope *h*'_{rms}"), "rms slope h'_rms");
    EXPECT_EQ(plain_text("contact modulus *E*\\*"), "contact modulus E*");
    EXPECT_EQ(plain_text("*q^2*"), "q^2");
}

TEST(SymbolOf, RemovesTheWordsBeforeTheSymbol) {
    EXPECT_EQ(symbol_of("work of adhesion *W*_app"), "*W*_app");
    EXPECT_EQ(symbol_of("residual Δ*W*"), "Δ*W*");
    EXPECT_EQ(symbol_of("*P*/*E*"), "*P*/*E*");
    EXPECT_EQ(symbol_of("no symbol at all"), "no symbol at all");
}

TEST(NumberText, WritesPowersOfTenAsInPapers) {
    EXPECT_EQ(number_text(0.5), "0.5");
    EXPECT_EQ(number_text(-2e6), "-2·10⁶");
    EXPECT_EQ(number_text(1.26e-7, 2), "1.3·10⁻⁷");
}

TEST(SpansOf, AnUnclosedGroupEndsWithTheText) { EXPECT_EQ(shown("W_{app"), "[W][_app]"); }

TEST(FactorsOf, FactorsBelowTheSlashHaveNegativePowers) {
    EXPECT_EQ(shown_unit("mJ/m2"), "[mJ|][m|-2]");
    EXPECT_EQ(shown_unit("1/m"), "[m|-1]");
    EXPECT_EQ(shown_unit("N/m^1.5"), "[N|][m|-1.5]");
    EXPECT_EQ(shown_unit("m-1"), "[m|-1]");
    EXPECT_EQ(shown_unit("um"), "[µm|]");
    EXPECT_EQ(shown_unit("1"), "");
}

}  // namespace
}  // namespace setae::figures::typesetting_test
