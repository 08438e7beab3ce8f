// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Description of a type. The rows follow the type in its header:
//
//   template <>
//   struct fields::Described<Odds> {
//       using T = Odds;
//       static constexpr std::array rows{
//           field<&T::value>("value", "of the data as they are"),
//           made<T>("distinction", "by the lower end", [](const T& odds) { return name_of(odds.distinction()); }),
//       };
//       static constexpr Description description{"odds", "odds for one model against another", rows};
//   };
//   static_assert(fields::complete<Odds>);
//
// A forgotten or misspelled member is a compile error.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/boxed.hpp"
#include "setae/core/quantity.hpp"
#include "setae/core/table.hpp"
#include "setae/core/traced_value.hpp"
#include "setae/fields/member_of.hpp"
#include "setae/fields/row.hpp"

namespace setae::fields {

template <class T>
struct Described;

template <>
struct Described<Alert>;
template <>
struct Described<Interval>;
template <>
struct Described<Band>;

template <class T>
concept HasRows = requires { Described<T>::description; };

namespace detail {

/// A spelling for each member or base. (Addresses would also work, but GCC does not compare them in constants with
/// sanitizers.)
template <auto Member>
consteval std::string_view spelling_of_member() {
    return __PRETTY_FUNCTION__;
}
template <class Base>
consteval std::string_view spelling_of_base() {
    return __PRETTY_FUNCTION__;
}

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T, std::size_t N>
inline constexpr bool is_vector<std::array<T, N>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_optional<Boxed<T>> = true;
template <class T>
inline constexpr bool is_map = false;
template <class T>
inline constexpr bool is_map<std::vector<std::pair<std::string, T>>> = true;
template <class T>
inline constexpr bool is_map<std::map<std::string, T>> = true;
template <class T>
inline constexpr bool is_column = std::is_same_v<T, Array1D> || std::is_same_v<T, std::vector<double>>;
template <class T>
inline constexpr bool is_text = std::is_convertible_v<T, std::string_view>;
template <class T>
inline constexpr bool is_list = (is_vector<T> && !is_map<T>) || is_column<T>;
template <class T>
inline constexpr bool holds_error =
    std::is_same_v<T, Estimate> || std::is_same_v<T, TracedValue> || std::is_same_v<T, Quantity>;

/// A value or the reason for its absence, such as loops::Outcome.
template <class T>
concept WithReason = requires(const T& outcome) {
    static_cast<bool>(outcome);
    *outcome;
    { outcome.reason } -> std::convertible_to<std::string>;
};

/// Type of an optional value.
template <class T>
struct Bare {
    using Type = T;
};
template <class T>
struct Bare<std::optional<T>> {
    using Type = typename Bare<T>::Type;
};
template <class T>
struct Bare<Boxed<T>> {
    using Type = typename Bare<T>::Type;
};
template <WithReason T>
struct Bare<T> {
    using Type = std::remove_cvref_t<decltype(*std::declval<const T&>())>;
};

/// Default output of a missing value, unless the row sets another one.
template <class T>
inline constexpr Missing otherwise = Missing::never;
template <class T>
inline constexpr Missing otherwise<std::optional<T>> = WithReason<T> ? Missing::as_asked : Missing::left_out;
template <class T>
inline constexpr Missing otherwise<Boxed<T>> = otherwise<std::optional<T>>;
template <WithReason T>
inline constexpr Missing otherwise<T> = Missing::with_reason;

/// What values of a type are that are held by name.
template <class T>
consteval Kind kind_by_name() {
    if constexpr (holds_error<T>) return Kind::quantity_of;
    else if constexpr (std::is_integral_v<T>) return Kind::whole_of;
    else if constexpr (std::is_floating_point_v<T>) return Kind::number_of;
    else if constexpr (is_text<T>) return Kind::text_of;
    else return Kind::objects_of;
}

/// Kind of a type in outputs, without a unit.
template <class T>
consteval Kind kind_of() {
    if constexpr (std::is_same_v<T, bool>) return Kind::flag;
    else if constexpr (std::is_integral_v<T>) return Kind::whole;
    else if constexpr (std::is_floating_point_v<T>) return Kind::number;
    else if constexpr (holds_error<T>) return Kind::quantity;
    else if constexpr (is_text<T>) return Kind::text;
    else if constexpr (std::is_same_v<T, Eigen::MatrixXd>) return Kind::matrix;
    else if constexpr (is_column<T>) return Kind::numbers;
    else if constexpr (is_map<T>) return kind_by_name<typename T::value_type::second_type>();
    else if constexpr (is_vector<T>) {
        using Element = typename T::value_type;
        if constexpr (is_list<Element>) return kind_of<Element>();
        else if constexpr (is_text<Element>) return Kind::texts;
        else if constexpr (holds_error<Element>) return Kind::quantities;
        else if constexpr (std::is_floating_point_v<Element>) return Kind::numbers;
        else if constexpr (std::is_integral_v<Element>) return Kind::wholes;
        else return Kind::objects;
    } else return Kind::object;
}

/// Levels of nested lists.
template <class T>
consteval int levels_of() {
    if constexpr (is_list<T>) return 1 + levels_of<typename T::value_type>();
    else return 0;
}

/// The description of a type, or of the elements of a list.
template <class T>
consteval const Description* inner_of() {
    if constexpr (HasRows<T>) return &Described<T>::description;
    else if constexpr (is_map<T>) return inner_of<typename T::value_type::second_type>();
    else if constexpr (is_vector<T>) return inner_of<typename T::value_type>();
    else return nullptr;
}

inline void put_number(double value, const Row& row, Sink& sink) {
    if (row.kind == Kind::quantity) sink.quantity(row, Estimate{.value = value});
    else if (row.kind == Kind::value) sink.value(row, value);
    else sink.number(row, value);
}

template <class T>
void put_present(const T& value, const Row& row, Sink& sink);

template <class T>
void put_list(const T& list, const Row& row, Sink& sink) {
    sink.begin_list(row);
    for (const auto& element : list) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(element)>, double>) sink.number(row, element);
        else put_present(element, row, sink);
    }
    sink.end_list(row);
}

