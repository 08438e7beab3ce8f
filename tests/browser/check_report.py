#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks at reports in a headless Chromium: nothing on the console, nothing asked of the network, every control by keyboard, tables that sort
and copy, figures that switch and save what they show, no accessibility finding of weight. Exit code 77: no Chromium."""

import argparse
import csv
import io
import json
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from devtools import Browser  # noqa: E402
from npm import AXE, script  # noqa: E402

HOSTILE = "</script><script>alert(1)</script>\"'&~/"

failures = []


def check(true, message):
    if not true:
        failures.append(message)
        print("FAILED:", message)


def axe_source(cache):
    """axe-core, kept in the build tree; None without network."""
    try:
        return script(AXE, cache)
    except OSError as error:
        print(f"axe-core cannot be fetched ({error}): accessibility rules are not checked")
        return None


def draw_all(page):
    page.run("(async () => { for (const s of document.querySelectorAll('section.figure')) { s.scrollIntoView(); await new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r))); } scrollTo(0, 0); })()")
    page.frames(3)


def unfold(page):
    page.run("for (const fold of document.querySelectorAll('main details:not(.data)')) fold.open = true")
    page.frames(2)


def tutorial_page(program, output):
    """The report of the tutorial's study, made where and as the tutorial says: a report names its study as it was called, so that the length
    of this checkout's path would change its height."""
    folder = os.path.join(output, "mine")
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([program, "lab", "make", "examples/tutorial/recipe.toml", "-o", folder], check=True, stdout=subprocess.DEVNULL)
    with open("docs/start/from-files-to-the-figure.md", encoding="utf-8") as file:
        study = re.search(r"```toml file=mine/adhesion.toml\n(.*?)```", file.read(), re.DOTALL).group(1)
    with open(os.path.join(folder, "adhesion.toml"), "w", encoding="utf-8") as file:
        file.write(study)
    subprocess.run([os.path.abspath(program), "study", "mine/adhesion.toml", "--no-figures", "--no-cache", "--progress", "none"], cwd=output, check=True, stdout=subprocess.DEVNULL)
    return os.path.join(folder, "adhesion_results", "report.html")


def check_height(page, path, name):
    """The answer and its figures within a few screens; the rest waits in folds."""
    page.open(path)
    draw_all(page)
    height = page.run("document.documentElement.scrollHeight")
    print(f"{name}: {height} px high at 1366 px")
    check(height <= 6000, f"{name}: {height} px high before anything is unfolded, expected at most 6000")
    check(page.run("document.querySelectorAll('main details[open]').length") == 0, f"{name}: something is unfolded to begin with")


def check_parts(page, path, name):
    """Each identifier once, each link with its target, and links, keys and a button that unfold."""
    page.open(path)
    twice = page.run("[...document.querySelectorAll('[id]')].map(e => e.id).filter((id, i, all) => all.indexOf(id) !== i)")
    check(not twice, f"{name}: stand twice: {twice}")
    lost = page.run("[...document.querySelectorAll('a[href^=\"#\"]')].map(a => decodeURIComponent(a.getAttribute('href').slice(1))).filter(id => !document.getElementById(id))")
    check(not lost, f"{name}: links lead nowhere: {lost}")
    shown = lambda part: page.run(f"document.querySelector('{part}').checkVisibility()")  # noqa: E731
    check(not shown("#table-fits table"), f"{name}: tables are not folded")
    page.run("location.hash = '#table-fits'")
    page.frames(3)
    check(shown("#table-fits table"), f"{name}: a link does not unfold its table")
    page.run("document.querySelector('#table-fits summary').focus()")
    page.enter()
    page.frames(2)
    check(not shown("#table-fits table"), f"{name}: Enter does not fold a table")
    page.run("document.getElementById('unfold').focus()")
    page.enter()
    page.frames(2)
    check(page.run("[...document.querySelectorAll('main details:not(.data)')].every(d => d.open)"), f"{name}: the button does not unfold everything")


