#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""skipped_tests.py RESULTS: what ctest left out, a line a reason, from the file that its --output-junit wrote.

With SETAE_NO_SKIPS=1 in the environment the exit code is 1 where a test was left out for any other reason than a missing GPU or MPI.
"""
import collections
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

ALLOWED = re.compile(r"\bno (GPU|MPI)\b")


def reason_of(case):
    """What the test said: "skipped: …", or the line behind GoogleTest's own "Skipped"."""
    if case.get("status") == "disabled":
        return "switched off; run by --gtest_also_run_disabled_tests"
    said = case.findtext("system-out") or ""
    found = re.search(r"^skipped: (.*)$", said, re.M) or re.search(r": Skipped\n(.*)$", said, re.M)
    reason = found[1].strip() if found else "no reason given"
    return re.sub(r'"?(\.\.|/)[^"; ]*/([^"/; ]+)"?', r"\2", reason)  # a file of its own is no reason of its own


def main():
    reasons = collections.defaultdict(list)
    for case in ElementTree.parse(sys.argv[1]).getroot().iter("testcase"):
        if case.get("status") in ("disabled", "notrun"):
            reasons[reason_of(case)].append(case.get("name"))
    for reason, names in sorted(reasons.items()):
        print(f"left out: {len(names)} {'test' if len(names) == 1 else 'tests'}, such as {names[0]}: {reason}")
    refused = [reason for reason in reasons if not ALLOWED.search(reason)]
    if refused and os.environ.get("SETAE_NO_SKIPS") == "1":
        print("SETAE_NO_SKIPS=1: every test must run here but those that need a GPU or MPI", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