template <class T>
void put_by_name(const T& held, const Row& row, Sink& sink) {
    sink.begin(row);
    for (const auto& [name, value] : held) {
        sink.key(name);
        put_present(value, row, sink);
    }
    sink.end(row);
}

inline void put_matrix(const Eigen::MatrixXd& matrix, const Row& row, Sink& sink) {
    sink.begin_list(row);
    for (Index i = 0; i < matrix.rows(); ++i) {
        sink.begin_list(row);
        for (Index k = 0; k < matrix.cols(); ++k) sink.number(row, matrix(i, k));
        sink.end_list(row);
    }
    sink.end_list(row);
}

/// A value that is there, even an empty text or list.
template <class T>
void put_present(const T& value, const Row& row, Sink& sink) {
    if constexpr (std::is_same_v<T, bool>) sink.flag(row, value);
    else if constexpr (std::is_same_v<T, std::uint64_t>) sink.whole(row, value);
    else if constexpr (std::is_integral_v<T>) sink.whole(row, static_cast<long long>(value));
    else if constexpr (std::is_floating_point_v<T>) put_number(value, row, sink);
    else if constexpr (std::is_same_v<T, TracedValue>) sink.quantity(row, value.estimate());
    else if constexpr (holds_error<T>) sink.quantity(row, value);
    else if constexpr (is_text<T>) sink.text(row, value);
    else if constexpr (is_optional<T> || WithReason<T>) {
        if (value) return put_present(*value, row, sink);
        if (row.if_missing == Missing::left_out) return;
        if constexpr (WithReason<T>) sink.missing(row, value.reason);
        else if (row.if_missing != Missing::as_asked) sink.missing(row, {});
    } else if constexpr (std::is_same_v<T, Eigen::MatrixXd>) put_matrix(value, row, sink);
    else if constexpr (is_map<T>) put_by_name(value, row, sink);
    else if constexpr (is_list<T>) put_list(value, row, sink);
    else {
        static_assert(HasRows<T>, "a type without rows: describe it where it is defined");
        sink.begin(row);
        put(&value, Described<T>::description, sink);
        sink.end(row);
    }
}

