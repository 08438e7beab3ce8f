# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers with unit, standard error and source. They calculate: units by pint, correlated errors by uncertainties."""

from __future__ import annotations

import html
import math
import operator
import re
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from functools import cache, cached_property
from numbers import Real
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from . import _setae
from ._errors import InvalidArgument
from ._names import SINCE, renamed
from ._units import SI_UNITS, described, factor, have_one_dimension, kind_of, pint_unit, plain_unit, product, registry, shown_unit, si_unit, unit_of_pint

if TYPE_CHECKING:
    from typing_extensions import Self

Json = Any
PROPAGATED = "linear propagation of standard errors"


class PintQuantity(Protocol):
    """A quantity of the package pint, of any registry."""

    @property
    def magnitude(self) -> Any: ...
    @property
    def units(self) -> Any: ...


class UncertainNumber(Protocol):
    """A number of the package uncertainties."""

    @property
    def nominal_value(self) -> Any: ...
    @property
    def std_dev(self) -> Any: ...


def number(value: Json) -> float:
    """A number of JSON: null is NaN, infinity is a text."""
    if value is None:
        return math.nan
    return float(value)


@dataclass(frozen=True)
class Interval:
    """Ends of an interval at its confidence level, in the unit of its quantity."""

    lower: float
    upper: float
    level: float = 0.95


@dataclass(frozen=True)
class Band:
    """Range of wavevectors that a number depends on [1/m]."""

    lower: float
    upper: float


@dataclass(frozen=True)
class Alert:
    """A warning about a number: code, subject, message and action."""

    code: str
    subject: str
    message: str
    action: str

    def __str__(self) -> str:
        return f"{self.code}: {self.subject}: {self.message}" + (f"; {self.action}" if self.action else "")


class SharedErrors(Protocol):
    """The errors of the quantities of one result."""

    def of(self, quantity: Quantity) -> Any: ...


