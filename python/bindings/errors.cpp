// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"
#include "setae/core/error_parts.hpp"

namespace setae::python {
namespace {

/// The class of Python for an error, by its name in setae._errors.
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

void raise(const Error& error) {
    const std::string name = class_of(error);
    const auto parts = error_parts(error.what(), name == "FileError" || name == "FormatError");
    const auto type = nb::module_::import_("setae._errors").attr(name.c_str());
    const nb::object raised = type(nb::str(error.what()));
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

void bind_errors(nb::module_&) { nb::register_exception_translator(translate); }

}  // namespace setae::python
