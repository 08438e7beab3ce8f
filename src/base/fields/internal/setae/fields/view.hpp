// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "setae/fields/describe.hpp"

namespace setae::fields {

/// Whether a column has its standard error next to it.
enum class Errors { beside, left_out };

/// A column of a table: a field, by its name or path ("likelier.model"), with a heading.
struct Column {
    std::string_view heading{};
    std::string_view path{};
    double unit = 1.0;  ///< unit of the table in that of the field
    Errors errors = Errors::beside;
    const Row* row = nullptr;
};

namespace detail {

/// Not defined: a view with an unknown name does not compile.
void this_type_has_no_field_of_that_name();

/// Empty if no field has the name. (GCC does not compare an address with nullptr in constants with sanitizers.)
consteval std::optional<const Row*> find(const Description& description, std::string_view path) {
    const auto dot = path.find('.');
    for (const auto& row : description.rows) {
        if (row.among) {
            if (const auto found = find(*row.inner, path)) return found;
        }
        if (row.name.empty() || row.name != path.substr(0, dot)) continue;
        return dot == std::string_view::npos ? &row : find(*row.inner, path.substr(dot + 1));
    }
    return {};
}

consteval const Row* row_of_column(const Description& description, std::string_view path) {
    const auto found = find(description, path);
    if (!found) this_type_has_no_field_of_that_name();
    return *found;
}

}  // namespace detail

/// A column for a field of the type: another name does not compile.
template <class T>
struct ColumnOf : Column {
    consteval ColumnOf(std::string_view heading_, std::string_view path_, double unit_ = 1.0,
                       Errors errors_ = Errors::beside)
        : Column{heading_, path_, unit_, errors_, detail::row_of_column(Described<T>::description, path_)} {}
    consteval ColumnOf(std::string_view heading_, std::string_view path_, Errors errors_)
        : ColumnOf(heading_, path_, 1.0, errors_) {}
    /// A field with its own name as heading.
    consteval ColumnOf(std::string_view name) : ColumnOf(name, name) {}
};

/// The columns of a view, as an array of Column.
template <class T, std::size_t N>
consteval std::array<Column, N> view_of(const ColumnOf<T> (&columns)[N]) {
    std::array<Column, N> view{};
    for (std::size_t i = 0; i < N; ++i) view[i] = columns[i];
    return view;
}

/// Content of a field in a table: words, or a number [unit of the column] and its standard error. Words are empty and
/// numbers NaN if the result lacks the field.
struct Cell {
    std::variant<std::string, double> value;
    double standard_error = undefined;
};

/// One cell per column.
[[nodiscard]] std::vector<Cell> cells(const void* result, const Description& description, std::span<const Column> view);
template <HasRows T>
[[nodiscard]] std::vector<Cell> cells(const T& result, std::span<const Column> view) {
    return cells(&result, Described<T>::description, view);
}

/// Whether a column holds words.
[[nodiscard]] bool holds_words(const Column& column);
/// Whether a column of standard errors is next to it.
[[nodiscard]] bool has_error(const Column& column);

}  // namespace setae::fields
