// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a type is described. The rows stand below the type, in its header:
//
//   template <>
//   struct fields::Described<Odds> {
//       using T = Odds;
//       static constexpr std::array rows{
//           number<&T::value>("value", "of the data as they are"),
//           made<T>("distinction", "by the lower end", [](const T& odds) { return name_of(odds.distinction()); }),
//       };
//       static constexpr Description description{"odds", "odds for one model against another", rows};
//   };
//   static_assert(fields::complete<Odds>);
//
// A forgotten member and a misspelled one do not compile.

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/core/traced_value.hpp"
#include "setae/fields/row.hpp"

namespace setae::fields {

template <class T>
struct Described;

template <class T>
concept HasRows = requires { Described<T>::description; };

template <>
struct Described<Alert>;

namespace detail {

template <class T>
struct MemberOf;
template <class Of, class Value>
struct MemberOf<Value Of::*> {
    using Object = Of;
    using Type = Value;
};

template <auto Member>
inline constexpr char address_of_member{};

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_map = false;
template <class T>
inline constexpr bool is_map<std::vector<std::pair<std::string, T>>> = true;

/// A value or the reason why there is none, such as loops::Outcome.
template <class T>
concept WithReason = requires(const T& outcome) {
    static_cast<bool>(outcome);
    *outcome;
    { outcome.reason } -> std::convertible_to<std::string>;
};

template <class T>
struct Bare {
    using Type = T;
};
template <class T>
struct Bare<std::optional<T>> {
    using Type = T;
};
template <WithReason T>
struct Bare<T> {
    using Type = std::remove_cvref_t<decltype(*std::declval<const T&>())>;
};

/// What a type is in outputs; the unit tells a number from a value.
template <class T>
consteval Kind kind_of(bool has_unit) {
    if constexpr (std::is_same_v<T, bool>) return Kind::flag;
    else if constexpr (std::is_integral_v<T>) return Kind::whole;
    else if constexpr (std::is_floating_point_v<T>) return has_unit ? Kind::value : Kind::number;
    else if constexpr (std::is_same_v<T, Estimate> || std::is_same_v<T, TracedValue> || std::is_same_v<T, Quantity>)
        return Kind::quantity;
    else if constexpr (std::is_convertible_v<T, std::string_view>) return Kind::text;
    else if constexpr (is_map<T>)
        return std::is_same_v<typename T::value_type::second_type, Estimate> ? Kind::quantity_of : Kind::number_of;
    else if constexpr (is_vector<T>) {
        using Element = typename T::value_type;
        if constexpr (std::is_same_v<Element, std::string>) return Kind::texts;
        else if constexpr (std::is_same_v<Element, double>) return Kind::values;
        else if constexpr (std::is_same_v<Element, int>) return Kind::wholes;
        else return Kind::objects;
    } else return Kind::object;
}

template <class T>
consteval const Description* inner_of() {
    if constexpr (HasRows<T>) return &Described<T>::description;
    else if constexpr (is_vector<T>) {
        if constexpr (HasRows<typename T::value_type>) return &Described<typename T::value_type>::description;
        else return nullptr;
    } else return nullptr;
}

template <class T>
void put_value(const T& value, const Row& row, Sink& sink) {
    if constexpr (std::is_same_v<T, bool>) sink.flag(row, value);
    else if constexpr (std::is_integral_v<T>) sink.whole(row, static_cast<long long>(value));
    else if constexpr (std::is_floating_point_v<T>) row.unit.empty() ? sink.number(row, value) : sink.value(row, value);
    else if constexpr (std::is_same_v<T, Estimate> || std::is_same_v<T, Quantity>) sink.quantity(row, value);
    else if constexpr (std::is_same_v<T, TracedValue>) sink.quantity(row, value.estimate());
    else if constexpr (std::is_convertible_v<T, std::string_view>) sink.text(row, value);
    else if constexpr (is_optional<T> || WithReason<T>) {
        if (value) put_value(*value, row, sink);
        else if (row.if_missing != Missing::left_out) {
            if constexpr (WithReason<T>) sink.missing(row, value.reason);
            else sink.missing(row, {});
        }
    } else if constexpr (is_map<T>) {
        if (value.empty() && row.if_missing == Missing::null) return sink.missing(row, {});
        sink.begin(row);
        for (const auto& [name, held] : value) {
            sink.key(name);
            put_value(held, row, sink);
        }
        sink.end(row);
    } else if constexpr (is_vector<T>) {
        if (value.empty() && row.if_missing == Missing::left_out) return;
        sink.begin_list(row);
        for (const auto& element : value) {
            if constexpr (std::is_same_v<typename T::value_type, double>) sink.number(row, element);
            else put_value(element, row, sink);
        }
        sink.end_list(row);
    } else {
        static_assert(HasRows<T>, "a type without rows: describe it where it is defined");
        sink.begin(row);
        put(&value, Described<T>::description, sink);
        sink.end(row);
    }
}

template <class T>
consteval Row row_of(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view meaning) {
    using Value = typename Bare<T>::Type;
    return {.name = name,
            .symbol = symbol,
            .unit = unit,
            .meaning = meaning,
            .kind = kind_of<Value>(!unit.empty()),
            .if_missing = WithReason<T>    ? Missing::with_reason
                          : is_optional<T> ? Missing::left_out
                                           : Missing::never,
            .inner = inner_of<Value>()};
}

template <auto Member>
void put_member(const void* result, const Row& row, Sink& sink) {
    using Object = typename MemberOf<decltype(Member)>::Object;
    put_value(static_cast<const Object*>(result)->*Member, row, sink);
}

}  // namespace detail

/// A member that is a field.
template <auto Member>
consteval Row field(std::string_view name, std::string_view meaning) {
    auto row = detail::row_of<typename detail::MemberOf<decltype(Member)>::Type>(name, {}, {}, meaning);
    row.member = &detail::address_of_member<Member>;
    row.put = detail::put_member<Member>;
    return row;
}

/// A member that is a number with symbol and unit, SI.
template <auto Member>
consteval Row quantity(std::string_view name, std::string_view symbol, std::string_view unit,
                       std::string_view meaning) {
    auto row = field<Member>(name, meaning);
    row.symbol = symbol;
    row.unit = unit;
    if (row.kind == Kind::number) row.kind = Kind::value;
    return row;
}

/// A field that is computed from a result; `from` captures nothing.
template <class T, class From>
consteval Row made(std::string_view name, std::string_view meaning, From) {
    using Made = std::remove_cvref_t<std::invoke_result_t<From, const T&>>;
    auto row = detail::row_of<Made>(name, {}, {}, meaning);
    row.put = [](const void* result, const Row& own, Sink& sink) {
        detail::put_value(From{}(*static_cast<const T*>(result)), own, sink);
    };
    return row;
}
/// The same with symbol and unit.
template <class T, class From>
consteval Row made(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view meaning,
                   From from) {
    auto row = made<T>(name, meaning, from);
    row.symbol = symbol;
    row.unit = unit;
    if (row.kind == Kind::number) row.kind = Kind::value;
    return row;
}

/// Fields of the same result that stand together under a name.
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

/// A field that other code writes, as words need more than the result: schemas know it.
consteval Row written_apart(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .kind = Kind::text};
}

