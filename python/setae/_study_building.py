# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies: study files, and studies that are built in Python."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from . import _setae
from ._errors import InvalidArgument
from ._given import TableLike
from ._options import MAPPINGS, Path, Text, path
from ._scan import Scan, is_one
from ._spectra import Spectrum
from ._study import StudyResult
from ._study_file import is_keys, write_study


class Study:
    """A study: a file that was read by :func:`study`, or a study that is built from measurements, loops and numbers.

    Every method that adds something returns a new study. Keywords are the keys of a study file (docs/reference/study-keys.md). Where a study
    file names a file, a path is relative to the current folder, and content in memory is accepted, too: scans and arrays with a size, spectra,
    loops and tables. :meth:`to_toml` writes the study; :meth:`run` writes it into the folder of the results and runs this file.

    Parameters
    ----------
    title : str
        title of the report; default: name of the file
    description : str
        free text
    work_of_adhesion : str or Quantity
        W_int for predictions, such as "37.0 ± 3.7 mJ/m2"; default: the fitted W_int

    Examples
    --------
    >>> import setae
    >>> wafer = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="80 nm", rms_height="5 nm", size="5 um", pixels=128).scan
    >>> study = (
    ...     setae.Study(title="One pair")
    ...     .rough_solid(youngs_modulus="130 GPa", poisson_ratio=0.28)
    ...     .surface("wafer", [wafer], instrument="afm", tip_radius="10 nm")
    ...     .elastomer("soft", youngs_modulus="0.7 MPa", surface_energy="25 mJ/m2")
    ...     .pair("wafer", "soft", approach="40 ± 2 mJ/m2")
    ... )
    >>> study
    Study('One pair': 1 surface, 1 elastomer, 1 pair)
    """

    def __init__(
        self, *, title: str | None = None, description: str | None = None, work_of_adhesion: Text | None = None
    ) -> None:
        self._file: str | None = None
        self._content: dict[str, Any] = {}
        for name, value in (("title", title), ("description", description), ("work_of_adhesion", work_of_adhesion)):
            if value is not None:
                self._content[name] = value

    @classmethod
    def of_file(cls, file: str) -> Study:
        """A study file that is read without an error."""
        made = cls(title=_setae.title_of_study(file, MAPPINGS))
        made._file = file
        return made

    @classmethod
    def of_content(cls, content: Mapping[str, Any]) -> Study:
        """A study from a dictionary with the keys of a study file."""
        made = cls()
        made._content = copied(dict(content))
        return made

    @property
    def file(self) -> str | None:
        """Path of the study file; None for a study that is built."""
        return self._file

    @property
    def title(self) -> str:
        return str(self._content.get("title", ""))

    def _with(self, *place: str, **values: Any) -> Study:
        """A new study with values in a table; lists are continued."""
        if self._file is not None:
            raise InvalidArgument(f"{self._file}: a study file; edit the file, or build a study with setae.Study()")
        made = Study.of_content(self._content)
        table = made._content
        for name in place:
            table = table.setdefault(name, {})
        for name, value in values.items():
            if value is not None:
                table[name] = [*table.get(name, ()), *value] if isinstance(value, Continued) else value
        return made

    def surface(
        self,
        name: str,
        measurements: Any = None,
        *,
        power_spectrum: Any = None,
        moments: Mapping[str, Text | float] | None = None,
        description: str | None = None,
        **shared: Any,
    ) -> Study:
        """Adds a rough surface.

        Parameters
        ----------
        name : str
            name of the surface
        measurements : scan, path, array with a size, or a list of them
            measurements of the surface; also dictionaries with the keys of a measurement, or one spectrum
        power_spectrum : path, spectrum or table
            spectrum in place of measurements: a file, a result of :func:`power_spectrum`, or columns of q and C1D or C_iso with units
        moments : Mapping[str, str or Quantity]
            published moments in place of measurements: rms_height, rms_slope, rms_curvature, short_wavevector
        description : str
            free text
        **shared
            keys of measurements, such as instrument="afm", for all measurements that do not state their own

        Examples
        --------
        >>> import setae
        >>> setae.Study().surface("A", ["afm_1.spm", "afm_2.spm"], instrument="afm", tip_radius="10 ± 2 nm")
        Study('': 1 surface, 0 elastomers, 0 pairs)
        """
        if is_spectrum(measurements):
            measurements, power_spectrum = None, measurements
        listed = [] if measurements is None else [measurements] if is_one(measurements) else list(measurements)
        given = {"power_spectrum": power_spectrum, "moments": moments, "description": description}
        if listed:
            given["measurements"] = [entry if is_keys(entry) else {"file": entry} for entry in listed]
            given["shared"] = shared
        elif shared:
            raise TypeError(f"{', '.join(shared)}: keys of measurements; expected measurements of the surface '{name}'")
        return self._with("surfaces", name, **given)

    def rough_solid(self, *, youngs_modulus: Text, poisson_ratio: float) -> Study:
        """States the rough, hard body of all surfaces, such as youngs_modulus="1100 GPa", poisson_ratio=0.06."""
        return self._with("rough_solid", youngs_modulus=youngs_modulus, poisson_ratio=poisson_ratio)

    def elastomer(
        self,
        name: str,
        *,
        surface_energy: Text,
        youngs_modulus: Text | None = None,
        poisson_ratio: float | None = None,
        sphere_radius: Text | None = None,
        **keys: Any,
    ) -> Study:
        """Adds a soft solid.

        Parameters
        ----------
        name : str
            name of the elastomer
        surface_energy : str or Quantity
            surface energy γ1, such as "25 ± 5 mJ/m2"
        youngs_modulus : str or Quantity
            Young's modulus, such as "0.69 ± 0.02 MPa"; default: the mean of the loops on this elastomer
        poisson_ratio : float
            Poisson ratio; default: 0.5
        sphere_radius : str or Quantity
            radius of curvature of the lens, such as "1.25 mm"
        **keys
            further keys of an elastomer, such as preload="1 mN"

        Examples
        --------
        >>> import setae
        >>> setae.Study().elastomer("soft", youngs_modulus="0.7 MPa", surface_energy="25 mJ/m2", preload="1 mN")
        Study('': 0 surfaces, 1 elastomer, 0 pairs)
        """
        given = {"youngs_modulus": youngs_modulus, "poisson_ratio": poisson_ratio, "surface_energy": surface_energy, "sphere_radius": sphere_radius}
        return self._with("elastomers", name, **given, **keys)

    def pair(self, surface: str, elastomer: str, loops: Any = None, **keys: Any) -> Study:
        """Adds loops of an elastomer on a surface, or published values of the pair.

        Parameters
        ----------
        surface : str
            name of the surface
        elastomer : str
            name of the elastomer
        loops : loop, path, table or a list of them
            measured loops: results of :func:`loop`, files, or tables in memory
        **keys
            keys of an experiment for all these loops, such as sphere_radius="1.25 mm"; without loops published values: approach, pull_off,
            retraction (J/m²), loss (J), contact_radius (m), such as approach="41 ± 1 mJ/m2"

        Examples
        --------
        >>> import setae
        >>> setae.Study().pair("A", "soft", ["loop_1.csv", "loop_2.csv"], drift="linear").pair("A", "stiff", approach="41 ± 1 mJ/m2")
        Study('': 0 surfaces, 0 elastomers, 2 pairs)
        """
        if loops is None:
            return self._published(surface, elastomer, keys)
        return self._loops({"surface": surface, "elastomer": elastomer}, loops, keys)

    def reference(self, elastomer: str, loops: Any = None, *, stage: str | None = None, **keys: Any) -> Study:
        """Adds loops of an elastomer on a smooth reference, measured "before" or "after" the rough loops (stage), or published values of it.

        Examples
        --------
        >>> import setae
        >>> setae.Study().reference("soft", "smooth.csv", stage="before")
        Study('': 0 surfaces, 0 elastomers, 0 pairs, 1 reference)
        """
        if loops is None:
            return self._published(None, elastomer, keys)
        return self._loops({"role": "reference", "elastomer": elastomer, "stage": stage}, loops, keys)

    def pairs(self, table: TableLike) -> Study:
        """Adds published values of many pairs from a table with the columns "surface", "elastomer", and values with units.

        Columns of values are approach, pull_off, retraction, loss or contact_radius; columns such as "approach standard_error" or
        "approach_standard_error" contain their standard errors. Rows without a surface are smooth references.

        Examples
        --------
        >>> import setae
        >>> values = {"surface": ["A", "B"], "elastomer": ["soft", "soft"], "approach [mJ/m2]": [41.4, 30.1], "approach_standard_error": [0.9, 1.2]}
        >>> setae.Study().pairs(values)
        Study('': 0 surfaces, 0 elastomers, 2 pairs)
        """
        made = self
        for surface, elastomer, values in pairs_of(table):
            made = made._published(surface, elastomer, values)
        return made

    def _loops(self, of: Mapping[str, Any], loops: Any, keys: Mapping[str, Any]) -> Study:
        several = isinstance(loops, (list, tuple))
        return self._with(experiments=Continued({**of, "file": loop, **keys} for loop in (loops if several else [loops])))

    def _published(self, surface: str | None, elastomer: str, values: Mapping[str, Any]) -> Study:
        unknown = [name for name in values if name not in PUBLISHED]
        if unknown or not values:
            raise InvalidArgument(f"{', '.join(unknown) or 'no value'} of {surface or 'a reference'} and {elastomer}; expected loops, or published "
                                  f"values of {', '.join(PUBLISHED)}")
        return self._with(published_pairs=Continued([{"surface": surface, "elastomer": elastomer, **values}]))

    def analysis(self, **keys: Any) -> Study:
        """Sets keys of the analysis of spectra, such as longest_wavelength="100 um"."""
        return self._with("analysis", **keys)

    def loops(self, **keys: Any) -> Study:
        """Sets keys of the analysis of all loops, such as models=["jkr"]."""
        return self._with("loops", **keys)

    def comparison(self, **keys: Any) -> Study:
        """Sets keys of the comparison of repeated loops, such as margin="5 mJ/m2"."""
        return self._with("comparison", **keys)

    def inputs(self, **values: Text) -> Study:
        """Names values with an error that several keys share, such as lens="1.25 ± 0.01 mm"; keys then contain the name."""
        return self._with("inputs", **values)

    def costs(self, **durations: Text) -> Study:
        """States durations of further measurements, such as loop="0.5 h"."""
        return self._with("costs", **durations)

    def reported(self, fit: str, **values: Any) -> Study:
        """States reported results of a fit, "modified", "persson_tosatti" or "loop", such as work_of_adhesion="37 ± 4 mJ/m2"."""
        return self._with("reported", fit, **values)

    def to_toml(self, file: Path) -> Study:
        """Writes a study file, with content in memory in the folder NAME_data beside it; returns the study of this file.

        Paths in the file are relative to the file. The results of the file have the bytes of the results of :meth:`run`.

        Raises
        ------
        FormatError
            for an unknown key, a missing or wrong unit, a name that is not declared, with the line in the file
        """
        if self._file is not None:
            raise InvalidArgument(f"{self._file}: a study file; copy the file")
        return Study.of_file(write_study(file, study_keys(self._content)))

    def run(self, *, output: Path | None = None, cache: Path | None = None, keep: bool = True) -> StudyResult:
        """Runs the study. Earlier results come from the cache, which the program shares; ``keep=False`` uses no cache.

        A study that is built is written as study.toml into the folder ``output``, by default "study_results", because its results name the
        study file and its inputs.
        """
        if self._file is None:
            target = pathlib.Path(output if output is not None else self._content.get("output", "study_results"))
            return self.to_toml(target / "study.toml").run(output=target, cache=cache, keep=keep)
        folder = (path(cache) if cache is not None else "") if keep else None
        return StudyResult.of(self._file, "" if output is None else path(output), folder)

    def __repr__(self) -> str:
        if self._file is not None:
            return f"Study({self._file!r}: {self.title!r})"
        pairs = [*self._content.get("experiments", ()), *self._content.get("published_pairs", ())]
        on_surfaces = {(entry["surface"], entry["elastomer"]) for entry in pairs if entry.get("surface")}
        references = sum(not entry.get("surface") for entry in pairs)
        counted = [counts(len(self._content.get("surfaces", ())), "surface"), counts(len(self._content.get("elastomers", ())), "elastomer"),
                   counts(len(on_surfaces), "pair")] + ([counts(references, "reference")] if references else [])
        return f"Study({self.title!r}: {', '.join(counted)})"