def quiet(page, name):
    check(not page.console, f"{name}: the console says {page.console[:3]}")
    others = [url for url in page.requests if not url.startswith(("file:", "data:", "blob:"))]
    check(not others, f"{name}: asks for {others[:3]}")


def check_layout(page, path, name):
    for width, height in ((1366, 768), (683, 384), (390, 700)):  # 683 is 1366 at 200 %
        page.resize(width, height)
        page.open(path)
        draw_all(page)
        for _ in range(2):  # folded, then unfolded
            check(page.run("document.documentElement.scrollWidth <= innerWidth"), f"{name}: wider than the window at {width} px: " + str(page.run(
                "[...document.querySelectorAll('main *')].filter(e => e.getBoundingClientRect().right > innerWidth && !e.closest('.scroll')).slice(0, 3).map(e => e.outerHTML.slice(0, 120))")))
            unfold(page)
            draw_all(page)
        quiet(page, f"{name} at {width} px")
    page.resize(1366, 768)
    levels = page.run("[...document.querySelectorAll('h1,h2,h3,h4')].map(h => Number(h.tagName[1]))")
    check(levels[0] == 1 and levels.count(1) == 1 and all(b <= a + 1 for a, b in zip(levels, levels[1:])), f"{name}: headings in the order {levels}")


def check_axe(page, source, name):
    page.run(source)
    found = page.run("axe.run(document, {resultTypes: ['violations']}).then(r => r.violations.map(v => [v.impact, v.id, v.nodes.length, v.nodes[0].html.slice(0, 160)]))")
    heavy = [v for v in found if v[0] in ("serious", "critical")]
    print(f"{name}: axe-core finds {len(found)} ({', '.join(v[1] for v in found) or 'nothing'}), {len(heavy)} serious or critical")
    check(not heavy, f"{name}: axe-core finds {heavy}")


def check_keyboard(page, name):
    page.run("scrollTo(0, 0); document.activeElement.blur(); for (const e of document.querySelectorAll('a[href],button:not([disabled]),summary,[tabindex=\"0\"]')) e.dataset.wanted = ''")
    wanted = page.run("[...document.querySelectorAll('[data-wanted]')].filter(e => e.checkVisibility()).length")
    for _ in range(wanted + 5):
        page.tab()
        page.run("delete document.activeElement.dataset.wanted")
    missed = page.run("[...document.querySelectorAll('[data-wanted]')].filter(e => e.checkVisibility()).map(e => e.outerHTML.slice(0, 120))")
    print(f"{name}: {wanted} controls, {wanted - len(missed)} reached by Tab")
    check(not missed, f"{name}: not reached by Tab: {missed[:3]}")


def check_tables(page, study):
    head = "document.querySelector('#table-surfaces th:nth-child(3)')"
    values = "[...document.querySelectorAll('#table-surfaces tbody tr td:nth-child(3) [data-part=value]')].map(s => Number(s.dataset.value))"
    before = page.run(values)
    for direction, order in (("ascending", sorted(before)), ("descending", sorted(before, reverse=True))):
        page.run(head + ".querySelector('button').focus()")
        page.enter()
        check(page.run(head + ".getAttribute('aria-sort')") == direction, f"sorting by Enter does not say {direction}")
        check(page.run(values) == order, f"rows are not {direction}")
    page.run(head.replace("3", "1") + ".querySelector('button').click()")
    names = page.run("[...document.querySelectorAll('#table-surfaces tbody tr td:first-child')].map(c => c.textContent)")
    check(names == sorted(names), f"names are not in order: {names}")
    page.run("document.querySelector('#table-surfaces button.copy').focus()")
    page.enter()
    page.until("document.querySelector('#table-surfaces .notice').textContent !== ''")
    said = page.run("document.querySelector('#table-surfaces .notice').textContent")
    check(said.startswith("Copied"), f"copying says '{said}'")
    lines = [line.split("\t") for line in page.run("navigator.clipboard.readText()").splitlines()]
    check(all(len(line) == len(lines[0]) for line in lines), "copied rows differ in length")
    check("h_rms [m]" in lines[0] and "h_rms standard_error [m]" in lines[0] and "h_rms interval_high [m]" in lines[0], f"copied columns are {lines[0]}")
    for line in lines[1:]:
        row = dict(zip(lines[0], line))
        height = study["surfaces"][row["surface"]]["rms_height"]
        check(float(row["h_rms [m]"]) == height["value"] and float(row["h_rms interval_high [m]"]) == height["interval"]["upper"], f"{row['surface']}: copied {row}")
    # without a clipboard the text is selected
    page.run("navigator.clipboard.writeText = () => Promise.reject(new Error('refused')); document.querySelector('#table-surfaces button.copy').click()")
    check(page.until("getSelection().toString().includes('PUNCD')"), "without a clipboard nothing is selected")
    page.run("getSelection().removeAllRanges()")