/// A value; an empty text or list is missing where the row states an output for missing values.
template <class T>
void put_value(const T& value, const Row& row, Sink& sink) {
    if constexpr (is_text<T> || is_map<T> || is_list<T>) {
        const bool empty = [&value] {
            if constexpr (is_text<T>) return std::string_view(value).empty();
            else return value.size() == 0;
        }();
        if (empty && row.if_missing == Missing::left_out) return;
        if (empty && row.if_missing == Missing::null) return sink.missing(row, {});
    }
    put_present(value, row, sink);
}

template <class T>
consteval Row row_of(std::string_view name, std::string_view meaning) {
    using Value = typename Bare<T>::Type;
    return {.name = name,
            .meaning = meaning,
            .kind = kind_of<Value>(),
            .if_missing = otherwise<T>,
            .inner = inner_of<Value>(),
            .levels = levels_of<Value>(),
            .has_error = holds_error<Value>};
}

/// A row with a unit: a number is then a quantity, or a value if it has no symbol and no error.
consteval Row with_unit(Row row, Kind of_number, std::string_view symbol, std::string_view unit) {
    row.symbol = symbol;
    row.unit = unit;
    if (row.kind == Kind::number) row.kind = of_number;
    if (row.kind == Kind::numbers) row.kind = Kind::values;
    return row;
}

template <auto Member>
void put_member(const void* result, const Row& row, Sink& sink) {
    using Object = typename MemberOf<decltype(Member)>::Object;
    put_value(static_cast<const Object*>(result)->*Member, row, sink);
}

template <class T, class From>
void put_made(const void* result, const Row& row, Sink& sink) {
    put_value(From{}(*static_cast<const T*>(result)), row, sink);
}

}  // namespace detail

/// A member that is a field.
template <auto Member>
consteval Row field(std::string_view name, std::string_view meaning) {
    auto row = detail::row_of<typename detail::MemberOf<decltype(Member)>::Type>(name, meaning);
    row.member = detail::spelling_of_member<Member>();
    row.put = detail::put_member<Member>;
    return row;
}

/// A member that is a number with symbol and unit, SI.
template <auto Member>
consteval Row quantity(std::string_view name, std::string_view symbol, std::string_view unit,
                       std::string_view meaning) {
    return detail::with_unit(field<Member>(name, meaning), Kind::quantity, symbol, unit);
}

/// A member that is a number, or numbers, with unit only.
template <auto Member>
consteval Row value(std::string_view name, std::string_view unit, std::string_view meaning) {
    return detail::with_unit(field<Member>(name, meaning), Kind::value, {}, unit);
}

/// A field that is computed from a result; `from` captures nothing.
template <class T, class From>
consteval Row made(std::string_view name, std::string_view meaning, From) {
    auto row = detail::row_of<std::remove_cvref_t<std::invoke_result_t<From, const T&>>>(name, meaning);
    row.put = detail::put_made<T, From>;
    return row;
}

/// A computed quantity. A setae::Quantity supplies what the row lacks: unit and n.
template <class T, class From>
consteval Row made(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view meaning,
                   From from) {
    return detail::with_unit(made<T>(name, meaning, from), Kind::quantity, symbol, unit);
}

/// A computed number, or computed numbers, with unit only.
template <class T, class From>
consteval Row made_value(std::string_view name, std::string_view unit, std::string_view meaning, From from) {
    return detail::with_unit(made<T>(name, meaning, from), Kind::value, {}, unit);
}

/// A quantity with its number of points n.
[[nodiscard]] inline Quantity with_count(Index n, const Estimate& estimate) {
    return {.estimate = estimate, .n = static_cast<int>(n)};
}