@dataclass(frozen=True, eq=False, repr=False)
class Quantity:
    """A number with unit, standard error and source. ``float()`` gives its value in its unit.

    Quantities calculate with numbers, quantities of pint, numbers of uncertainties and functions of NumPy. Errors that two quantities share
    stay shared: those of one quantity used twice, of parameters of one fit, and of inputs with one name (``input``). Sums keep the unit of
    the first term, products are in SI.

    Attributes
    ----------
    quantity, symbol : str
        name and symbol
    value : float
        value in ``unit``; results of setae are in SI
    unit : str
        unit such as "J/m2", "1/m", "1"
    standard_error : float
        NaN if it is unknown, 0 for an exact value
    interval : Interval
        interval at its own level, usually 95 %
    method : str
        how standard error and interval were found
    band : Band
        wavevectors that the number depends on
    n : int
        number of measurements, points or pairs
    source : str
        formula with reference
    input_name : str
        name of an input: quantities with one name have one error

    Examples
    --------
    >>> import setae
    >>> E = setae.Quantity("youngs_modulus", "E", 0.7e6, "Pa", standard_error=0.02e6)
    >>> print(E, float(E), E.to("MPa"), f"{E.to('kPa'):.1f}")
    700 ± 20 kPa 700000.0 0.700 ± 0.020 MPa 700.0 ± 20.0 kPa
    >>> W = setae.quantity("37.0 ± 3.7 mJ/m2")
    >>> W / E, W - W, W > setae.quantity("30 mJ/m2")
    (52.9 ± 5.5 nm, 0 mJ/m², True)
    """

    quantity: str
    symbol: str
    value: float
    unit: str
    standard_error: float = math.nan
    interval: Interval | None = None
    method: str = ""
    degrees_of_freedom: float | None = None
    seed: int | None = None
    band: Band | None = None
    n: int | None = None
    source: str = ""
    alerts: tuple[Alert, ...] = ()
    input_name: str = ""

    def to(self, unit: str) -> Quantity:
        """The quantity in another unit of its dimension.

        >>> quantity("12 ± 1 nm").to("um").value
        0.012
        """
        scale, unit = factor(self.unit, unit), plain_unit(unit)
        between = self.interval and Interval(scale * self.interval.lower, scale * self.interval.upper, self.interval.level)
        made = replace(self, value=scale * self.value, unit=unit, standard_error=scale * self.standard_error, interval=between)
        made.__dict__["_scaled"] = (scale, self)
        return made

    @cached_property
    def _uncertain(self) -> Any:
        """Value and error for calculations: a number of uncertainties, or a float for an exact value."""
        if self.standard_error == 0.0:
            return self.value
        if "_scaled" in self.__dict__:
            scale, whole = self.__dict__["_scaled"]
            return scale * whole._uncertain
        if self.input_name:
            return self.value + self.standard_error * error_of_input(self.input_name)
        shared: SharedErrors | None = self.__dict__.get("_shared")
        found = None if shared is None else shared.of(self)
        return uncertain(self.value, self.standard_error) if found is None else found

    def _in_si(self) -> float:
        return self.value if self.unit in SI_UNITS else self.value * factor(self.unit, si_unit(self.unit))

    def __getstate__(self) -> dict[str, Any]:
        kept = [entry.name for entry in fields(self)] + ["_uncertain"]
        return {name: self.__dict__[name] for name in kept if name in self.__dict__}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self

    # texts

    def __float__(self) -> float:
        return float(self.value)

    def __str__(self) -> str:
        return shown_unit(_setae.format_uncertain(self.value, self.standard_error, self.unit))

    __repr__ = __str__

    def __format__(self, spec: str) -> str:
        """Value and standard error in a format of numbers, with the unit: f"{q:.3f}"; other formats apply to the text.

        >>> W = Quantity("work_of_adhesion", "W", 37.8, "mJ/m2", 3.7)
        >>> f"{W:.2f}", f"{W:>20}", f"{quantity('0.5'):.1%}"
        ('37.80 ± 3.70 mJ/m²', '    37.8 ± 3.7 mJ/m²', '50.0%')
        """
        if not re.search(r"\.\d+|[eEfFgGn%]$", spec):
            return format(str(self), spec)
        has_error = self.standard_error > 0.0
        error = f" ± {format(self.standard_error, re.sub(r'^(.?[<>=^])?[-+ ]?0?[0-9]*', '', spec))}" if has_error else ""
        return f"{format(float(self.value), spec)}{error}" + ("" if self.unit == "1" else f" {shown_unit(self.unit)}")

    def to_html(self) -> str:
        """The number with ± and interval as in the report of a study."""
        between = (self.interval.lower, self.interval.upper, self.interval.level) if self.interval else None
        error = self.standard_error if self.standard_error > 0.0 else math.nan
        return _setae.quantity_html(self.value, error, self.unit, between)

    def _repr_html_(self) -> str:
        return f"<i>{html.escape(self.symbol)}</i> = {self.to_html()}" if self.symbol else self.to_html()

    # other packages

    def to_uncertainties(self) -> Any:
        """As number of the package uncertainties, in the unit of the quantity. Calls return the same variable, whose errors are correlated."""
        from uncertainties import ufloat

        if self.standard_error != 0.0:
            return self._uncertain
        with warnings.catch_warnings():  # a number without error is unusual there
            warnings.simplefilter("ignore")
            return ufloat(self.value, 0.0)

    def to_pint(self) -> Any:
        """As a measurement of the package pint, with the error of ``to_uncertainties()``."""
        return registry().Measurement(self.to_uncertainties(), pint_unit(self.unit))

    # arithmetic

    def __add__(self, other: Any) -> Quantity:
        return sum_of(self, other, operator.add)

    def __radd__(self, other: Any) -> Quantity:
        return sum_of(other, self, operator.add)

    def __sub__(self, other: Any) -> Quantity:
        return sum_of(self, other, operator.sub)

    def __rsub__(self, other: Any) -> Quantity:
        return sum_of(other, self, operator.sub)

    def __mul__(self, other: Any) -> Quantity:
        return product_of(self, other, operator.mul)

    def __rmul__(self, other: Any) -> Quantity:
        return product_of(other, self, operator.mul)

    def __truediv__(self, other: Any) -> Quantity:
        return product_of(self, other, operator.truediv)

    def __rtruediv__(self, other: Any) -> Quantity:
        return product_of(other, self, operator.truediv)

    def __pow__(self, exponent: Any) -> Quantity:
        return power_of(self, exponent)

    def __rpow__(self, base: Any) -> Quantity:
        return power_of(base, self)

    def __neg__(self) -> Quantity:
        return made(-self._uncertain, self.unit, self)

    def __pos__(self) -> Quantity:
        return self

    def __abs__(self) -> Quantity:
        return -self if self.value < 0.0 else self

    # comparison, by value

    def __eq__(self, other: object) -> bool:
        found = operand(other)
        if found is None:
            return NotImplemented
        if is_zero(other):
            return self.value == 0.0
        return have_one_dimension(self.unit, found.unit) and compared(self, found, operator.eq)

    def __hash__(self) -> int:
        return hash(rounded(self._in_si()))

    def __lt__(self, other: Any) -> bool:
        return compared(self, other, operator.lt)

    def __le__(self, other: Any) -> bool:
        return compared(self, other, operator.le)

    def __gt__(self, other: Any) -> bool:
        return compared(self, other, operator.gt)

    def __ge__(self, other: Any) -> bool:
        return compared(self, other, operator.ge)

    # NumPy

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        """Functions of NumPy. With an array the result is an array of quantities."""
        function = FUNCTIONS.get(ufunc.__name__)
        if function is None or method != "__call__" or options:
            return NotImplemented
        def of_elements(*elements: Any) -> Any:
            # numbers of NumPy would call NumPy again
            return function(*(element.item() if isinstance(element, np.generic) else element for element in elements))

        if any(isinstance(value, np.ndarray) and value.ndim > 0 for value in inputs):
            return np.frompyfunc(of_elements, len(inputs), 1)(*(np.asarray(value, dtype=object) for value in inputs))
        return of_elements(*inputs)

    @property
    def input(self) -> str:
        """Former name of ``input_name``."""
        warnings.warn(f"input: deprecated since setae {SINCE}; use input_name", DeprecationWarning, stacklevel=2)
        return self.input_name