PREFIX = {"f": 1e-15, "p": 1e-12, "n": 1e-9, "µ": 1e-6, "m": 1e-3, "k": 1e3, "M": 1e6, "G": 1e9}
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹−", "-0123456789-")


def factor(unit):
    """SI value of a unit as a header shows it: 1e-3 of "mJ m⁻²", 1e9 of "nm⁻¹"."""
    product = 1.0
    for part in unit.split():
        name, power = re.fullmatch(r"([^⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]*)", part).groups()
        prefix = PREFIX[name[0]] if len(name) > 1 and name != "Pa" else 1.0
        product *= prefix ** int(power.translate(RAISED) or "1")
    return product


def check_shown_numbers(page, name):
    """Each number as shown, times the unit of its column, is its full value to half its last digit."""
    cells = page.run("""[...document.querySelectorAll('main table')].flatMap(table => { const units = [...table.tHead.rows[0].cells].map(head => /\\[(.*)\\]$/.exec(head.textContent)?.[1] ?? '');
        return [...table.tBodies[0].rows].flatMap(row => [...row.cells].flatMap((cell, i) => [...cell.querySelectorAll('[data-value]')].map(span => [span.textContent, span.dataset.value, units[i], span.dataset.pointer]))); })""")
    for text, value, unit, pointer in cells:
        if text == "–" or not re.match(r"-?[0-9]", value):
            continue
        digits, _, power = text.replace("−", "-").partition("10") if text.startswith("10") and re.fullmatch("10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", text) else text.replace("−", "-").partition("×10")
        size = 10.0 ** int(power.translate(RAISED) or "0")
        number = float(digits or "1") * size
        last = size * 10.0 ** -len(digits.partition(".")[2]) if "×" not in text and digits else abs(number) * 1e-3
        check(abs(number - float(value) / factor(unit)) <= 0.5001 * last + 1e-12 * abs(number), f"{name}: {pointer} is {value}, shown as {text} {unit}")
    print(f"{name}: {len(cells)} numbers in tables are their full values, rounded")
    check(cells, f"{name}: no numbers")


def plots(number):
    return f"document.querySelectorAll('#figure-{number} .plot')"


def press(page, number, action):
    page.run(f"document.querySelector('#figure-{number} .tools [data-action={action}]').focus()")
    page.enter()
    page.frames(2)


