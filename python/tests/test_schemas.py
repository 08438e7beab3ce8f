# SPDX-License-Identifier: GPL-3.0-or-later
"""The JSON of every command, and of studies, has only the names, types and units of its schema."""

from __future__ import annotations

import copy
import json
import os
import pathlib
import shlex
import subprocess
import tomllib
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import jsonschema
import pytest
import setae

from conftest import PROGRAM, ROOT

Json = Any
HERE = pathlib.Path(__file__).parent
COMMANDS = subprocess.run([PROGRAM, "schema"], capture_output=True, text=True, check=True).stdout.split("\n")[:-1]


#: Commands that no test in tests/cli runs with --json.
OTHERS = [
    "lab loops --runs 2 --snr 30 -o {0}/loops",
    "lab contours --runs 1 --size 240 --kind 'SNR 2 + overhangs' -o {0}/contours.csv",
    "lab closure tests/reference/validation/surfaces.toml --runs 1 -o {0}/closure",
    "lab causes tests/reference/validation/surfaces.toml --runs 1 -o {0}/causes",
    "lab next examples/closure/next.toml --runs 1 --measure lens_1 -o {0}/next",
    "lab make examples/tutorial/recipe.toml -o {0}/made",
    "study init {1} -o {0}/draft.toml",
    "cache",
]


def closed(schema: Json) -> Json:
    """The schema with unknown names as errors."""
    if isinstance(schema, dict):
        made = {key: closed(value) for key, value in schema.items()}
        return {**made, "additionalProperties": False} if "properties" in made and "additionalProperties" not in made else made
    return [closed(entry) for entry in schema] if isinstance(schema, list) else schema


VALIDATORS = {command: jsonschema.Draft202012Validator(closed(setae.schema(command))) for command in COMMANDS}


def command_of(words: list[str]) -> str | None:
    """The longest command at the beginning of a command line."""
    return max((command for command in COMMANDS if words[: len(command.split())] == command.split()), key=len, default=None)


def cases_with_json() -> list[tuple[pathlib.Path, str]]:
    """File and name of the tests of tests/cli with --json."""
    files = sorted((ROOT / "tests/cli").glob("*.toml"))
    return [(file, name) for file in files for name, case in tomllib.loads(file.read_text()).items() if "--json" in case["command"]]


def run_case(case: tuple[pathlib.Path, str], runner: pathlib.Path, kept: pathlib.Path) -> None:
    environment = {**os.environ, "SETAE_KEPT": str(kept), "SETAE_PROGRAM": PROGRAM}
    subprocess.run([runner, HERE / "kept_run.sh", *case], cwd=ROOT, env=environment, capture_output=True)


@pytest.fixture(scope="module")
def printed_json(tmp_path_factory: pytest.TempPathFactory, data: pathlib.Path, printed: Callable[..., str]) -> dict[str, list[Json]]:
    """JSON of the runs of tests/cli and of OTHERS by command, and study.json of two studies."""
    kept = tmp_path_factory.mktemp("kept")
    runner = pathlib.Path(PROGRAM).with_name("cli_case")
    found: dict[str, list[Json]] = {command: [] for command in COMMANDS}
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        list(threads.map(lambda case: run_case(case, runner, kept), cases_with_json()))
        others = [shlex.split(words.format(kept / "others", data)) for words in OTHERS]
        for words, text in zip(others, threads.map(lambda words: printed(*words), others)):
            found[command_of(words) or ""].append(json.loads(text))
    for words in kept.glob("????????"):
        typed, printed = words.read_text().split("\n")[:-1], pathlib.Path(f"{words}.out").read_text()
        command = command_of(typed)
        if command and "--json" in typed and printed:
            found[command].append(json.loads(printed))
    for study in (ROOT / "examples/nanodiamond/published.toml", data / "study.toml"):
        folder = kept / study.stem
        subprocess.run([PROGRAM, "study", study, "--output", folder], check=True, capture_output=True)
        found["study"].append(json.loads((folder / "study.json").read_text()))
    return found


def resolved(schema: Json, whole: Json) -> Json:
    return whole["$defs"][schema["$ref"].rpartition("/")[2]] if "$ref" in schema else schema


