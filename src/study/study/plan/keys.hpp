// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "setae/bytes/toml_reader.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/study/study_keys.hpp"

namespace setae::study {

/// Runs a parser on a text, with its errors at the key's position.
template <class Parser>
void parse_at(const bytes::TomlReader& reader, const char* key, const Parser& parser) {
    try {
        parser();
    } catch (const InvalidArgument& error) {
        reader.fail(key, error.what());
    }
}

/// Adds a remark where a value is outside two limits, with the power of 1000 by which its unit may be wrong. 0 is
/// valid. @throws FormatError where a value is outside by more than 12 powers of ten.
void remark_implausible(bytes::TomlReader& reader, const char* key, double value, double lower, double upper,
                        const std::string& unit);

/// Keys of a table that describes a T: meaning of each for readers, and reading into the T.
///
/// A field is a pointer to a member of T, or a function that returns a reference into it. The value in T before reading
/// is the default for a missing key.
template <class T>
class Keys {
public:
    using Reader = bytes::TomlReader;
    using Read = std::function<void(Reader&, T&)>;

    /// True or false, a text or a list of texts, as the field is.
    template <class Field>
    Keys& add(const char* key, Field field, std::string meaning) {
        using Value = Plain<Field>;
        if constexpr (std::same_as<Value, bool>)
            return add({key, "true or false", "", untouched(field), std::move(meaning)}, [=](Reader& reader, T& of) {
                if (const auto given = reader.boolean(key)) std::invoke(field, of) = *given;
            });
        else if constexpr (std::same_as<Value, std::vector<std::string>>)
            return add({key, "list of texts", "", "", std::move(meaning)}, [=](Reader& reader, T& of) {
                if (auto given = reader.texts(key); reader.is_list(key)) std::invoke(field, of) = std::move(given);
            });
        else
            return add({key, "text", "", "", std::move(meaning)}, [=](Reader& reader, T& of) {
                if (auto given = reader.text(key)) std::invoke(field, of) = std::move(*given);
            });
    }

    /// A number, or a quantity with its unit; with its standard error, or a list of them, as the field is.
    template <class Field>
    Keys& add(const char* key, Field field, const Expected& expected, std::string meaning) {
        using Value = Plain<Field>;
        values_ = [field](T& of, const std::function<void(double)>& take) { each_value(std::invoke(field, of), take); };
        const bool plain = expected.dimension == dimension::none;
        const auto within =
            std::isinf(expected.domain.lower) ? std::string() : " " + std::string(expected.domain.words);
        const std::string one = plain ? "number" : "quantity";
        KeyDescription described{key, one, plain ? "" : si_unit(expected.dimension), "", std::move(meaning)};
        if constexpr (std::same_as<Value, std::vector<double>>) {
            described.type = (plain ? "list of numbers" : "list of quantities") + within;
            return add(std::move(described), [=](Reader& reader, T& of) {
                if (auto given = reader.quantities(key, expected); !given.empty())
                    std::invoke(field, of) = std::move(given);
            });
        } else if constexpr (std::same_as<Value, Estimate>) {
            described.type += " ± error" + within;
            return add(std::move(described), [=](Reader& reader, T& of) {
                if (auto given = reader.uncertain(key, expected)) std::invoke(field, of) = std::move(*given);
            });
        } else {
            described.type += within;
            described.standard = untouched(field);
            return add(std::move(described), [=](Reader& reader, T& of) {
                if (const auto given = reader.quantity(key, expected)) std::invoke(field, of) = *given;
            });
        }
    }

    /// A whole number between two.
    template <class Field>
    Keys& whole(const char* key, Field field, std::int64_t least, std::int64_t most, std::string meaning) {
        return add({key, "whole number", "", untouched(field), std::move(meaning)}, [=](Reader& reader, T& of) {
            const auto given = reader.integer(key);
            if (!given) return;
            if (*given < least || *given > most)
                reader.fail(key, most == unbounded ? fmt::format("expected a number from {}", least)
                                                   : fmt::format("expected a number from {} to {}", least, most));
            std::invoke(field, of) = static_cast<Plain<Field>>(*given);
        });
    }
    static constexpr std::int64_t unbounded = std::numeric_limits<std::int64_t>::max();

    /// One of a closed set of words, each with its value.
    template <class Value, class Field>
    Keys& choice(const char* key, Field field, std::vector<std::pair<std::string, Value>> words, std::string meaning) {
        KeyDescription described{key, "", "", "", std::move(meaning)};
        const T fresh{};
        for (const auto& [word, value] : words) {
            described.type += (described.type.empty() ? "`" : ", `") + word + "`";
            if (std::invoke(field, fresh) == value) described.standard = "`" + word + "`";
        }
        return add(std::move(described), [=, words = std::move(words)](Reader& reader, T& of) {
            if (auto given = reader.choice<Value>(key, words)) std::invoke(field, of) = std::move(*given);
        });
    }

