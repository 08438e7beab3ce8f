#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""test_order.py RESULTS: the tests that take longest, for ctest to begin with; writes tests/order/costs.cmake.

RESULTS is what `ctest --output-junit` wrote. A long test that begins last keeps one core busy and the others waiting. The costs are seconds
on the machine that wrote them: only their order matters.
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

LONG = 0.7  # s


def main():
    cases = [(float(case.get("time")), case.get("name")) for case in ElementTree.parse(sys.argv[1]).getroot().iter("testcase")]
    lines = ["# SPDX-License-Identifier: GPL-3.0-or-later", "# Written by tools/test_order.py."]
    for seconds, name in sorted((case for case in cases if case[0] >= LONG), key=lambda case: (-case[0], case[1])):
        lines.append(f'set_tests_properties("{name}" PROPERTIES COST {seconds:.0f})')
    target = pathlib.Path(__file__).resolve().parent.parent / "tests/order/costs.cmake"
    target.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
