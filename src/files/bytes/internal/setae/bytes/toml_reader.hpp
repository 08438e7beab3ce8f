// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "setae/core/units.hpp"

namespace setae::bytes {

/// A TOML file as a table.
/// @throws FileError; FormatError with the line for text that is no TOML.
[[nodiscard]] toml::table parse_toml_file(const std::string& path);

/// Named inputs of a file, which several keys can refer to.
struct NamedInputs {
    struct Named {
        std::string text;  ///< value, ± and unit as in the file
        toml::source_position place;
        bool used = false;
    };
    std::map<std::string, Named> inputs;
};

/// A key with a doubtful but valid value.
struct KeyWarning {
    std::string place;  ///< "study.toml:12"
    std::string key;    ///< "elastomers.soft.surface_energy"
    std::string text;
};

/// A TOML table that records the keys that were read, so finish() finds misspelt ones; every error contains file and
/// line.
class TomlReader {
public:
    TomlReader(const toml::table& table, std::string path, std::string where);

    [[nodiscard]] std::optional<std::string> text(const char* key);
    [[nodiscard]] std::string required_text(const char* key);
    [[nodiscard]] std::optional<double> number(const char* key, const Domain& domain = domain::finite);
    [[nodiscard]] std::optional<std::int64_t> integer(const char* key);
    [[nodiscard]] std::optional<bool> boolean(const char* key);
    /// The value of one of a closed set of words. @throws FormatError that lists the words.
    template <class Value>
    [[nodiscard]] std::optional<Value> choice(const char* key,
                                              const std::vector<std::pair<std::string, Value>>& choices) {
        const auto word = text(key);
        if (!word) return std::nullopt;
        std::string words;
        for (const auto& [name, value] : choices) {
            if (name == *word) return value;
            words += (words.empty() ? "" : ", ") + name;
        }
        fail(key, "'" + *word + "', expected one of " + words);
    }
    /// "37 mJ/m2"; a plain number only for a dimensionless quantity.
    [[nodiscard]] std::optional<double> quantity(const char* key, const Expected& expected);
    /// "37 ± 3.7 mJ/m2"; after name_inputs() also "NAME" or "NAME = 37 ± 3.7 mJ/m2". Estimate::input is that name,
    /// otherwise for uncertain values the table and the key.
    [[nodiscard]] std::optional<Estimate> uncertain(const char* key, const Expected& expected);
    [[nodiscard]] Estimate required_uncertain(const char* key, const Expected& expected);
    [[nodiscard]] std::vector<std::string> texts(const char* key);
    [[nodiscard]] std::vector<double> quantities(const char* key, const Expected& expected);
    [[nodiscard]] std::vector<Estimate> uncertains(const char* key, const Expected& expected);
    [[nodiscard]] bool contains(const char* key) const;
    [[nodiscard]] bool is_number(const char* key) const;
    [[nodiscard]] bool is_list(const char* key) const;
    [[nodiscard]] bool is_table(const char* key) const;
    /// Reads the texts of the table under a key, NAME = "VALUE", as inputs that all later tables can refer to by name.
    void name_inputs(const char* key);
    /// @throws FormatError at the first named input without a reference.
    void require_inputs_used() const;
    /// Calls body with the table under a key, if there is one.
    void table(const char* key, const std::function<void(TomlReader)>& body);
    /// Calls body(name, table) for each table under a key: [key.NAME].
    void named_tables(const char* key, const std::function<void(const std::string&, TomlReader)>& body);
    /// Calls body for each table of an array: [[key]].
    void each_table(const char* key, const std::function<void(TomlReader)>& body);

    /// A path in the file, relative to the folder of the file unless absolute.
    [[nodiscard]] std::string resolved_path(const std::string& path) const;

    /// Keys of this table, in the order of the file.
    [[nodiscard]] std::vector<std::string> keys() const;

    /// @throws FormatError at the first unknown key, with the nearest known one.
    void finish() const;

    /// @throws FormatError at the key (or the table if the key is missing).
    [[noreturn]] void fail(const char* key, const std::string& what) const;

    /// Records a warning on a key of this table, in the order of the calls.
    void warn(const char* key, std::string text);
    /// Warnings of all readers of the document.
    [[nodiscard]] const std::vector<KeyWarning>& warnings() const { return *warnings_; }

private:
    [[nodiscard]] std::string without_zero_byte(const char* key, const std::string& text) const;
    const toml::node* find(const char* key);
    template <class Value>
    std::vector<Value> list(const char* key, const std::function<Value(const toml::node&)>& convert);
    Estimate parse(const char* key, const toml::node& node, const Expected& expected) const;
    Estimate parse_text(const char* key, const toml::node& node, const Expected& expected) const;
    Estimate named(const std::string& name, const std::string& value, const toml::node& node,
                   const Expected& expected) const;
    [[nodiscard]] TomlReader inner(const toml::table& table, std::string where) const;

    const toml::table* table_;
    std::string path_;
    std::string where_;
    std::set<std::string> known_;
    std::shared_ptr<NamedInputs> named_;
    std::shared_ptr<std::vector<KeyWarning>> warnings_;
};

}  // namespace setae::bytes