    /// Value that a parser stores in a T from a text. @throws, where it throws InvalidArgument, FormatError at the key.
    template <class Parser>
    Keys& parsed(const char* key, std::string type, Parser parser, std::string meaning) {
        return add({key, std::move(type), "", "", std::move(meaning)}, [=](Reader& reader, T& of) {
            if (const auto text = reader.text(key)) parse_at(reader, key, [&] { parser(of, *text); });
        });
    }

    /// A file, or a list of them, by the type of the field; paths are relative to the file with the key.
    template <class Field>
    Keys& file(const char* key, Field field, std::string meaning) {
        if constexpr (std::same_as<Plain<Field>, std::vector<std::string>>)
            return add({key, "list of files", "", "", std::move(meaning)}, [=](Reader& reader, T& of) {
                for (const auto& name : reader.texts(key)) std::invoke(field, of).push_back(reader.resolved_path(name));
            });
        else
            return add({key, "file", "", "", std::move(meaning)}, [=](Reader& reader, T& of) {
                if (const auto name = reader.text(key)) std::invoke(field, of) = reader.resolved_path(*name);
            });
    }

    /// A table of keys of its own.
    template <class Inner>
    Keys& table(const char* key, const Keys<Inner>& keys, std::function<void(T&, Inner)> take, std::string meaning) {
        return add({key, "table", "", "", std::move(meaning)}, [=, &keys](Reader& reader, T& of) {
            reader.table(key, [&](Reader inner) { take(of, keys.from(std::move(inner))); });
        });
    }

    Keys& add(KeyDescription description, Read read) {
        keys_.emplace_back(std::move(description), std::move(read));
        return *this;
    }

    /// The default of the key added last, in words, where its type gives none.
    Keys& by_default(std::string words) {
        keys_.back().first.standard = std::move(words);
        return *this;
    }

    /// Likely values of the key added last, in SI: another one is kept with a remark, as its unit may be wrong.
    Keys& plausible(double lower, double upper) {
        auto& [description, read] = keys_.back();
        read = [=, key = description.key, unit = description.unit, values = values_, before = std::move(read)](
                   Reader& reader, T& of) {
            before(reader, of);
            if (reader.contains(key.c_str()))
                values(of, [&](double value) { remark_implausible(reader, key.c_str(), value, lower, upper, unit); });
        };
        return *this;
    }

    /// The key added last must be there.
    Keys& required() {
        auto& [description, read] = keys_.back();
        description.standard = "required";
        read = [key = description.key, unit = description.unit,
                words = description.type == "text" || description.type == "file",
                optional = std::move(read)](Reader& reader, T& of) {
            if (!reader.contains(key.c_str()))
                reader.fail(key.c_str(), words ? "missing; expected a text"
                                               : "missing; expected a quantity in " + (unit.empty() ? "1" : unit));
            optional(reader, of);
        };
        return *this;
    }

    void read(Reader& reader, T& of) const {
        for (const auto& [description, read_key] : keys_) read_key(reader, of);
    }
    /// A table that holds nothing but these keys.
    [[nodiscard]] T from(Reader reader) const {
        T of{};
        read(reader, of);
        reader.finish();
        return of;
    }

    [[nodiscard]] std::vector<KeyDescription> descriptions() const {
        std::vector<KeyDescription> list;
        for (const auto& [description, read_key] : keys_) list.push_back(description);
        return list;
    }

private:
    template <class V>
    struct Held {
        using type = V;
    };
    template <class V>
    struct Held<std::optional<V>> {
        using type = V;
    };
    template <class Field>
    using Plain = typename Held<std::remove_cvref_t<std::invoke_result_t<Field, T&>>>::type;

    /// Calls `take` for each number of a field that holds one.
    template <class Value>
    static void each_value(const Value& value, const std::function<void(double)>& take) {
        if constexpr (std::is_arithmetic_v<Value>) take(static_cast<double>(value));
        else if constexpr (std::same_as<Value, Estimate>) take(value.value);
        else if constexpr (std::same_as<Value, std::vector<double>>)
            for (const double one : value) take(one);
        else if (value) each_value(*value, take);
    }

    /// Default value of a field, in words; empty without a default.
    template <class Field>
    static std::string untouched(Field field) {
        const T fresh{};
        const auto& value = std::invoke(field, fresh);
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::same_as<Value, bool>) return value ? "true" : "false";
        else if constexpr (std::is_arithmetic_v<Value>) return fmt::format("{}", value);
        else return "";
    }

    std::vector<std::pair<KeyDescription, Read>> keys_;
    /// visits the values of the quantity added last
    std::function<void(T&, const std::function<void(double)>&)> values_;
};

}  // namespace setae::study
