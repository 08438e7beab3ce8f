#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What includes what, from the sources alone.

  tools/include_graph.py worst [N]     headers of ours that cost most: their own lines times the sources that read them
  tools/include_graph.py order         every include against the order of modules in src/CMakeLists.txt, and installed headers against those that
                                       are not; fails where one is broken
  tools/include_graph.py dot           the graph of modules without detours: tools/include_graph.py dot | dot -Tsvg > docs/modules.svg
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


def sources():
    for top in ("src", "lab", "apps"):
        for path in (ROOT / top).rglob("*"):
            if path.suffix in (".cpp", ".hpp") and not {"tests", "benchmarks"} & set(path.parts):
                yield path


def module_order():
    text = (ROOT / "src/CMakeLists.txt").read_text()
    return re.search(r"foreach\(module\s+([^)]+)\)", text).group(1).split()


MODULES = sorted(module_order(), key=len, reverse=True)


def module_of(path):
    """A module of src, as "part/module"; "lab" and "apps" use them all."""
    folder = path.relative_to(ROOT).as_posix()
    return next((module for module in MODULES if folder.startswith(f"src/{module}/")), folder.partition("/")[0])


def resolver(paths):
    public = {}
    for path in paths:
        for folder in ("/include/", "/internal/"):
            _, found, name = path.as_posix().partition(folder)
            if found:
                public[name] = path

    def resolve(path, name):
        if name in public:
            return public[name]
        for folder in (path.parent, *path.parents):
            if (folder / name).is_file():
                return (folder / name).resolve()
            if folder == ROOT:
                return None
        return None

    return resolve


def includes():
    paths = list(sources())
    resolve = resolver(paths)
    graph = {}
    for path in paths:
        found = (resolve(path, name) for name in INCLUDE.findall(path.read_text()))
        graph[path] = [header for header in found if header]
    return graph


def reached(graph, path):
    seen, todo = set(), [path]
    while todo:
        for header in graph.get(todo.pop(), ()):
            if header not in seen:
                seen.add(header)
                todo.append(header)
    return seen


def worst(count):
    graph = includes()
    readers = collections.Counter()
    total = 0
    for path in graph:
        if path.suffix == ".cpp":
            headers = reached(graph, path)
            readers.update(headers)
            total += len(headers)
    lines = {path: path.read_text().count("\n") for path in graph}
    cost = sorted(readers, key=lambda h: (-readers[h] * lines[h], h))
    print(f"{sum(p.suffix == '.cpp' for p in graph)} sources read {total} headers of ours")
    print("sources  lines  header")
    for header in cost[:count]:
        print(f"{readers[header]:7d} {lines[header]:6d}  {header.relative_to(ROOT)}")


def edges():
    found = collections.Counter()
    graph = includes()
    for path, headers in graph.items():
        for header in headers:
            if module_of(path) != module_of(header):
                found[module_of(path), module_of(header)] += 1
    return graph, found


def order():
    place = {module: i for i, module in enumerate(module_order() + ["lab", "apps"])}
    graph, _ = edges()
    broken = [(path, header) for path, headers in graph.items() for header in headers
              if place[module_of(header)] > place[module_of(path)]]
    for path, header in broken:
        print(f"{path.relative_to(ROOT)}: includes {header.relative_to(ROOT)}; expected a header of '{module_of(path)}' "
              "or of a module before it in src/CMakeLists.txt", file=sys.stderr)
    inside = [(path, header) for path, headers in graph.items() for header in headers
              if "/include/setae/" in path.as_posix() and "/internal/setae/" in header.as_posix()]
    for path, header in inside:
        print(f"{path.relative_to(ROOT)}: is installed and includes {header.relative_to(ROOT)}, which is not; expected a header in include/", file=sys.stderr)
    return 1 if broken or inside else 0


def dot():
    """Each module points at those it includes and does not reach through another."""
    _, found = edges()
    below = collections.defaultdict(set)
    for upper, lower in found:
        below[upper].add(lower)

    def reach(module):
        return below[module].union(*(reach(lower) for lower in below[module]))

    print('digraph modules {\n  rankdir=BT; ranksep=0.35; nodesep=0.2; fontname="Liberation Sans"; bgcolor=white;\n'
          '  node [shape=box, style="rounded,filled", fillcolor=white, fontname="Liberation Sans", height=0.3];')
    for part in dict.fromkeys(module.partition("/")[0] for module in module_order()):
        print(f'  subgraph "cluster_{part}" {{ label="{part}"; style="rounded,filled"; color="#c9ced6"; fillcolor="#f3f5f8";')
        for module in module_order():
            if module.startswith(part + "/"):
                print(f'    "{module}" [label="{module.partition("/")[2]}"];')
        print("  }")
    for upper in sorted(below):
        for lower in sorted(below[upper] - set().union(*(reach(other) for other in below[upper]))):
            print(f'  "{upper}" -> "{lower}" [tooltip="{found[upper, lower]} includes"];')
    print("}")


def main():
    verb = sys.argv[1] if len(sys.argv) > 1 else "worst"
    if verb == "worst":
        worst(int(sys.argv[2]) if len(sys.argv) > 2 else 20)
    elif verb == "order":
        return order()
    elif verb == "dot":
        dot()
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
