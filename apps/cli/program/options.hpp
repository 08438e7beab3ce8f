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

/// An example: command line and description.
struct Example {
    std::string command, what;
};

/// Where the help of a command lists an option. Options of files are described on one page, `setae help input`.
enum class OptionGroup { required, common, height_files, loop_files, output, advanced };

/// Declarations of commands that CLI11 does not store.
struct Declarations {
    std::map<const CLI::Option*, std::vector<std::string>> choices;  ///< words that an option accepts
    std::map<const CLI::Option*, OptionGroup> groups;                ///< of options that are not common ones
    std::map<const CLI::App*, std::vector<Example>> examples;
};

/// Further properties of a declared option. A value that contradicts them is refused when the command line is parsed.
class Option {
public:
    Option(CLI::Option& option, Declarations& declared) : option_(&option), declared_(&declared) {}

    /// One of these words; the help lists them in place of the kind of value.
    Option& one_of(const std::vector<std::string>& words);
    /// One of these words, for options whose description lists the words.
    Option& one_of_unlisted(const std::vector<std::string>& words);
    /// Words that shells offer; other words are accepted, too.
    Option& offering(const std::vector<std::string>& words);
    /// A text that `read` accepts. The message of its InvalidArgument is the error of the option.
    Option& read_by(const std::function<void(const std::string&)>& read);
    Option& between(int min, int max);
    Option& between(double min, double max);
    Option& positive();
    Option& required();
    /// Where the help lists it.
    Option& in(OptionGroup group);
    Option& excludes(const Option& other);
    /// Several values in one word, as in "12,17".
    Option& separated_by(char separator);
    /// One value per mention of the option, so that the next word is a file.
    Option& one_at_a_time();
    /// A number within a domain.
    Option& within(const Domain& domain);
    /// A whole number from 0 that fits into 64 bits.
    Option& natural();
    /// A quantity, with or without a standard error. usual_unit: unit in the error message for a number without unit,
    /// if it is not that of the dimension.
    Option& quantity(const Expected& expected, const std::string& usual_unit = {});
    /// The values are names of input files, which no output of the run replaces.
    Option& of_inputs();
    /// Name of the value in the help.
    Option& value_named(const std::string& name);
    /// The help shows the present value as the default.
    Option& default_shown();

private:
    CLI::Option* option_;
    Declarations* declared_;
};

/// Options and positional arguments of a command, in the order of its help. Values are written when the command line is
/// parsed and must outlive that.
class Options {
public:
    Options(CLI::App& command, Declarations& declared) : command_(command), declared_(declared) {}

    [[nodiscard]] bool has(const std::string& name) const;
    /// "--json"; true if the option is given.
    Option flag(const std::string& names, bool& value, const std::string& description);
    /// "-o,--output", or "files" for an argument. Values are text, whole or real numbers; one value that may be missing
    /// (std::optional) or several (std::vector).
    template <class Value>
    Option add(const std::string& names, Value& value, const std::string& description);
    /// The same of a file or folder that is written.
    template <class Value>
    Option output(const std::string& names, Value& value, const std::string& description) {
        return add(names, value, description).in(OptionGroup::output);
    }

    /// All options of a request, as fields::Asked describes them; the group is of those that are neither required nor
    /// advanced.
    template <class Request>
    void ask(Request& request, OptionGroup group = OptionGroup::common) {
        ask(fields::Asked<Request>::options, &request, group);
    }
    void ask(std::span<const fields::Option> asked, void* request, OptionGroup group = OptionGroup::common);

    /// A command line with its description, for the help of the command and the manual.
    void example(const std::string& command, const std::string& what);

private:
    CLI::App& command_;
    Declarations& declared_;
};

}  // namespace setae::cli