Quantity.__init__ = renamed(input="input_name")(Quantity.__init__)  # type: ignore[method-assign]


def uncertain(value: float, error: float) -> Any:
    from uncertainties import ufloat

    return ufloat(value, error)


@cache
def error_of_input(name: str) -> Any:
    """The error of an input, with a standard deviation of 1; the same in every result that is read from a pickle."""
    from uncertainties.core import Variable

    class InputError(Variable):  # type: ignore[misc]
        def __reduce__(self) -> Any:
            return error_of_input, (name,)

    return InputError(0.0, 1.0, tag=name)


def made(result: Any, unit: str, *operands: Quantity) -> Quantity:
    """The result of a calculation."""
    value, error = (result.nominal_value, result.std_dev) if hasattr(result, "std_dev") else (result, 0.0)
    alerts = dict.fromkeys(alert for quantity in operands for alert in quantity.alerts)
    found = Quantity("", "", float(value), unit, float(error), method=PROPAGATED, alerts=tuple(alerts))
    found.__dict__["_uncertain"] = result
    return found


def of_other_package(value: Any) -> Quantity | None:
    """A quantity of pint or a number of uncertainties as a quantity; None for other values and for arrays."""
    unit = "1"
    if hasattr(value, "magnitude") and hasattr(value, "to_base_units"):
        unit = unit_of_pint(value.units)
        if not kind_of(unit):
            value = value.to_base_units()
            unit = unit_of_pint(value.units)
        value = value.magnitude
    elif not hasattr(value, "nominal_value"):
        return None
    if hasattr(value, "nominal_value"):
        found = Quantity("", "", float(value.nominal_value), unit, float(value.std_dev))
        found.__dict__["_uncertain"] = value
        return found
    return Quantity("", "", float(value), unit, 0.0) if np.ndim(value) == 0 else None


def operand(value: Any) -> Quantity | None:
    """A term or factor as a quantity; None for a value that is none."""
    if isinstance(value, Quantity):
        return value
    if isinstance(value, Real) and not isinstance(value, bool):
        return Quantity("", "", float(value), "1", 0.0)
    return of_other_package(value)


def is_zero(value: Any) -> bool:
    """True for the number 0, which is 0 in every unit."""
    return isinstance(value, Real) and value == 0


def sum_of(a: Any, b: Any, operation: Callable[[Any, Any], Any]) -> Quantity:
    first, second = operand(a), operand(b)
    if first is None or second is None:
        return NotImplemented  # type: ignore[no-any-return]
    if is_zero(b):
        return first
    if is_zero(a):
        return second if operation is operator.add else -second
    return made(operation(first._uncertain, second.to(first.unit)._uncertain), first.unit, first, second)


def product_of(a: Any, b: Any, operation: Callable[[Any, Any], Any]) -> Quantity:
    first, second = operand(a), operand(b)
    if first is None or second is None:
        return NotImplemented  # type: ignore[no-any-return]
    power = Fraction(1 if operation is operator.mul else -1)
    if second.unit == "1":
        unit, scale = first.unit, 1.0
    elif first.unit == "1" and power > 0:
        unit, scale = second.unit, 1.0
    elif first.unit == second.unit and power < 0:
        unit, scale = "1", 1.0
    else:
        unit, scale = product(((first.unit, Fraction(1)), (second.unit, power)))
    result = operation(first._uncertain, second._uncertain)
    return made(result if scale == 1.0 else scale * result, unit, first, second)