#: Published values of a pair.
PUBLISHED = ("approach", "pull_off", "retraction", "loss", "contact_radius")


class Continued(list[dict[str, Any]]):
    """Entries that continue a list of a study."""


def counts(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def copied(content: Any) -> Any:
    """Dictionaries and lists that are new; their values are those given."""
    if is_keys(content):
        return {str(name): copied(value) for name, value in content.items()}
    return [copied(entry) for entry in content] if isinstance(content, list) else content


def is_spectrum(value: Any) -> bool:
    """True for a spectrum in memory."""
    return isinstance(value, Spectrum)


def study_keys(content: Mapping[str, Any]) -> dict[str, Any]:
    """The content of a study by the keys of a study file: shared keys in each measurement, published values in rows of surfaces."""
    keys: dict[str, Any] = copied(content)
    for surface in keys.get("surfaces", {}).values():
        shared = surface.pop("shared", {})
        if shared:
            surface["measurements"] = [{**shared, **stated(entry)} for entry in surface["measurements"]]
    published = keys.pop("published_pairs", ())
    if published:
        keys["published"] = rows_of(published)
    return keys


def stated(entry: Mapping[str, Any]) -> dict[str, Any]:
    """The keys of a measurement that it states itself, with those of its scan."""
    scan = entry["file"]
    names = ("instrument", "tip_radius", "resolution", "trend") if isinstance(scan, Scan) else ()
    return {**{name: getattr(scan, name) for name in names if getattr(scan, name)}, **entry}


def rows_of(published: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Values of pairs as rows of surfaces with one value per elastomer."""
    elastomers = list(dict.fromkeys(entry["elastomer"] for entry in published))
    by_pair = {(entry["surface"], entry["elastomer"]): entry for entry in published}
    table: dict[str, Any] = {"elastomers": elastomers}
    for name in PUBLISHED:
        for surface in dict.fromkeys(entry["surface"] for entry in published if name in entry):
            values = [by_pair.get((surface, elastomer), {}).get(name) for elastomer in elastomers]
            missing = [elastomer for elastomer, value in zip(elastomers, values) if value is None]
            if missing:
                raise InvalidArgument(f"{name} of {surface or 'the reference'} lacks {', '.join(missing)}; expected a value for every elastomer with "
                                      "published values")
            row, place = (table.setdefault("reference", {}), name) if surface is None else (table.setdefault(name, {}), surface)
            row[place] = values
    return table


def pairs_of(table: TableLike) -> Iterator[tuple[str | None, str, dict[str, str]]]:
    """Surface, elastomer and published values of every row of a table."""
    from ._tables import table_of

    found = table_of(table)
    names = {found.header(name): name for name in found.columns}
    values = {header.partition("[")[0].strip(): (name, header.partition("[")[2].rstrip("] ")) for header, name in names.items()}
    for required in ("surface", "elastomer"):
        if required not in values:
            raise InvalidArgument(f"no column '{required}'; the columns are {', '.join(found.columns)}")
    for row in range(len(found.columns[values["elastomer"][0]])):
        entry = {}
        for quantity in PUBLISHED:
            value, unit = cell_of(found.columns, values, quantity, row)
            if value is None:
                continue
            if not unit:
                raise InvalidArgument(f"column '{quantity}' has no unit; expected one, as in '{quantity} [mJ/m2]'")
            errors = [cell_of(found.columns, values, f"{quantity}{word}", row) for word in (" standard_error", "_standard_error")]
            error = next((text for text, _ in errors if text is not None), None)
            entry[quantity] = f"{value} ± {error} {unit}" if error is not None else f"{value} {unit}"
        surface, _ = cell_of(found.columns, values, "surface", row)
        elastomer, _ = cell_of(found.columns, values, "elastomer", row)
        yield surface, str(elastomer), entry


def cell_of(columns: Mapping[str, Any], values: Mapping[str, tuple[str, str]], quantity: str, row: int) -> tuple[str | None, str]:
    """The text of a cell and the unit of its column; None for a missing value."""
    from ._tables import cell

    if quantity not in values:
        return None, ""
    name, unit = values[quantity]
    value = columns[name][row]
    return cell(value.item() if hasattr(value, "item") else value) or None, unit


def study(file: Path | Mapping[str, Any]) -> Study:
    """Reads a study file, or takes a dictionary with its keys. Errors in a file are raised with the line number.

    In a dictionary, paths are relative to the current folder, and content in memory takes the place of files, as in :class:`Study`.

    Parameters
    ----------
    file : str or path or Mapping[str, object]
        path of a study file, or a dictionary with the keys of a study file

    Returns
    -------
    Study
        a study that runs, or that is continued

    Raises
    ------
    FormatError
        for an unknown key, a missing or wrong unit, a name that is not declared
    FileError
        for a path that cannot be read

    Examples
    --------
    >>> import setae
    >>> setae.study({"title": "From a dictionary", "surfaces": {"A": {"measurements": [{"file": "afm.spm", "instrument": "afm"}]}}})
    Study('From a dictionary': 1 surface, 0 elastomers, 0 pairs)
    """
    return Study.of_content(file) if isinstance(file, Mapping) else Study.of_file(os.fspath(file))
