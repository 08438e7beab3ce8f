// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/units.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace setae::cli {

/// What else is said of an option when it is declared. What the command line gives against it is refused when it is
/// parsed.
class Option {
public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    /// One of these words; the help lists them in place of the kind of value.
    Option& one_of(const std::vector<std::string>& words);
    /// The same where the description says which.
    Option& one_of_unlisted(const std::vector<std::string>& words);
    Option& between(int least, int greatest);
    Option& between(double least, double greatest);
    Option& positive();
    Option& required();
    Option& excludes(const Option& other);
    /// Several values in one word, as in "12,17".
    Option& separated_by(char separator);
    /// A value each time it is named, so that what follows that is a file.
    Option& one_at_a_time();
    /// A number within a domain.
    Option& within(const Domain& domain);
    /// A text that is a quantity, with its standard error or without.
    Option& quantity(const Expected& expected);
    /// Its values name files that are read: no output of the run replaces one.
    Option& of_inputs();
    /// What the help calls its value.
    Option& value_named(const std::string& name);
    /// The value it has now is shown in the help.
    Option& default_shown();

private:
    CLI::Option* option_;
};

/// Options and positional arguments of a verb, in the order of its help. Values are written when the command line is
/// parsed and must outlive that.
class Options {
public:
    explicit Options(CLI::App& verb) : verb_(verb) {}

    /// "--json"; true where it is named.
    Option flag(const std::string& names, bool& value, const std::string& description);
    /// "-o,--output", or "files" for what has no dash. Values are text, whole or real numbers, one that may be missing
    /// (std::optional) or several (std::vector).
    template <class Value>
    Option add(const std::string& names, Value& value, const std::string& description);

private:
    CLI::App& verb_;
};

}  // namespace setae::cli