def power_of(base: Any, exponent: Any) -> Quantity:
    first, second = operand(base), operand(exponent)
    if first is None or second is None:
        return NotImplemented  # type: ignore[no-any-return]
    if second.unit != "1":
        raise InvalidArgument(f"an exponent of {described(second.unit)}; expected a number without unit")
    if first.unit == "1":
        return made(first._uncertain**second._uncertain, "1", first, second)
    if second.standard_error > 0.0:
        raise InvalidArgument(f"a power of {described(first.unit)} with an uncertain exponent; expected an exact exponent")
    unit, scale = product(((first.unit, Fraction(second.value).limit_denominator(60)),))
    return made(scale * first._uncertain**second.value, unit, first)


def compared(a: Quantity, b: Any, operation: Callable[[float, float], bool]) -> bool:
    other = operand(b)
    if other is None:
        return NotImplemented  # type: ignore[no-any-return]
    if is_zero(b) or a.unit == other.unit:
        return operation(rounded(a.value), rounded(other.value))
    if not have_one_dimension(a.unit, other.unit):
        factor(other.unit, a.unit)  # raises
    return operation(rounded(a._in_si()), rounded(other._in_si()))


def rounded(value: float) -> float:
    """15 digits: 1 um is 1000 nm."""
    return float(f"{value:.15g}")


def of_plain_number(name: str) -> Callable[[Any], Any]:
    """A function of uncertainties for numbers without unit."""

    def call(value: Any) -> Any:
        from uncertainties import umath

        given = operand(value)
        if given is None:
            raise TypeError(f"{name} of {type(value).__name__}; expected a number or a quantity")
        if not have_one_dimension(given.unit, "1"):
            raise InvalidArgument(f"{name} of {described(given.unit)}; expected a number without unit")
        return made(getattr(umath, name)(given.to("1")._uncertain), "1", given)

    return call


def of_value(function: Callable[[float], Any]) -> Callable[[Any], Any]:
    return lambda value: function(float(value))


#: Functions of NumPy by name, for single values.
FUNCTIONS: dict[str, Callable[..., Any]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "divide": operator.truediv,
    "true_divide": operator.truediv,
    "power": operator.pow,
    "float_power": operator.pow,
    "negative": operator.neg,
    "positive": operator.pos,
    "conjugate": operator.pos,
    "absolute": abs,
    "fabs": abs,
    "square": lambda value: value * value,
    "reciprocal": lambda value: 1.0 / value,
    "sqrt": lambda value: value**0.5,
    "cbrt": lambda value: value ** (1.0 / 3.0),
    "hypot": lambda a, b: (a * a + b * b) ** 0.5,
    "maximum": lambda a, b: a if a >= b else b,
    "minimum": lambda a, b: a if a <= b else b,
    "equal": operator.eq,
    "not_equal": operator.ne,
    "less": operator.lt,
    "less_equal": operator.le,
    "greater": operator.gt,
    "greater_equal": operator.ge,
    "sign": of_value(np.sign),
    "isfinite": of_value(math.isfinite),
    "isnan": of_value(math.isnan),
    "isinf": of_value(math.isinf),
    **{name: of_plain_number(name) for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "expm1", "log", "log10", "log1p")},
    **{f"arc{name}": of_plain_number(f"a{name}") for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh")},
}

# NumPy calls methods for functions of arrays of quantities
for name, function in FUNCTIONS.items():
    if not hasattr(Quantity, name):
        setattr(Quantity, name, function)

_NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*")
_NAME = re.compile(r"\s*([A-Za-z_]\w*)\s*=(.*)")


