// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"
#include "request.hpp"
#include "setae/core/error_parts.hpp"

namespace setae::python {
namespace {

/// Name of the Python class of an error in setae._errors.
const char* class_of(const Error& error) {
    if (dynamic_cast<const InvalidArgument*>(&error)) return "InvalidArgument";
    if (dynamic_cast<const FileError*>(&error)) return "FileError";
    if (dynamic_cast<const FormatError*>(&error)) return "FormatError";
    if (dynamic_cast<const UndefinedDataError*>(&error)) return "UndefinedDataError";
    if (dynamic_cast<const InternalError*>(&error)) return "InternalError";
    return "Error";
}

template <class T>
nb::object or_none(const std::optional<T>& value) {
    return value ? nb::cast(*value) : nb::none();
}

nb::object or_none(const std::string& text) { return text.empty() ? nb::none() : nb::cast(text); }

/// An option as a keyword: `name`, or name="value".
std::string as_keyword(std::string_view name, std::string_view value) {
    if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789") != name.npos)
        return {};
    const auto found = keywords().find(name);
    const std::string keyword(found == keywords().end() ? name : std::string_view(found->second));
    return value.empty() ? "`" + keyword + "`" : keyword + "=\"" + std::string(value) + "\"";
}

void raise(const Error& error) {
    const std::string name = class_of(error);
    const auto message = fields::spelled(error.what(), as_keyword);
    const auto parts = error_parts(message, name == "FileError" || name == "FormatError");
    const auto type = nb::module_::import_("setae._errors").attr(name.c_str());
    const nb::object raised = type(nb::str(message.c_str()));
    raised.attr("file") = or_none(parts.file);
    raised.attr("line") = or_none(parts.position.line);
    raised.attr("offset") = or_none(parts.position.offset);
    raised.attr("got") = or_none(parts.got);
    raised.attr("expected") = or_none(parts.expected);
    PyErr_SetObject(type.ptr(), raised.ptr());
}

void translate(const std::exception_ptr& thrown, void*) {
    try {
        std::rethrow_exception(thrown);
    } catch (const Interrupted&) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
    } catch (const Error& error) {
        raise(error);
    }
}

}  // namespace

std::map<std::string, std::string, std::less<>>& keywords() {
    static std::map<std::string, std::string, std::less<>> names;
    return names;
}

void bind_errors(nb::module_&) { nb::register_exception_translator(translate); }

}  // namespace setae::python