/// Fields of the same result, grouped under a name.
template <class T>
consteval Row part(std::string_view name, std::string_view meaning, const Description& inner) {
    return {.name = name,
            .meaning = meaning,
            .kind = Kind::object,
            .inner = &inner,
            .is_part = true,
            .put = [](const void* result, const Row& row, Sink& sink) {
                sink.begin(row);
                put(result, *row.inner, sink);
                sink.end(row);
            }};
}

/// The fields of a base, at the level of its own fields.
template <class T, std::derived_from<T> Derived>
consteval Row inherited() {
    return {.kind = Kind::object,
            .inner = &Described<T>::description,
            .member = detail::spelling_of_base<T>(),
            .among = true,
            .put = [](const void* result, const Row& row, Sink& sink) {
                const T& base = *static_cast<const Derived*>(result);
                put(&base, *row.inner, sink);
            }};
}

/// Fields of another result, which `from` takes from this one, at the level of its own fields; none if the other result
/// is missing.
template <class T, class From>
consteval Row fields_of(const Description& of_other, From) {
    using Other = std::remove_cvref_t<std::invoke_result_t<From, const T&>>;
    constexpr bool always = detail::otherwise<Other> == Missing::never;
    return {.kind = Kind::object,
            .if_missing = always ? Missing::never : Missing::left_out,
            .inner = &of_other,
            .among = true,
            .put = [](const void* result, const Row& row, Sink& sink) {
                const auto& other = From{}(*static_cast<const T*>(result));
                if constexpr (always) put(&other, *row.inner, sink);
                else if (other) put(&*other, *row.inner, sink);
            }};
}
/// All fields of another result.
template <class T, class From>
consteval Row fields_of(From from) {
    using Other = std::remove_cvref_t<std::invoke_result_t<From, const T&>>;
    return fields_of<T>(Described<typename detail::Bare<Other>::Type>::description, from);
}

template <>
struct Described<Alert> {
    using T = Alert;
    static constexpr std::array rows{
        field<&T::code>("code", "code of the warning: docs/reference/alerts.md"),
        field<&T::subject>("subject", "subject of the warning"),
        field<&T::message>("message", "cause and size of the effect"),
        field<&T::action>("action", "action; empty if none is needed"),
    };
    static constexpr Description description{"alert", "a warning on a result", rows};
};

template <>
struct Described<Interval> {
    using T = Interval;
    static constexpr std::array rows{
        field<&T::lower>("lower", "lower end"),
        field<&T::upper>("upper", "upper end"),
        field<&T::level>("level", "probability that the interval covers the value"),
    };
    static constexpr Description description{"interval", "an interval and its probability", rows};
};

template <>
struct Described<Band> {
    using T = Band;
    static constexpr std::array rows{
        field<&T::lower>("lower", "smallest wavevector"),
        field<&T::upper>("upper", "largest wavevector"),
        made<T>("unit", "unit of both ends", [](const T&) { return std::string_view("1/m"); }),
    };
    static constexpr Description description{"band", "a range of wavevectors", rows};
};

namespace detail {
consteval Row of_kind(Kind kind, std::string_view name, std::string_view meaning, Missing otherwise = Missing::left_out,
                      const Description* inner = nullptr) {
    return {.name = name, .meaning = meaning, .kind = kind, .if_missing = otherwise, .inner = inner};
}
inline constexpr std::array rows_of_quantity{
    of_kind(Kind::text, "quantity", "name of the quantity", Missing::never),
    of_kind(Kind::text, "symbol", "symbol of the quantity in formulas", Missing::never),
    of_kind(Kind::number, "value", "value in SI units", Missing::never),
    of_kind(Kind::text, "unit", "unit of value, standard error and interval", Missing::never),
    of_kind(Kind::number, "standard_error", "one standard deviation"),
    of_kind(Kind::object, "interval", "interval that covers the value with the probability `level`", Missing::left_out,
            &Described<Interval>::description),
    of_kind(Kind::text, "method", "method that gave standard error and interval"),
    of_kind(Kind::whole, "seed", "seed of the random numbers"),
    of_kind(Kind::object, "band", "wavevectors that the value depends on", Missing::left_out,
            &Described<Band>::description),
    of_kind(Kind::whole, "n", "number of points, measurements or pairs"),
    of_kind(Kind::number, "degrees_of_freedom", "degrees of freedom of Student's t or of χ²"),
    of_kind(Kind::text, "source", "formula and its source"),
    of_kind(Kind::objects, "alerts", "warnings on the value", Missing::left_out, &Described<Alert>::description),
};
}  // namespace detail

