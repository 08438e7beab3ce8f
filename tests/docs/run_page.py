#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_page.py SETAE PAGE: types what a page tells its readers to type, from top to bottom, in an empty folder.

`setae` is on the path and examples/ beside. What the fences of a page mean:

    ```sh                   each line is a command; the first that fails ends the run
    ```toml file=NAME       is written to NAME (of any language)
    ```python               is run as a notebook would, all blocks in one session; with needs=numpy it is left out where that is missing
    ```text printed         is what the block before it printed
    ```text screen          likewise, and it fits a terminal of 40 lines of 100 characters
    ![…](…/NAME.svg)        is a picture that a command made under the same name

--expect FILE    this file must be there at the end (repeated)
--numbers        every decimal number of the text stands in a command, a file or a printed block of the page
--write          takes over what is printed and drawn now, instead of comparing it
"""
import argparse
import contextlib
import difflib
import importlib.util
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import traceback

SCREEN_LINES, SCREEN_COLUMNS = 40, 100
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]+\.svg)\)")
DECIMAL = re.compile(r"(?<![\w.])\d+\.\d+(?!\w|\.\d)")


class Failure(Exception):
    """What the page says is not what happens."""


class Block:
    """A stretch of a page between two fences, or of text between two of them (language is then empty)."""

    def __init__(self, line, fence):
        words = fence[3:].split()
        self.line, self.fence = line, fence
        self.language = words[0] if words else ""
        self.screen = "screen" in words
        self.shows = self.screen or "printed" in words
        self.settings = dict(word.split("=", 1) for word in words if "=" in word)
        self.lines = []

    @property
    def text(self):
        return "".join(line + "\n" for line in self.lines)


def blocks_of(page):
    """Blocks in order; text is a block with an empty fence."""
    blocks = [Block(1, "")]
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("```"):
            blocks.append(Block(number, line if not blocks[-1].fence else ""))
        else:
            blocks[-1].lines.append(line)
    return blocks


class Session:
    """One reader at one terminal with one notebook, in the working folder."""

    def __init__(self, folder, page):
        self.folder, self.page = folder, page
        self.names = {"__name__": "__main__"}
        self.printed = None  # by the last block that was run, None if it was left out

    def run_commands(self, block):
        self.printed = ""
        for command in filter(None, block.lines):
            print(f"$ {command}", flush=True)
            done = subprocess.run(["bash", "-c", command], capture_output=True, text=True)
            if done.returncode != 0:
                raise Failure(f"failed with exit code {done.returncode}\n{done.stdout}{done.stderr}")
            self.printed += done.stdout

    def run_python(self, block):
        missing = [name for name in block.settings.get("needs", "").split(",") if name and not importlib.util.find_spec(name)]
        if missing:
            print(f"left out: the block at line {block.line}: no module {', '.join(missing)}")
            self.printed = None
            return
        print(f">>> block at line {block.line}", flush=True)
        output = io.StringIO()
        # empty lines in front, so that messages name lines of the page
        code = compile("\n" * block.line + block.text, self.page, "exec")
        with contextlib.redirect_stdout(output):
            exec(code, self.names)
        self.printed = output.getvalue()


def compare(block, session):
    """The block shows what was printed, a screen no more than fits one."""
    if block.text != session.printed:
        difference = difflib.unified_diff(block.lines, session.printed.splitlines(), "shown", "printed", lineterm="")
        raise Failure("\n".join([f"line {block.line} is not what is printed:", *difference]))
    if block.screen and (len(block.lines) > SCREEN_LINES or max(map(len, block.lines), default=0) > SCREEN_COLUMNS):
        raise Failure(f"line {block.line}: more than a screen of {SCREEN_LINES} lines of {SCREEN_COLUMNS} characters")


def run(blocks, session, write):
    for block in blocks:
        if "file" in block.settings:
            path = session.folder / block.settings["file"]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block.text, encoding="utf-8")
        elif block.language == "sh":
            session.run_commands(block)
        elif block.language == "python":
            session.run_python(block)
        elif block.shows and session.printed is not None:
            if write:
                block.lines = session.printed.splitlines()
            compare(block, session)


def pictures(page, blocks, folder, write):
    for block in blocks:
        for target in PICTURE.findall(block.text if not block.fence else ""):
            made = sorted(folder.rglob(pathlib.Path(target).name))
            if not made:
                raise Failure(f"no command makes {target}")
            if write:
                shutil.copyfile(made[0], page.parent / target)


def numbers_stand_printed(blocks):
    """Numbers of the text cannot differ from those of commands and output."""
    shown = "\n".join(block.text for block in blocks if block.fence)
    for block in blocks:
        for number in DECIMAL.findall(block.text if not block.fence else ""):
            if number not in shown:
                raise Failure(f"the text below line {block.line} says {number}, which no command prints")


def joined(blocks):
    """The page as it is written."""
    text = blocks[0].text
    for block in blocks[1:]:
        text += (block.fence or "```") + "\n" + block.text
    return text


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--expect", action="append", default=[])
    parser.add_argument("--numbers", action="store_true")
    parser.add_argument("--write", action="store_true")
    return parser.parse_args()


def main():
    given = arguments()
    sources, page = pathlib.Path.cwd(), given.page.resolve()
    blocks = blocks_of(page)
    if not any(block.language in ("sh", "python") for block in blocks):
        raise Failure(f"no command found in {page}")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "bin").mkdir()
        (folder / "bin/setae").symlink_to(given.program.resolve())
        (folder / "examples").symlink_to(sources / "examples")
        os.environ["PATH"] = f"{folder}/bin:{os.environ['PATH']}"
        os.environ["SETAE_CACHE"] = f"{folder}/cache"
        os.chdir(folder)
        try:
            run(blocks, Session(folder, page), given.write)
            for file in given.expect:
                if not os.path.isfile(file) or os.path.getsize(file) == 0:
                    raise Failure(f"missing: {file}")
            pictures(page, blocks, folder, given.write)
            if given.numbers:
                numbers_stand_printed(blocks)
        finally:
            os.chdir(sources)
    if given.write:
        page.write_text(joined(blocks), encoding="utf-8")


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(f"{failure}\nwhere the page is behind the program: tests/docs/run_page.py SETAE PAGE --write")
    except Exception:  # a snippet's own error: where, then what
        traceback.print_exc()
        sys.exit(1)