def wrong_units(value: Json, schema: Json, whole: Json, place: str = "") -> Iterator[str]:
    """Places of quantities and columns whose unit differs from the schema."""
    inner = resolved(schema, whole)
    for one in schema.get("anyOf", []):
        yield from wrong_units(value, one, whole, place)
    if isinstance(value, list):
        for entry in value:
            yield from wrong_units(entry, inner.get("items", {}), whole, f"{place}[]")
    if not isinstance(value, dict):
        return
    units = value.get("units", {})
    for name, entry in value.items():
        own = inner.get("properties", {}).get(name, inner.get("additionalProperties", {}))
        stated = own.get("unit")
        unit = entry.get("unit") if isinstance(entry, dict) else units.get(name)
        if stated and unit and unit != stated:
            yield f"{place}.{name}: {unit}, stated {stated}"
        yield from wrong_units(entry, own, whole, f"{place}.{name}")


@pytest.mark.parametrize("command", COMMANDS)
def test_printed_json_matches_the_schema(command: str, printed_json: dict[str, list[Json]]) -> None:
    schema = setae.schema(command)
    jsonschema.Draft202012Validator.check_schema(schema)
    assert printed_json[command], "no run has this output"
    for printed in printed_json[command]:
        errors = [f"{error.json_path}: {error.message[:200]}" for error in VALIDATORS[command].iter_errors(printed)]
        assert not errors, "\n".join(errors)
        assert not list(wrong_units(printed, schema, schema))


def quantities_in(value: Json) -> Iterator[tuple[str, str, str]]:
    """Name, symbol and unit of each quantity, without parameters of a standard: their names are those of the standard."""
    if isinstance(value, dict):
        if isinstance(value.get("quantity"), str) and {"symbol", "unit"} <= value.keys() and "filter" not in value:
            yield value["quantity"], value["symbol"], value["unit"]
        for entry in value.values():
            yield from quantities_in(entry)
    elif isinstance(value, list):
        for entry in value:
            yield from quantities_in(entry)


def with_several(pairs: Iterable[tuple[str, str]]) -> dict[str, set[str]]:
    """Names that have several symbols, or several units."""
    found: dict[str, set[str]] = {}
    for name, text in pairs:
        found.setdefault(name, set()).add(text)
    return {name: texts for name, texts in found.items() if len(texts) > 1}


def test_a_printed_quantity_has_one_symbol_and_one_unit(printed_json: dict[str, list[Json]]) -> None:
    quantities = {quantity for printed in printed_json.values() for quantity in quantities_in(printed)}
    assert len(quantities) > 100
    assert not with_several((name, symbol) for name, symbol, _ in quantities)
    schemas = [entry for command in COMMANDS for _, entry in names_in(setae.schema(command)) if isinstance(entry, dict)]
    in_units_of_data = {entry["quantity"] for entry in schemas if isinstance(entry.get("quantity"), str) and "unit" not in entry}
    assert not with_several((name, unit) for name, _, unit in quantities if name not in in_units_of_data)


def names_in(schema: Json) -> Iterator[tuple[str, Json]]:
    if isinstance(schema, dict):
        yield from schema.get("properties", {}).items()
        for entry in schema.values():
            yield from names_in(entry)
    elif isinstance(schema, list):
        for entry in schema:
            yield from names_in(entry)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_name_has_a_meaning(command: str) -> None:
    assert setae.schema(command)["description"]
    assert not [name for name, entry in names_in(setae.schema(command)) if not entry.get("description")]


def test_a_wrong_answer_is_detected(printed_json: dict[str, list[Json]]) -> None:
    wrong = copy.deepcopy(printed_json["psd"][0])
    wrong["wavevector"] = "long"
    assert not VALIDATORS["psd"].is_valid(wrong)
    assert not VALIDATORS["psd"].is_valid({**printed_json["psd"][0], "colour": 1})
    assert list(wrong_units({"C1D": [1.0], "units": {"C1D": "m4"}}, setae.schema("psd"), setae.schema("psd")))


def test_a_command_without_schema_lists_commands_with_schema() -> None:
    with pytest.raises(setae.InvalidArgument, match="contact solve"):
        setae.schema("plots")