/// A member that stands in no output by itself: computed fields are made from it.
template <auto Member>
consteval Row inner() {
    return {.member = &detail::address_of_member<Member>};
}

namespace detail {

/// Takes the place of any member in the count of members.
struct Anything {
    template <class T>
    operator T() const;
};

template <class T, std::size_t... I>
consteval bool takes(std::index_sequence<I...>) {
    return requires { T{(static_cast<void>(I), Anything{})...}; };
}

template <class T, std::size_t N = 0>
consteval std::size_t member_count() {
    if constexpr (takes<T>(std::make_index_sequence<N + 1>{})) return member_count<T, N + 1>();
    else return N;
}

/// Whether rows name a member, those of parts included.
consteval bool names(std::span<const Row> rows, const void* member) {
    for (const auto& row : rows)
        if (row.member == member || (row.is_part && names(row.inner->rows, member))) return true;
    return false;
}

/// Each member is counted where it is named last.
consteval std::size_t distinct_members(std::span<const Row> rows) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto later = rows.subspan(i + 1);
        if (rows[i].is_part) {
            for (const auto& row : rows[i].inner->rows) count += row.member && !names(later, row.member);
        } else {
            count += rows[i].member && !names(later, rows[i].member);
        }
    }
    return count;
}

}  // namespace detail

template <>
struct Described<Alert> {
    using T = Alert;
    static constexpr std::array rows{
        field<&T::code>("code", "which alert: docs/reference/alerts.md"),
        field<&T::subject>("subject", "what it is about"),
        field<&T::message>("message", "what is the case"),
        field<&T::action>("action", "what to do about it; empty where that is nothing"),
    };
    static constexpr Description description{"alert", "something the reader of a number must know", rows};
};

/// Whether rows name every member of an aggregate.
template <class T>
inline constexpr bool complete = detail::member_count<T>() == detail::distinct_members(Described<T>::rows);

}  // namespace setae::fields