/// Fields of every quantity, which a Sink writes.
inline constexpr Description quantity_description{"quantity", "a number with symbol, unit and error",
                                                  detail::rows_of_quantity};

namespace detail {
inline constexpr std::array rows_of_value{
    of_kind(Kind::number, "value", "the number in SI units", Missing::never),
    of_kind(Kind::text, "unit", "unit of the number", Missing::never),
};
inline constexpr std::array rows_of_values{
    of_kind(Kind::numbers, "values", "the numbers in SI units", Missing::never),
    of_kind(Kind::text, "unit", "unit of the numbers", Missing::never),
};
}  // namespace detail

/// Fields of a number with unit and of numbers with unit, which a Sink writes.
inline constexpr Description value_description{"value", "a number with its unit", detail::rows_of_value};
inline constexpr Description values_description{"values", "numbers with their unit", detail::rows_of_values};

/// The fields of a quantity that `from` has from a result, among its own.
template <class T, class From>
consteval Row quantity_fields(From) {
    return {.kind = Kind::object,
            .inner = &quantity_description,
            .among = true,
            .put = [](const void* result, const Row&, Sink& sink) {
                sink.fields_of(From{}(*static_cast<const T*>(result)));
            }};
}

/// A quantity that a result may have: for quantities_among().
consteval Row possible(std::string_view name, std::string_view symbol, std::string_view unit,
                       std::string_view meaning) {
    return {.name = name,
            .symbol = symbol,
            .unit = unit,
            .meaning = meaning,
            .kind = Kind::quantity,
            .if_missing = Missing::left_out};
}

/// Quantities that `from` has from a result, each a field of `possible` that has its name or its term. Fields may share
/// a name, such as Sq of a map and Rq of a line; a result has one of them.
template <class T, class From>
consteval Row quantities_among(const Description& possible, From) {
    return {.kind = Kind::object,
            .if_missing = Missing::left_out,
            .inner = &possible,
            .among = true,
            .put = [](const void* result, const Row& row, Sink& sink) {
                for (const Quantity& value : From{}(*static_cast<const T*>(result)))
                    sink.quantity(row_named(*row.inner, value.quantity), value);
            }};
}

/// A plain number that every result has, for numbers_among(); its unit stands elsewhere in the output.
consteval Row number(std::string_view name, std::string_view unit, std::string_view meaning) {
    return {.name = name, .unit = unit, .meaning = meaning, .kind = Kind::number};
}

/// Values of quantities that `from` has from a result, each a plain number under its own name, which is one of
/// `possible`.
template <class T, class From>
consteval Row numbers_among(const Description& possible, From) {
    return {.kind = Kind::object,
            .inner = &possible,
            .among = true,
            .put = [](const void* result, const Row& row, Sink& sink) {
                const auto& quantities = From{}(*static_cast<const T*>(result));
                for (const Quantity& value : quantities)
                    sink.number(row_named(*row.inner, value.quantity), value.estimate.value);
            }};
}

/// A column that a table may have: for columns_among().
consteval Row column(std::string_view name, std::string_view unit, std::string_view meaning) {
    return {.name = name,
            .unit = unit,
            .meaning = meaning,
            .kind = Kind::numbers,
            .if_missing = Missing::left_out,
            .levels = 1};
}