def check_figures(page):
    kinds = lambda name, number=1: page.run(f"[...{plots(number)}].map(p => p.layout.{name}axis.type)")  # noqa: E731
    check(kinds("x") == ["log", "linear"] and kinds("y") == ["log", "linear"], f"axes are {kinds('x')}, {kinds('y')}")
    press(page, 1, "y")
    check(kinds("y") == ["linear", "linear"], "log y does not switch")
    check(page.run("document.querySelector('#figure-1 [data-action=y]').getAttribute('aria-pressed')") == "false", "log y does not say so")
    press(page, 1, "y")
    press(page, 1, "x")
    check(kinds("x") == ["linear", "linear"] and kinds("y") == ["log", "linear"], "log x does not switch")
    press(page, 1, "x")
    press(page, 1, "legend")
    check(page.run("document.querySelector('#figure-1 .legend').checkVisibility()") is False, "the legend does not go")
    press(page, 1, "legend")
    names = lambda: page.run(f"{plots(1)}[0].data.map(t => t.name)")  # noqa: E731
    before = names()
    page.run("document.querySelectorAll('#figure-1 .legend button')[0].focus()")
    page.enter()
    check(len(names()) < len(before) and "band" not in names(), f"a legend entry does not switch its series: {names()}")
    page.enter()
    check(names() == before, "a legend entry does not switch its series back")
    lines = lambda: page.run(f"[2, 3].map(p => {plots(2)}[p].data.map(t => t.name))")  # noqa: E731
    both = [["measurement 0", "measurement 1"]] * 2
    check(lines() == both, f"measurements are {lines()}")
    page.run("[...document.querySelectorAll('#figure-2 .legend button')].find(b => b.textContent === 'stylus').focus()")
    page.enter()
    check(lines() == [["measurement 1"]] * 2, f"an entry that stands for others does not switch them in both panels: {lines()}")
    page.enter()
    check(lines() == both, "an entry that stands for others does not switch them back")
    ticks = page.run(f"[...{plots(2)}[2].querySelectorAll('.ytick text')].map(t => t.textContent)")
    check(set(ticks) == {"0.2", "0.3", "0.5", "0.7"}, f"a logarithmic axis within a decade says {ticks}")
    page.run(f"Plotly.relayout({plots(1)}[1], {{'yaxis.range': [10, 11]}}).then(() => 0)")
    press(page, 1, "reset")
    check(page.run(f"{plots(1)}[1].layout.yaxis.range") == [0, 60], "the whole view does not come back")
    hover = page.run(f"{plots(1)}[1].data[0].hovertext")
    check(hover[1].startswith("<b>pairs</b><br>second, with a comma<br>predicted <i>W</i><sub>app</sub> = 20 [18, 22] mJ m⁻²<br>measured"), f"the pointer reads {hover[1]}")
    check(hover[2].split("<br>")[1] == "&lt;b&gt;third&lt;/b&gt;", f"a name is taken for markup: {hover[2]}")

    figure = json.loads(page.run("document.querySelector('#figure-1 .figure-data').textContent"))
    press(page, 1, "csv")
    rows = list(csv.DictReader(io.StringIO(page.downloaded("figure_1.csv"))))
    expected = [(panel["title"], s["label"], panel["x"]["quantity"], panel["x"]["unit"], i, s) for panel in figure["panels"] for s in panel["series"] for i in range(len(s["x"]))]
    check(len(rows) == len(expected), f"CSV has {len(rows)} rows, the figure {len(expected)} points")
    number = lambda text: None if text == "" else float(text)  # noqa: E731
    for row, (title, label, quantity, unit, i, series) in zip(rows, expected):
        same = (row["panel"], row["series"], row["x quantity"], row["x unit"]) == (title, label, quantity, unit) and all(
            number(row[key]) == (series[key][i] if key in series else None) for key in ("x", "y", "lower", "upper", "left", "right"))
        check(same and row["name"] == (series["names"][i] if "names" in series else ""), f"CSV row {row} is not point {i} of {label}")
    press(page, 2, "csv")
    maps = [row for row in csv.DictReader(io.StringIO(page.downloaded("figure_2.csv"))) if row["series"] == "map"]
    check([float(row["value"]) for row in maps] == [10.0 * i + j for i in range(6) for j in range(4)], "CSV of a map is not the map")
    page.run("const d = document.querySelector('#figure-1 details.data summary'); d.focus()")
    page.enter()
    page.frames(3)
    check(page.run("document.querySelector('#figure-1 details.data pre').textContent.split('\\n').length") == len(expected) + 2, "the data below a figure are not its points")
    for number_of, name in ((1, "figure_1"), (2, "figure_2")):
        press(page, number_of, "svg")
        svg = page.downloaded(name + ".svg")
        check(svg.startswith("<svg") and len(re.findall(r'class="[^"]*\bsubplot\b', svg)) >= 2 and "<script" not in svg, f"{name}.svg is not whole")
    check("&lt;/script&gt;" in page.downloaded("figure_1.svg") or "</script>" not in page.downloaded("figure_1.svg"), "a name is taken for markup in SVG")
    check(page.run("document.querySelector('#figure-S5').textContent").find("Not drawn: no experiment has a contact radius.") >= 0, "the reason is not shown")
    check(page.run(f"{plots(1)}[0].getAttribute('role') === 'img' && {plots(1)}[0].getAttribute('aria-label').includes('What <is> drawn.')"), "a plot has no words")