@renamed(input="input_name")
def quantity(
    value: str | float | Quantity | PintQuantity | UncertainNumber,
    unit: str | None = None,
    *,
    standard_error: float = 0.0,
    name: str = "",
    symbol: str = "",
    input_name: str | None = None,
) -> Quantity:
    """A quantity from a text as on paper, from a number with its unit, or from a value of pint or uncertainties.

    A value without ± is exact. "1.2 to 1.3 mm" is a range in which all values are equally probable.

    Parameters
    ----------
    value : str or float or Quantity or quantity of pint or number of uncertainties
        text such as '1.25 ± 0.01 mm' or 'lens = 1.25 ± 0.01 mm', a number, a quantity of pint, a number of uncertainties
    unit : str, optional
        unit of a number, such as 'mm'
    standard_error : float, default 0.0
        standard error of a number, in its unit
    name : str, default ''
        name of the quantity, such as 'radius'
    symbol : str, default ''
        symbol, such as 'R'
    input_name : str, optional
        name of the input; quantities with one name have one error, as under [inputs] of a study

    Returns
    -------
    Quantity
        the quantity, which calculates with its unit and error

    Raises
    ------
    InvalidArgument
        for a text that is no number with its unit, or an unknown unit
    TypeError
        for a value of another kind

    Examples
    --------
    >>> R = quantity("lens = 1.25 ± 0.01 mm")
    >>> print(R, quantity(5, "nm"), 2 * R - 2 * quantity("lens = 1.25 ± 0.01 mm"))
    1.250 ± 0.010 mm 5.000 nm 0 mm
    """
    if isinstance(value, str):
        found = quantity_of_text(value)
    else:
        given = operand(value)
        if given is None:
            raise TypeError(f"{type(value).__name__}; expected a text such as '1.25 ± 0.01 mm', a number, or a quantity")
        found = given
        if standard_error != 0.0:
            found = replace(found, standard_error=standard_error)
    if unit is not None:
        if found.unit != "1":
            raise InvalidArgument(f"a unit '{unit}' for a value in {described(found.unit)}; expected a number without unit")
        stated = replace(found, unit=plain_unit(unit))
        if "_uncertain" in found.__dict__ and standard_error == 0.0:
            stated.__dict__["_uncertain"] = found._uncertain
        found = stated
    named = {key: text for key, text in (("quantity", name), ("symbol", symbol), ("input_name", input_name)) if text}
    return relabelled(found, **named) if named else found


def relabelled(of: Quantity, **named: str) -> Quantity:
    """The quantity with another name; the error is the same unless the input is named."""
    made = replace(of, **named)  # type: ignore[arg-type]
    if "input_name" not in named:
        made.__dict__.update({key: kept for key, kept in of.__dict__.items() if key in ("_uncertain", "_shared", "_scaled")})
    return made


def quantity_of_text(text: str) -> Quantity:
    """A quantity from a text.

    >>> quantity_of_text("1.2 to 1.3 mm"), quantity_of_text("37.0 mJ/m2 +- 3.7 mJ/m2"), quantity_of_text("0.5")
    (1.250 ± 0.029 mm, 37.0 ± 3.7 mJ/m², 0.5000)
    """
    named = _NAME.fullmatch(text)
    sides = re.split(r"±|\+-|\+/-|\bto\b", named[2] if named else text)
    numbers = [_NUMBER.fullmatch(side) for side in sides]
    if len(sides) > 2 or not all(numbers):
        raise InvalidArgument(f"'{text}' is no number with its unit; expected a text such as \"1.25 ± 0.01 mm\"")
    (value, *second), (*_, unit) = [float(found[1]) for found in numbers if found], [plain_unit(found[2]) for found in numbers if found]
    own = plain_unit(numbers[0][2]) if numbers[0] and numbers[0][2] else unit
    value, error, method = value * factor(own, unit), second[0] if second else 0.0, "given"
    if len(sides) == 2 and re.search(r"\bto\b", text):
        value, error, method = 0.5 * (value + error), (error - value) / math.sqrt(12.0), "rectangular"
    if error < 0.0:
        raise InvalidArgument(f"'{text}' has an error below 0; expected a standard error of 0 or above, or a range from its smaller end")
    return Quantity("", "", value, unit, error, method=method, input_name=named[1] if named else "")


def alerts_from(entries: Json) -> tuple[Alert, ...]:
    return tuple(Alert(entry["code"], entry["subject"], entry["message"], entry["action"]) for entry in entries)


def quantity_from(entry: Mapping[str, Json], shared: SharedErrors | None = None) -> Quantity:
    """A quantity from the JSON of the program."""
    interval, band = entry.get("interval"), entry.get("band")
    found = Quantity(
        quantity=entry["quantity"],
        symbol=entry["symbol"],
        value=number(entry["value"]),
        unit=entry["unit"],
        standard_error=number(entry.get("standard_error")),
        interval=Interval(number(interval["lower"]), number(interval["upper"]), interval["level"]) if interval else None,
        method=entry.get("method", ""),
        degrees_of_freedom=entry.get("degrees_of_freedom"),
        seed=entry.get("seed"),
        band=Band(number(band["lower"]), number(band["upper"])) if band else None,
        n=entry.get("n"),
        source=entry.get("source", ""),
        alerts=alerts_from(entry.get("alerts", ())),
    )
    if shared is not None:
        found.__dict__["_shared"] = shared
    return found


def is_quantity(entry: Json) -> bool:
    return isinstance(entry, dict) and {"quantity", "symbol", "value", "unit"} <= entry.keys()