/// Columns of a table that `from` has from a result, each a list of numbers under its own name; `possible` describes
/// those whose names are fixed.
template <class T, class From>
consteval Row columns_among(const Description& possible, From) {
    return {
        .kind = Kind::object, .inner = &possible, .among = true, .put = [](const void* result, const Row&, Sink& sink) {
            static constexpr Row numbers{.kind = Kind::numbers, .levels = 1};
            const Table& table = From{}(*static_cast<const T*>(result));
            for (const auto& column : table.columns) {
                sink.key(column.name);
                detail::put_list(column.values, numbers, sink);
            }
        }};
}
/// Units of these columns, by name.
template <class T, class From>
consteval Row units_of_columns(From) {
    return {.name = "units",
            .meaning = "unit of each column",
            .kind = Kind::text_of,
            .put = [](const void* result, const Row& row, Sink& sink) {
                const Table& table = From{}(*static_cast<const T*>(result));
                sink.begin(row);
                for (const auto& column : table.columns) {
                    sink.key(column.name);
                    sink.text(row, column.unit);
                }
                sink.end(row);
            }};
}

/// Units of plain numbers, by the names of their fields.
consteval Row units_of(const Description& fields) {
    return {.name = "units",
            .meaning = "unit of each column",
            .kind = Kind::text_of,
            .inner = &fields,
            .put = [](const void*, const Row& row, Sink& sink) {
                sink.begin(row);
                for (const auto& field : row.inner->rows) {
                    sink.key(field.name);
                    sink.text(row, field.unit);
                }
                sink.end(row);
            }};
}

/// The rows of several arrays.
template <std::size_t... N>
consteval auto joined(const std::array<Row, N>&... arrays) {
    std::array<Row, (N + ...)> all{};
    auto place = all.begin();
    ((place = std::copy(arrays.begin(), arrays.end(), place)), ...);
    return all;
}

/// A list whose elements other code adds: empty here.
template <class Element>
consteval Row list_filled_later(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .meaning = meaning,
            .kind = Kind::objects,
            .inner = &Described<Element>::description,
            .put = [](const void*, const Row& row, Sink& sink) {
                sink.begin_list(row);
                sink.end_list(row);
            }};
}
/// Objects by name that other code adds.
template <class Element>
consteval Row objects_filled_later(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .meaning = meaning,
            .kind = Kind::objects_of,
            .inner = &Described<Element>::description,
            .put = [](const void*, const Row& row, Sink& sink) {
                sink.begin(row);
                sink.end(row);
            }};
}

/// A field that other code writes; only schemas contain it.
consteval Row written_elsewhere(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .kind = Kind::text};
}
/// An object that other code writes; only schemas contain it.
consteval Row written_elsewhere(std::string_view name, std::string_view meaning, const Description& object) {
    return {.name = name, .meaning = meaning, .kind = Kind::object, .inner = &object};
}

/// A member without its own output: computed fields use it.
template <auto Member>
consteval Row inner() {
    return {.member = detail::spelling_of_member<Member>()};
}

namespace detail {

/// Converts to any member type, to count members.
struct Anything {
    template <class T>
    operator T() const;
};

template <class T, std::size_t... I>
constexpr bool takes(std::index_sequence<I...>) {
    return requires { T{(static_cast<void>(I), Anything{})...}; };
}

template <class T, std::size_t N = 0>
constexpr std::size_t member_count() {
    if constexpr (takes<T>(std::make_index_sequence<N + 1>{})) return member_count<T, N + 1>();
    else return N;
}

/// Whether rows name a member, including rows of parts.
constexpr bool names(std::span<const Row> rows, std::string_view member) {
    for (const auto& row : rows)
        if (row.member == member || (row.is_part && names(row.inner->rows, member))) return true;
    return false;
}

/// Number of distinct members: each member is counted at its last occurrence.
constexpr std::size_t distinct_members(std::span<const Row> rows) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto later = rows.subspan(i + 1);
        if (!rows[i].member.empty()) count += !names(later, rows[i].member);
        else if (rows[i].is_part)
            for (const auto& row : rows[i].inner->rows) count += !row.member.empty() && !names(later, row.member);
    }
    return count;
}

}  // namespace detail

/// Whether rows name every member of an aggregate; a base counts as one.
template <class T>
inline constexpr bool complete = detail::member_count<T>() == detail::distinct_members(Described<T>::rows);

}  // namespace setae::fields