def check_print(page, path, output):
    page.open(path)
    page.paper(os.path.join(output, "published.pdf"))
    drawn = page.run("[...document.querySelectorAll('section.figure .plots')].every(p => p.querySelector('.main-svg'))")
    check(drawn, "figures are missing on paper")
    check(page.run("document.querySelectorAll('main details[open]').length") == 0, "what was folded stays unfolded after printing")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("pages", "setae", "cache", "output"):
        parser.add_argument("--" + name, required=True)
    options = parser.parse_args()
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if not chromium:
        print("skipped: no Chromium; apt-get install chromium")
        return 77
    subprocess.run([options.pages, options.output], check=True)
    path = lambda name: os.path.join(options.output, name + ".html")  # noqa: E731
    axe = axe_source(options.cache)
    page = Browser(chromium)
    try:
        for name in ("published", "hostile", "many", "empty"):
            seconds = page.open(path(name))
            print(f"{name}: {os.path.getsize(path(name)) / 1e6:.1f} MB, loaded in {seconds:.2f} s")
            check(os.path.getsize(path(name)) <= 8e6, f"{name} is larger than 8 MB")
            check_layout(page, path(name), name)
            page.open(path(name))
            draw_all(page)
            page.picture(os.path.join(options.output, name + ".png"))
            if axe:
                check_axe(page, axe, name)
                unfold(page)
                draw_all(page)
                check_axe(page, axe, name + ", unfolded")
        tutorial = tutorial_page(options.setae, options.output)
        for name, file in (("published", path("published")), ("tutorial", tutorial)):
            check_height(page, file, name)
            check_parts(page, file, name)
        page.open(path("published"))
        unfold(page)
        study = json.loads(page.run("document.getElementById('study').textContent"))
        check_shown_numbers(page, "published")
        check_tables(page, study)
        draw_all(page)
        check_keyboard(page, "published")
        quiet(page, "published")
        page.open(path("hostile"))
        unfold(page)
        check(page.run("document.title") == HOSTILE, "a hostile title is changed")
        check(page.run("document.querySelectorAll('script').length") == page.run("document.querySelectorAll('script[type]').length") + 2, "a name became a script")
        draw_all(page)
        check_figures(page)
        check_keyboard(page, "hostile")
        quiet(page, "hostile")
        page.open(path("many"))
        draw_all(page)
        drag = page.run(f"""(async () => {{ const plot = {plots("spectra_many")}[0]; const times = [];
            for (let i = 0; i < 10; ++i) {{ const start = performance.now(); await Plotly.relayout(plot, {{'xaxis.range': [4 + 0.1 * i, 9 + 0.05 * i]}}); await new Promise(requestAnimationFrame); times.push(performance.now() - start); }}
            return times.sort((a, b) => a - b)[5]; }})()""")
        print(f"sixty spectra of 600 points: {drag:.0f} ms a frame while their range moves")
        quiet(page, "many")
        check_print(page, path("published"), options.output)
    finally:
        page.close()
    print(f"{len(failures)} failures" if failures else "all is well")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
