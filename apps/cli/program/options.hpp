// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "setae/core/units.hpp"
#include "setae/fields/option.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace setae::cli {

/// A command line and what it does.
struct Example {
    std::string command, what;
};

/// What verbs say of themselves beyond what CLI11 keeps.
struct Declarations {
    std::map<const CLI::Option*, std::vector<std::string>> choices;  ///< words of options that take one of them
    std::map<const CLI::App*, std::vector<Example>> examples;
};

/// What else is said of an option when it is declared. What the command line gives against it is refused when it is
/// parsed.
class Option {
public:
    Option(CLI::Option& option, Declarations& declared) : option_(&option), declared_(&declared) {}

    /// One of these words; the help lists them in place of the kind of value.
    Option& one_of(const std::vector<std::string>& words);
    /// The same where the description says which.
    Option& one_of_unlisted(const std::vector<std::string>& words);
    /// Words that shells offer; others may be taken, too.
    Option& offering(const std::vector<std::string>& words);
    /// A text that `read` takes: what it throws as InvalidArgument is what is wrong with it.
    Option& read_by(const std::function<void(const std::string&)>& read);
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
    /// A whole number from 0 that 64 bits hold.
    Option& natural();
    /// A text that is a quantity, with its standard error or without. usual_unit: what a number alone is told to have,
    /// where it is another than that of its dimension.
    Option& quantity(const Expected& expected, const std::string& usual_unit = {});
    /// Its values name files that are read: no output of the run replaces one.
    Option& of_inputs();
    /// What the help calls its value.
    Option& value_named(const std::string& name);
    /// The value it has now is shown in the help.
    Option& default_shown();

private:
    CLI::Option* option_;
    Declarations* declared_;
};

/// Options and positional arguments of a verb, in the order of its help. Values are written when the command line is
/// parsed and must outlive that.
class Options {
public:
    Options(CLI::App& verb, Declarations& declared) : verb_(verb), declared_(declared) {}

    /// "--json"; true where it is named.
    Option flag(const std::string& names, bool& value, const std::string& description);
    /// "-o,--output", or "files" for what has no dash. Values are text, whole or real numbers, one that may be missing
    /// (std::optional) or several (std::vector).
    template <class Value>
    Option add(const std::string& names, Value& value, const std::string& description);

    /// All options of a request, as fields::Asked describes them.
    template <class Request>
    void ask(Request& request) {
        ask(fields::Asked<Request>::options, &request);
    }
    void ask(std::span<const fields::Option> asked, void* request);

    /// A command line for the verb's help and the manual, and what it does.
    void example(const std::string& command, const std::string& what);

private:
    CLI::App& verb_;
    Declarations& declared_;
};

}  // namespace setae::cli
