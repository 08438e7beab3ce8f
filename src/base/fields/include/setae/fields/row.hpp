// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "setae/core/quantity.hpp"

namespace setae::fields {

/// Kind of a field; it determines the form in every output.
enum class Kind {
    flag,         ///< yes or no
    whole,        ///< a whole number
    number,       ///< a number without unit
    value,        ///< a number with unit
    quantity,     ///< a number with symbol, unit and error
    text,         ///< words
    choice,       ///< one of a few words (Row::choices)
    numbers,      ///< a list of numbers
    values,       ///< numbers with unit
    wholes,       ///< a list of whole numbers
    texts,        ///< a list of words
    matrix,       ///< rows of numbers
    object,       ///< nested fields (Row::inner)
    objects,      ///< a list of objects
    quantities,   ///< a list of quantities
    quantity_of,  ///< quantities by name
    number_of,    ///< numbers by name
    whole_of,     ///< whole numbers by name
    text_of,      ///< texts by name
    objects_of,   ///< objects by name, each with the fields of Row::inner
};

/// Output for a result that lacks the field.
enum class Missing {
    never,        ///< never missing
    left_out,     ///< no field at all
    null,         ///< the field without a value
    with_reason,  ///< null, and the reason in a field NAME_reason
    as_asked,     ///< no field if it was not requested; null with the reason if the computation failed
};

struct Row;

/// Description of a type: every result of this type has these fields, in this order.
struct Description {
    std::string_view name;     ///< in schemas, such as "odds"; empty if used in one place only
    std::string_view meaning;  ///< one sentence
    std::span<const Row> rows;
};

/// One output of a result, filled field by field in the order of the rows.
class Sink {
public:
    Sink() = default;
    Sink(const Sink&) = delete;
    Sink& operator=(const Sink&) = delete;
    virtual ~Sink() = default;

    virtual void flag(const Row& row, bool value) = 0;
    virtual void whole(const Row& row, long long value) = 0;
    /// Seeds have 64 bits without a sign.
    virtual void whole(const Row& row, std::uint64_t value) = 0;
    virtual void number(const Row& row, double value) = 0;
    virtual void value(const Row& row, double value) = 0;
    virtual void quantity(const Row& row, const Estimate& value) = 0;
    /// A quantity whose name, symbol and unit come from the result.
    virtual void quantity(const Row& row, const Quantity& value) = 0;
    /// The fields of a quantity, among those of the open object.
    virtual void fields_of(const Quantity& value) = 0;
    virtual void text(const Row& row, std::string_view value) = 0;
    /// Lists of numbers, words and objects: begin, elements, end; rows of a matrix are nested lists.
    virtual void begin_list(const Row& row) = 0;
    virtual void end_list(const Row& row) = 0;
    /// An object, an element of objects, or a value held by name.
    virtual void begin(const Row& row) = 0;
    virtual void end(const Row& row) = 0;
    /// Name of the next value, for Kind::quantity_of and number_of and for columns of a table.
    virtual void key(std::string_view name) = 0;
    /// Missing::null and with_reason; the reason is empty for null.
    virtual void missing(const Row& row, std::string_view reason) = 0;
};

/// A field of a type: its name, its meaning, and access to its value in a result.
struct Row {
    std::string_view name{};     ///< snake_case: the name in JSON, Python and schemas; empty if it is in no output
    std::string_view term{};     ///< the field's term for the quantity, if it differs from the name
    std::string_view symbol{};   ///< in formulas, such as "W_app"; empty if there is none
    std::string_view unit{};     ///< SI; empty if there is none
    std::string_view meaning{};  ///< one sentence or less
    std::string_view source{};   ///< of a quantity: formula and reference
    Kind kind = Kind::text;
    Missing if_missing = Missing::never;
    const Description* inner = nullptr;           ///< of objects
    std::span<const std::string_view> choices{};  ///< of Kind::choice
    int levels = 0;                               ///< of lists: levels of nested lists
    std::string_view member{};                    ///< spelling of the member or base; empty if computed
    bool is_part = false;                         ///< `inner` has further fields of the same result
    bool among = false;                           ///< the fields of `inner` are at the level of the others, without a
                                                  ///< name
    bool has_error = false;                       ///< of a quantity: its type holds one
    void (*put)(const void* result, const Row& row, Sink& sink) = nullptr;  ///< nullptr: no output, or written by other
                                                                            ///< code

    /// The field is null if the result lacks it.
    [[nodiscard]] consteval Row or_null() const { return with(Missing::null); }
    [[nodiscard]] consteval Row with(Missing otherwise) const {
        Row row = *this;
        row.if_missing = otherwise;
        return row;
    }
    /// The quantity has this term.
    [[nodiscard]] consteval Row as(std::string_view quantity) const {
        Row row = *this;
        row.term = quantity;
        return row;
    }
    /// The quantity has this formula.
    [[nodiscard]] consteval Row from(std::string_view formula) const {
        Row row = *this;
        row.source = formula;
        return row;
    }
    /// The unit of a number that outputs contain without its unit.
    [[nodiscard]] consteval Row in_unit(std::string_view si_unit) const {
        Row row = *this;
        row.unit = si_unit;
        return row;
    }
    /// The allowed words.
    [[nodiscard]] consteval Row one_of(std::span<const std::string_view> words) const {
        Row row = *this;
        row.kind = Kind::choice;
        row.choices = words;
        return row;
    }
};

/// The row of this name, otherwise of the quantity with this term. @throws InternalError where there is none.
[[nodiscard]] const Row& row_named(const Description& description, std::string_view name);

/// Puts every field of a result, in order.
void put(const void* result, const Description& description, Sink& sink);

}  // namespace setae::fields
