// SPDX-License-Identifier: GPL-3.0-or-later
#include "expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::tables {
namespace {

[[noreturn]] void refuse(const mu::ParserError& error) { throw InvalidArgument(error.GetMsg()); }

/// @throws InvalidArgument for text accepted by muParser that is no expression over columns: an assignment to a column,
/// a list of expressions of which the last one counts, and text after a zero byte.
void require_one_value(const std::string& text) {
    if (text.find('\0') != std::string::npos) throw InvalidArgument("the expression contains a zero byte");
    constexpr std::string_view before_equals = "=<>!";
    for (auto at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
        const bool compares = (at > 0 && before_equals.find(text[at - 1]) != std::string_view::npos) ||
                              (at + 1 < text.size() && text[at + 1] == '=');
        if (!compares)
            throw InvalidArgument(fmt::format(
                "'{}' assigns a value to a column, expected an expression without '='; '==' compares", text));
    }
}

/// An expression bound to variables that can be set between evaluations.
class Expression {
public:
    Expression(const std::string& text, const std::vector<std::string>& names) : values_(names.size()) {
        require_one_value(text);
        try {
            for (std::size_t i = 0; i < names.size(); ++i) parser_.DefineVar(names[i], &values_[i]);
            parser_.SetExpr(text);
            (void)parser_.Eval();
            if (parser_.GetNumResults() != 1)
                throw InvalidArgument(
                    fmt::format("'{}' is {} expressions, expected one", text, parser_.GetNumResults()));
        } catch (const mu::ParserError& error) {
            refuse(error);
        }
    }

    void set(std::size_t variable, double value) { values_[variable] = value; }
    [[nodiscard]] double value(std::size_t variable) const { return values_[variable]; }

    [[nodiscard]] double operator()() const {
        try {
            return parser_.Eval();
        } catch (const mu::ParserError& error) {
            refuse(error);
        }
    }

private:
    std::vector<double> values_;
    mu::Parser parser_;
};

std::vector<std::string> names_of(const ExpressionInputs& inputs) {
    std::vector<std::string> names;
    for (const auto& constant : inputs.constants) names.push_back(constant.name);
    for (const auto& column : inputs.columns) names.push_back(column.name);
    return names;
}

std::vector<Dimension> dimensions_of(const ExpressionInputs& inputs) {
    std::vector<Dimension> dimensions;
    for (const auto& constant : inputs.constants) dimensions.push_back(constant.dimension);
    for (const auto& column : inputs.columns) dimensions.push_back(column.dimension);
    return dimensions;
}

/// Value at generic arguments, with base unit `base` 2^−`power` times as large; larger first or last.
double probe(Expression& expression, const std::vector<Dimension>& dimensions, std::size_t base, int power,
             bool descending) {
    const auto n = dimensions.size();
    for (std::size_t i = 0; i < n; ++i) {
        const double generic = 1.0 + std::sqrt(2.0 + static_cast<double>(descending ? n - i : i));
        expression.set(i, std::ldexp(generic, power * dimensions[i].exponents[base]));
    }
    return expression();
}

/// Whether the expression scales with the dimension.
bool has_dimension(Expression& expression, const std::vector<Dimension>& dimensions, const Dimension& expected) {
    for (std::size_t base = 0; base < expected.exponents.size(); ++base)
        for (const bool descending : {false, true}) {
            const double before = probe(expression, dimensions, base, 0, descending);
            const double after = probe(expression, dimensions, base, 1, descending);
            const double scaled = std::ldexp(before, expected.exponents[base]);
            if (std::isfinite(before) && std::isfinite(after) && std::abs(after - scaled) > 1e-12 * std::abs(scaled))
                return false;
        }
    return true;
}

/// Whether the expression scales with the dimension at the current values, which may be in a separate branch.
bool has_dimension_here(Expression& expression, const std::vector<Dimension>& dimensions, const Dimension& expected) {
    std::vector<double> kept;
    for (std::size_t i = 0; i < dimensions.size(); ++i) kept.push_back(expression.value(i));
    const double before = expression();
    bool scales = true;
    for (std::size_t base = 0; base < expected.exponents.size() && std::isfinite(before); ++base) {
        const auto depends = [base](const Dimension& dimension) { return dimension.exponents[base] != 0; };
        if (!depends(expected) && std::none_of(dimensions.begin(), dimensions.end(), depends)) continue;
        for (std::size_t i = 0; i < kept.size(); ++i)
            expression.set(i, std::ldexp(kept[i], dimensions[i].exponents[base]));
        const double after = expression(), scaled = std::ldexp(before, expected.exponents[base]);
        // rounding of differences between much larger values is not another dimension
        constexpr double rounding = 1e-6;
        scales = scales && (!std::isfinite(after) || std::abs(after - scaled) <= rounding * std::abs(scaled));
    }
    for (std::size_t i = 0; i < kept.size(); ++i) expression.set(i, kept[i]);
    return scales;
}

[[noreturn]] void refuse_dimension(const Dimension& expected) {
    throw InvalidArgument(
        fmt::format("the expression does not have the unit {}; give its constants their units, as in \"3.01 N/m\"",
                    si_unit(expected)));
}

}  // namespace

bool is_identifier(const std::string& name) {
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front()))) return false;
    for (const char c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
    return true;
}

void require_expression(const std::string& expression, const std::vector<std::string>& names) {
    const Expression parsed(expression, names);
}

Array1D evaluate(const std::string& text, const ExpressionInputs& inputs, const Dimension& expected) {
    Expression expression(text, names_of(inputs));
    if (!has_dimension(expression, dimensions_of(inputs), expected)) refuse_dimension(expected);
    const bool branches = text.find_first_of("?<>=") != std::string::npos;
    const auto dimensions = dimensions_of(inputs);
    const auto constants = inputs.constants.size();
    for (std::size_t k = 0; k < constants; ++k) expression.set(k, inputs.constants[k].value);
    const auto rows = inputs.columns.empty() ? Index{0} : inputs.columns.front().values.size();
    Array1D result(rows);
    for (Index i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < inputs.columns.size(); ++k)
            expression.set(constants + k, inputs.columns[k].values[i]);
        if (branches && !has_dimension_here(expression, dimensions, expected)) refuse_dimension(expected);
        result[i] = expression();
    }
    return result;
}

}  // namespace setae::tables
