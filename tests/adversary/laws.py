# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the program, and what must hold of every one of them."""
import hashlib
import json
import os
import re
import resource
import signal
import subprocess
import threading
import time
from dataclasses import dataclass
from pathlib import Path

MOST_SECONDS = 60.0
MOST_BYTES = 2 << 30
CONTROL = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]")
# of the program, of its progress, of what its command line cannot be, and of second lines
OWN_LINE = re.compile(rb"setae: |\{\"event\"|--|-\w|Run with|The following|[A-Z]?\w* ?.*(is required|not expected|requires)|\s")


@dataclass
class Outcome:
    """What a run came to."""

    command: list
    code: int
    out: bytes
    err: bytes
    seconds: float
    peak_bytes: int
    timed_out: bool = False

    def json(self):
        return json.loads(self.out)

    def says(self, text):
        return text.encode() in self.err


class Findings:
    """Laws that runs of one attack broke; an attack goes on behind them."""

    def __init__(self):
        self.texts = []

    def add(self, text):
        self.texts.append(text)


found = Findings()


def limited(file_bytes=None, processes=None):
    def apply():
        # more than any run may take: what goes beyond fails by itself and is found by its peak
        resource.setrlimit(resource.RLIMIT_AS, (16 << 30, 16 << 30))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if file_bytes is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))
        if processes is not None:
            resource.setrlimit(resource.RLIMIT_NPROC, (processes, processes))

    return apply


def run(program, *words, cwd=None, env=None, stdout=None, stdin=None, seconds=MOST_SECONDS, **limits):
    """The program with these words; its streams, its end and its largest size."""
    command = [str(program), *[w if isinstance(w, bytes) else str(w) for w in words]]
    variables = {"PATH": os.environ["PATH"], "HOME": str(cwd or "/nonexistent"), "SETAE_CACHE": str(Path(cwd or ".") / ".cache")}
    variables.update(env or {})
    variables = {k: v for k, v in variables.items() if v is not None}
    begun = time.monotonic()
    # pipes, as a limit on files holds for files that streams go into, too
    child = subprocess.Popen(command, cwd=cwd, env=variables, stdin=stdin or subprocess.DEVNULL,
                             stdout=stdout or subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=limited(**limits))
    texts = {}
    readers = [threading.Thread(target=lambda s=stream, n=name: texts.update({n: s.read()}))
               for name, stream in (("out", child.stdout), ("err", child.stderr)) if stream]
    for reader in readers:
        reader.start()
    code, peak, timed_out = waited(child, begun + seconds)
    for reader in readers:
        reader.join()
    return Outcome(command, code, texts.get("out", b""), texts.get("err", b""), time.monotonic() - begun, peak, timed_out)


DATE = {"SOURCE_DATE_EPOCH": "1700000000"}


def started(samples, work, *words):
    """A run that goes on beside others."""
    variables = {"PATH": os.environ["PATH"], "SETAE_CACHE": str(work / ".cache"), **DATE}
    return subprocess.Popen([str(samples.program), *map(str, words)], cwd=work, env=variables, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def waited(child, until):
    """Exit code (minus the signal that killed it), largest size, whether it had to be killed."""
    pause, timed_out = 0.001, False
    while True:
        process, status, used = os.wait4(child.pid, os.WNOHANG)
        if process:
            child.returncode = os.waitstatus_to_exitcode(status)
            return child.returncode, used.ru_maxrss * 1024, timed_out
        if time.monotonic() > until and not timed_out:
            timed_out = True
            child.send_signal(signal.SIGKILL)
        time.sleep(pause)
        pause = min(0.02, 1.5 * pause)


def require(condition, outcome, what):
    if condition:
        return
    shown = " ".join(w.decode(errors="replace") if isinstance(w, bytes) else w for w in outcome.command)
    found.add(f"{what}\n  command: {shown[:600]}\n  exit code {outcome.code}, {outcome.seconds:.1f} s\n"
              f"  standard error: {outcome.err[-600:]!r}")


def lawful(outcome, data=None):
    """What every run keeps to; `data` is "json" where standard output must hold it."""
    require(not outcome.timed_out, outcome, f"does not end within {MOST_SECONDS:.0f} s")
    require(outcome.peak_bytes < MOST_BYTES, outcome, f"takes {outcome.peak_bytes / 2**20:.0f} MiB")
    require(outcome.code >= 0, outcome, f"killed by signal {-outcome.code}")
    require(outcome.code in (0, 1, 2), outcome, "an exit code beyond 0, 1, 2")
    require(not outcome.says("internal error") and not outcome.says("terminate called"), outcome, "an internal error")
    require(not outcome.says("Sanitizer"), outcome, "a sanitizer speaks")
    require(outcome.code != 2 or outcome.err.strip(), outcome, "nothing done and no reason")
    for stream, name in ((outcome.out, "output"), (outcome.err, "error")):
        control = CONTROL.search(stream.replace(b"\r\n", b"\n"))
        require(not control, outcome, f"a control byte on standard {name}: {control and stream[max(0, control.start() - 20):control.end() + 20]!r}")
        try:
            stream.decode()
        except UnicodeDecodeError as failure:
            require(False, outcome, f"standard {name} is no UTF-8: {failure}")
    foreign = [line for line in outcome.err.splitlines() if line and not OWN_LINE.match(line)]
    require(not foreign, outcome, f"a library speaks for itself: {foreign[:2]}")
    if data == "json" and outcome.out.strip():
        try:
            outcome.json()
        except ValueError as failure:
            require(False, outcome, f"standard output is no JSON: {failure}")
    return outcome


def refused(outcome, *reasons):
    """Nothing was done, and the reason names what a user needs."""
    lawful(outcome)
    require(outcome.code == 2, outcome, "expected to be refused (exit code 2)")
    require(all(outcome.says(r) for r in reasons), outcome, f"the reason lacks one of {reasons}")
    return outcome


def done(outcome):
    lawful(outcome)
    require(outcome.code == 0, outcome, "expected exit code 0")
    return outcome


def digest(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def digests(folder):
    """Of every regular file below a folder, by its name in bytes."""
    root = os.fsencode(str(folder))
    values = {}
    for where, _, names in os.walk(root):
        for name in names:
            path = os.path.join(where, name)
            if os.path.isfile(path) and not os.path.islink(path):
                with open(path, "rb") as file:
                    values[os.path.relpath(path, root)] = hashlib.sha256(file.read()).hexdigest()
    return values


def no_leftovers(folder, outcome):
    parts = [p for p in digests(folder) if p.endswith(b".part")]
    require(not parts, outcome, f"leaves temporary files: {parts[:3]}")
