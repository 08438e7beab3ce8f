# SPDX-License-Identifier: GPL-3.0-or-later
"""A user at a terminal: an empty folder, `setae` on the path, and a count of what was typed."""
import contextlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile


class Terminal:
    def __init__(self, folder):
        self.folder = folder
        self.typed = 0

    def types(self, line):
        """What one command prints; it must succeed."""
        self.typed += 1
        print(f"$ {line}", flush=True)
        done = subprocess.run(["bash", "-c", line], cwd=self.folder, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def reads(self, line):
        """What one command prints as JSON."""
        return json.loads(self.types(line + " --json"))


@contextlib.contextmanager
def terminal():
    """A terminal for the program named on the command line; its folder goes when the story ends."""
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "bin").mkdir()
        (folder / "bin/setae").symlink_to(program)
        os.environ["PATH"] = f"{folder}/bin:{os.environ['PATH']}"
        os.environ["SETAE_CACHE"] = f"{folder}/cache"
        yield Terminal(folder)


def require(condition, message):
    if not condition:
        sys.exit(f"the story ends badly: {message}")


def require_close(found, expected, tolerance, what):
    """tolerance is relative."""
    require(abs(found - expected) <= tolerance * abs(expected), f"{what}: {found!r}, expected {expected!r} within {tolerance}")
