// SPDX-License-Identifier: GPL-3.0-or-later
// What moves in a report: tables that sort and copy, figures that Plotly draws as they come near.
(() => {
  "use strict";

  const palette = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00", "#56B4E9", "#F0E442", "#332288", "#AA4499", "#117733", "#BBAA33", "#888888"];
  const symbols = ["circle", "square", "triangle-up", "diamond", "triangle-down", "pentagon"];
  const dashes = ["solid", "9px,5px", "2px,4px", "10px,4px,2px,4px", "16px,5px", "10px,4px,2px,4px,2px,4px"];
  const font = "Liberation Sans, Arial, Helvetica, sans-serif";
  const chosen = (list, index) => list[((index % list.length) + list.length) % list.length];
  const escaped = text => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

  /// An element with attributes and children.
  function element(name, attributes, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes || {})) made.setAttribute(key, value);
    made.append(...children);
    return made;
  }

  /// Four digits, 1.234×10⁻⁷ where fixed point would be long.
  function shown(value) {
    if (!Number.isFinite(value)) return "–";
    const size = Math.abs(value);
    if (size !== 0 && (size >= 1e5 || size < 1e-3)) {
      const [digits, exponent] = value.toExponential(3).split("e");
      const raised = [...String(Number(exponent))].map(c => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join("");
      return digits.replace("-", "−") + "×10" + raised;
    }
    return String(Number(value.toPrecision(4))).replace("-", "−");
  }

  function save(name, type, text) {
    const address = URL.createObjectURL(new Blob([text], { type }));
    const link = element("a", { href: address, download: name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  }

  // ---- tables -------------------------------------------------------------------------------------------------------

  const numbers = cell => [...cell.querySelectorAll("[data-value]")];

  /// Full numbers in SI: a column for the value, one for each further part that any row has.
  function tableText(table) {
    const rows = [...table.tBodies[0].rows];
    const columns = [...table.tHead.rows[0].cells].map((head, index) => {
      const parts = [];
      for (const row of rows) for (const span of numbers(row.cells[index])) if (!parts.includes(span.dataset.part)) parts.push(span.dataset.part);
      return { index, name: head.dataset.name, unit: head.dataset.unit, parts };
    });
    const line = cells => cells.map(text => text.replace(/[\t\r\n]+/g, " ")).join("\t");
    const header = columns.flatMap(c => (c.parts.length ? c.parts.map(part => (part === "value" ? c.name : c.name + " " + part) + " [" + c.unit + "]") : [c.name]));
    const body = rows.map(row => line(columns.flatMap(c => {
      const cell = row.cells[c.index];
      return c.parts.length ? c.parts.map(part => numbers(cell).find(span => span.dataset.part === part)?.dataset.value ?? "") : [cell.textContent.trim()];
    })));
    return [line(header), ...body].join("\n") + "\n";
  }

  async function copyTable(button) {
    const table = button.closest("section.table").querySelector("table");
    const notice = button.parentElement.querySelector(".notice");
    try {
      await navigator.clipboard.writeText(tableText(table));
      notice.textContent = "Copied " + table.tBodies[0].rows.length + " rows, full precision, SI units";
    } catch {
      getSelection().selectAllChildren(table);
      notice.textContent = "Selected; copy it with Ctrl+C";
    }
  }

  function sortTable(head) {
    const table = head.closest("table");
    const index = head.cellIndex;
    const direction = head.getAttribute("aria-sort") === "ascending" ? "descending" : "ascending";
    for (const other of head.parentElement.cells) other.setAttribute("aria-sort", "none");
    head.setAttribute("aria-sort", direction);
    const key = row => {
      const span = numbers(row.cells[index])[0];
      if (span) return span.dataset.value === "" || Number.isNaN(Number(span.dataset.value)) ? null : Number(span.dataset.value);
      const text = row.cells[index].textContent.trim();
      return text === "" || text === "–" ? null : text;
    };
    const keyed = [...table.tBodies[0].rows].map(row => [key(row), row]);
    const sign = direction === "ascending" ? 1 : -1;
    keyed.sort(([a], [b]) => {
      if (a === null || b === null) return (a === null) - (b === null);
      return sign * (typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b), "en", { numeric: true }));
    });
    table.tBodies[0].append(...keyed.map(([, row]) => row));
  }

  for (const button of document.querySelectorAll("button.copy")) button.addEventListener("click", () => copyTable(button));
  for (const head of document.querySelectorAll("thead th")) head.querySelector("button").addEventListener("click", () => sortTable(head));

  // ---- figures ------------------------------------------------------------------------------------------------------

  const axisTitle = axis => axis.html + (axis.shown_unit ? " (" + axis.shown_unit + ")" : "");
  const withUnit = (text, axis) => text + (axis.shown_unit ? " " + axis.shown_unit : "");

  /// What the pointer reads at a point.
  function reading(panel, series, index) {
    const lines = [];
    if (series.label) lines.push("<b>" + escaped(series.label) + "</b>");
    if (series.names?.[index]) lines.push(escaped(series.names[index]));
    const value = (axis, number, low, high) => {
      if (axis.ticks) return escaped(axis.ticks[number] ?? "");
      const ends = Number.isFinite(low) && Number.isFinite(high) ? " [" + shown(low) + ", " + shown(high) + "]" : "";
      return withUnit(axis.html + " = " + shown(number) + ends, axis);
    };
    lines.push(value(panel.x, series.x[index], series.left?.[index], series.right?.[index]));
    if (series.y) lines.push(value(panel.y, series.y[index], series.lower?.[index], series.upper?.[index]));
    return lines.join("<br>");
  }

  /// A band as polygons, one for each stretch without a gap.
  function bandOutline(series, logY, floor) {
    const x = [], y = [];
    const shows = i => [series.x[i], series.lower[i], series.upper[i]].every(v => v !== null && v !== undefined) && (!logY || series.upper[i] > 0);
    const low = v => (logY && v <= 0 ? floor : v);
    for (let first = 0; first < series.x.length; ++first) {
      if (!shows(first)) continue;
      let last = first;
      while (last + 1 < series.x.length && shows(last + 1)) ++last;
      for (let i = first; i <= last; ++i) { x.push(series.x[i]); y.push(series.upper[i]); }
      for (let i = last; i >= first; --i) { x.push(series.x[i]); y.push(low(series.lower[i])); }
      x.push(series.x[first], null);
      y.push(series.upper[first], null);
      first = last;
    }
    return { x, y };
  }

  function transparent(colour, opacity) {
    const part = i => parseInt(colour.slice(i, i + 2), 16);
    return `rgba(${part(1)},${part(3)},${part(5)},${opacity})`;
  }

  const errors = (middle, low, high, colour) => ({
    type: "data", symmetric: false, thickness: 1.2, width: 0, color: colour,
    array: middle.map((v, i) => (high[i] === null ? 0 : high[i] - v)), arrayminus: middle.map((v, i) => (low[i] === null ? 0 : v - low[i])),
  });

  /// Symbols tell lines apart that have them.
  const lineDash = series => (series.mark === "both" && series.dash === series.symbol ? "solid" : chosen(dashes, series.dash));

  /// Traces of one series.
  function tracesOf(panel, series, state) {
    const colour = chosen(palette, series.colour);
    const line = { color: colour, width: 1.25 * series.width, dash: lineDash(series) };
    const common = { type: "scatter", listed: !!series.label && !series.unlisted, name: escaped(series.label), showlegend: false, hoverinfo: "text", opacity: series.opacity, legendgroup: series.label };
    if (series.legend_only) return [];
    const hovertext = series.x.map((_, i) => reading(panel, series, i));
    if (series.mark === "band") {
      const positive = series.upper.filter(v => v > 0);
      const outline = bandOutline(series, state.y, panel.y.from > 0 ? panel.y.from : Math.min(...positive) / 1000);
      const traces = [{ ...common, ...outline, mode: "lines", line: { width: 0 }, fill: "toself", fillcolor: transparent(colour, 0.25 * series.opacity), hoverinfo: "skip", opacity: 1 }];
      if (series.y) traces.push({ ...common, x: series.x, y: series.y, hovertext, mode: "lines", line });
      return traces;
    }
    if (series.mark === "area")
      return [{ ...common, x: [...series.x, series.x[0]], y: [...series.y, series.y[0]], hovertext: [...hovertext, hovertext[0]], mode: "lines", line: { ...line, width: 1 }, fill: "toself", fillcolor: transparent(colour, 0.25) }];
    const trace = { ...common, x: series.x, y: series.y, hovertext, mode: { points: "markers", line: "lines", both: "lines+markers" }[series.mark], line };
    if (series.mark !== "line") {
      trace.marker = { symbol: chosen(symbols, series.symbol), size: 8, color: series.hollow ? "#ffffff" : colour, line: { color: colour, width: series.hollow ? 1.5 : 0.5 } };
    }
    if (series.lower && series.upper) trace.error_y = errors(series.y, series.lower, series.upper, colour);
    if (series.left && series.right) trace.error_x = errors(series.x, series.left, series.right, colour);
    return [trace];
  }

  function mapTrace(panel) {
    const { map } = panel;
    const [nx, ny] = [map.columns.length, map.columns[0].length];
    const z = Array.from({ length: ny }, (_, j) => map.columns.map(column => column[j]));
    const text = z.map((row, j) => row.map((v, i) => withUnit(map.axis.html + " = " + shown(v), map.axis) + "<br>" +
      withUnit(shown(((i + 0.5) * map.width) / nx) + ", " + shown(((j + 0.5) * map.height) / ny), panel.x)));
    return {
      type: "heatmap", z, text, hoverinfo: "text", x0: map.width / nx / 2, dx: map.width / nx, y0: map.height / ny / 2, dy: map.height / ny, colorscale: "Viridis",
      zmin: map.axis.from, zmax: map.axis.to, colorbar: { title: { text: axisTitle(map.axis), side: "right" }, thickness: 12, outlinewidth: 0 },
    };
  }

  /// Legend entries of a panel with the series each switches, [panel, series]: those of its label here and in panels without
  /// a legend of their own. One without points stands for the series that share its colour; among those in black, for the series
  /// that share what tells it from the others.
  function entriesOf(figure, panel) {
    if (!panel.legend) return [];
    const shared = panel.series.filter(series => series.legend_only);
    const withMarks = series => series.mark === "points";
    const fitting = entry => {
      if (!entry.legend_only) return series => series.label === entry.label && !series.legend_only;
      const rivals = shared.filter(other => other.colour === entry.colour && withMarks(other) === withMarks(entry));
      const telling = ["symbol", "hollow", "dash"].filter(key => (key === "dash" && !withMarks(entry)) || rivals.some(other => other[key] !== entry[key]));
      const alike = entry.colour === 4
        ? series => withMarks(series) === withMarks(entry) && telling.every(key => series[key] === entry[key])
        : series => series.colour === entry.colour;
      return series => series.unlisted && alike(series);
    };
    const listed = series => series.label && !series.unlisted;
    const spokenFor = other => other === panel || !other.legend || !other.series.some(listed);
    return panel.series.filter(listed).map(series => {
      const fits = fitting(series);
      return { series, members: figure.panels.flatMap((other, p) => (spokenFor(other) ? other.series : []).flatMap((candidate, s) => (fits(candidate) ? [[p, s]] : []))) };
    });
  }

  /// State of a panel: whether its axes are logarithmic, and which series are hidden.
  const stateOf = panel => ({ x: !!panel.x.log, y: !!panel.y.log, hidden: new Set() });

  function traces(panel, state) {
    const list = panel.map ? [mapTrace(panel)] : [];
    panel.series.forEach((series, index) => {
      if (!state.hidden.has(index)) list.push(...tracesOf(panel, series, state));
    });
    return list;
  }

  function axisLayout(panel, name, logarithmic) {
    const axis = panel[name];
    const layout = {
      title: { text: axisTitle(axis), standoff: 8, font: { size: 14 } }, type: logarithmic ? "log" : "linear", visible: !axis.hidden, showline: true, mirror: "ticks", linecolor: "#333", ticks: "inside",
      ticklen: 6, tickcolor: "#333", zeroline: false, gridcolor: "#e8eaed", exponentformat: "power", showexponent: "all", automargin: true, separatethousands: false,
      minor: { ticks: "inside", ticklen: 3, tickcolor: "#333" }, tickfont: { size: 12.5 },
    };
    if (axis.ticks) {
      Object.assign(layout, { tickvals: axis.ticks.map((_, i) => i), ticktext: axis.ticks.map(escaped), range: [-0.5, axis.ticks.length - 0.5], minor: {} });
      return layout;
    }
    const end = value => (logarithmic ? Math.log10(value) : value);
    const usable = value => value !== undefined && (!logarithmic || value > 0);
    if (usable(axis.from) && usable(axis.to)) layout.range = [end(axis.from), end(axis.to)];
    else if (usable(axis.from)) Object.assign(layout, { autorange: "max", range: [end(axis.from), null] });
    else if (usable(axis.to)) Object.assign(layout, { autorange: "min", range: [null, end(axis.to)] });
    if (logarithmic) Object.assign(layout, logarithmicTicks(panel, name, layout.range));
    if (panel.map) Object.assign(layout, { showgrid: false, constrain: "domain" }, name === "y" ? { scaleanchor: "x" } : {});
    return layout;
  }

  /// Powers of ten where an axis spans several, every second where it spans many; numbers between them where it spans few.
  function logarithmicTicks(panel, name, range) {
    let [low, high] = range && range[0] !== null && range[1] !== null ? range : [Infinity, -Infinity];
    for (const series of low < high ? [] : panel.series)
      for (const value of series[name] || [])
        if (value > 0) [low, high] = [Math.min(low, Math.log10(value)), Math.max(high, Math.log10(value))];
    if (!(high - low < 2)) return { dtick: high - low > 8 ? 2 : 1 };
    const tickvals = [];
    for (let power = Math.floor(low) - 1; power <= Math.ceil(high) + 1; ++power)
      for (const digit of high - low < 1 ? [1, 2, 3, 5, 7] : [1, 2, 5]) tickvals.push(Number(digit + "e" + power));
    return { tickvals, ticktext: tickvals.map(shown), minor: {} };
  }

  function layoutOf(panel, state) {
    const place = (name, value) => (state[name] ? Math.log10(value) : value);
    return {
      font: { family: font, size: 13, color: "#1a1a1a" }, paper_bgcolor: "#ffffff", plot_bgcolor: "#ffffff", margin: { l: 60, r: 18, t: 12, b: 48 }, showlegend: false, hovermode: "closest",
      hoverlabel: { bgcolor: "#ffffff", bordercolor: "#333", font: { family: font, size: 13, color: "#1a1a1a" }, align: "left" }, dragmode: "zoom",
      xaxis: axisLayout(panel, "x", state.x), yaxis: axisLayout(panel, "y", state.y),
      shapes: (panel.lines || []).filter(v => !state.y || v > 0).map(v => ({ type: "line", xref: "x domain", x0: 0, x1: 1, y0: v, y1: v, line: { color: "#808080", width: 1 }, layer: "below" })),
      annotations: (panel.notes || []).filter(n => (!state.x || n.x > 0) && (!state.y || n.y > 0)).map(n => ({
        x: place("x", n.x), y: place("y", n.y), text: escaped(n.text), showarrow: false, font: { size: 12.5, color: chosen(palette, n.colour) },
        xanchor: { right: "left", left: "right", centre: "center" }[n.side],
      })),
    };
  }

  /// Rows from the top or places of their own: where each panel stands, in shares of the figure.
  function places(figure) {
    const columns = Math.min(figure.columns, figure.panels.length);
    const rows = Math.ceil(figure.panels.length / columns);
    return figure.panels.map((panel, i) => panel.place || [(i % columns) / columns, Math.floor(i / columns) / rows, 1 / columns, 1 / rows]);
  }

  /// The corner of a panel that holds the least of its points, unless it names one.
  function legendCorner(panel, state) {
    if (panel.corner) return panel.corner;
    const place = name => {
      const scale = state[name] ? v => (v > 0 ? Math.log10(v) : NaN) : v => v;
      const shown = panel.series.filter((_, i) => !state.hidden.has(i)).map(series => (series[name] || (name === "y" ? series.upper : null) || []).map(scale));
      const known = shown.flat().filter(Number.isFinite);
      const range = axisLayout(panel, name, state[name]).range || [null, null];
      const low = range[0] ?? known.reduce((a, b) => Math.min(a, b), Infinity), high = range[1] ?? known.reduce((a, b) => Math.max(a, b), -Infinity);
      return shown.map(values => values.map(v => (v - low) / (high - low)));
    };
    const x = place("x"), y = place("y"), counts = { "top right": 0, "top left": 0, "bottom right": 0, "bottom left": 0 };
    x.forEach((values, s) => values.forEach((across, i) => {
      const up = y[s][i];
      if ((across > 0.35 && across < 0.65) || (up > 0.45 && up < 0.55)) return;
      const corner = (up >= 0.5 ? "top" : "bottom") + (across >= 0.5 ? " right" : " left");
      if (Number.isFinite(across + up)) counts[corner] += 1 / values.length;
    }));
    return Object.keys(counts).reduce((best, corner) => (counts[corner] < counts[best] ? corner : best));
  }

  /// All panels in one picture, with their legends, as SVG.
  async function asSvg(drawn) {
    const { figure, states, legend } = drawn;
    const width = Math.round((figure.width / 178) * 1000), height = Math.round((figure.height / 178) * 1000);
    const data = [], layout = { ...layoutOf(figure.panels[0], states[0]), width, height, showlegend: legend, shapes: [], annotations: [], margin: { l: 5, r: 5, t: 5, b: 5 } };
    delete layout.xaxis;
    delete layout.yaxis;
    places(figure).forEach(([left, top, w, h], i) => {
      const panel = figure.panels[i], end = i === 0 ? "" : String(i + 1), own = layoutOf(panel, states[i]);
      const x = [left + Math.min(70 / width, 0.3 * w), left + w - (panel.map ? 90 : panel.beside ? 150 : 12) / width], y = [1 - top - h + Math.min(50 / height, 0.3 * h), 1 - top - 24 / height];
      layout["xaxis" + end] = { ...own.xaxis, domain: x, anchor: "y" + end, automargin: false };
      layout["yaxis" + end] = { ...own.yaxis, domain: y, anchor: "x" + end, automargin: false, ...(panel.map ? { scaleanchor: "x" + end } : {}) };
      const [vertical, horizontal] = legendCorner(panel, states[i]).split(" ");
      layout["legend" + end] = { x: panel.beside ? x[1] + 8 / width : horizontal === "left" ? x[0] : x[1], xanchor: panel.beside ? "left" : horizontal, y: panel.beside || vertical === "top" ? y[1] : y[0], yanchor: panel.beside ? "top" : vertical, bgcolor: "rgba(255,255,255,0.75)", font: { size: 11 }, tracegroupgap: 0 };
      layout.shapes.push(...own.shapes.map(s => ({ ...s, xref: "x" + end + " domain", yref: "y" + end })));
      layout.annotations.push(...own.annotations.map(a => ({ ...a, xref: "x" + end, yref: "y" + end })));
      if (panel.heading) layout.annotations.push({ text: "<b>" + escaped(panel.heading) + "</b>", showarrow: false, xref: "paper", yref: "paper", x: x[0], y: y[1], xanchor: "left", yanchor: "bottom" });
      const named = new Set();
      for (const trace of traces(panel, states[i])) {
        const first = trace.listed && !named.has(trace.name) && trace.hoverinfo !== "skip" && panel.legend;
        delete trace.listed;
        if (first) named.add(trace.name);
        data.push({ ...trace, xaxis: "x" + end, yaxis: "y" + end, ...(trace.type === "scatter" ? { legend: "legend" + end, legendgroup: "", showlegend: !!first } : { colorbar: { ...trace.colorbar, x: x[1] + 0.005, y: (y[0] + y[1]) / 2, len: y[1] - y[0] } }) });
      }
      for (const { series, members } of entriesOf(figure, panel)) {
        if (!series.legend_only && series.mark !== "band") continue;
        if (named.has(escaped(series.label)) || (members.length && members.every(([p, s]) => states[p].hidden.has(s)))) continue;
        const colour = chosen(palette, series.colour);
        data.push({ type: "scatter", x: [null], y: [null], name: escaped(series.label), showlegend: true, legend: "legend" + end, xaxis: "x" + end, yaxis: "y" + end,
          mode: { points: "markers", line: "lines", both: "lines+markers" }[series.mark] || "lines", line: { color: series.mark === "band" ? transparent(colour, 0.4) : colour, width: series.mark === "band" ? 8 : 1.6, dash: series.mark === "band" ? "solid" : chosen(dashes, series.dash) },
          marker: { symbol: chosen(symbols, series.symbol), color: series.hollow ? "#ffffff" : colour, line: { color: colour, width: 1.2 }, size: 8 } });
      }
    });
    const address = await Plotly.toImage({ data, layout, config: { staticPlot: true } }, { format: "svg", width, height });
    return decodeURIComponent(address.slice(address.indexOf(",") + 1));
  }

  /// The numbers of a figure, as `setae plot` writes them.
  function asCsv(figure) {
    const cell = value => (value === null || value === undefined ? "" : typeof value === "number" ? String(value) : /[",\r\n]/.test(value) ? '"' + value.replace(/"/g, '""') + '"' : value);
    const maps = figure.panels.some(panel => panel.map);
    const lines = ["panel,series,name,x quantity,x unit,x,y quantity,y unit,y,lower,upper,left,right" + (maps ? ",value quantity,value unit,value" : "")];
    figure.panels.forEach((panel, p) => {
      const title = cell(panel.title || String(p + 1));
      const [x, y] = [panel.x, panel.y].map(axis => cell(axis.quantity) + "," + cell(axis.unit));
      if (panel.map) {
        const { map } = panel, value = cell(map.axis.quantity) + "," + cell(map.axis.unit);
        map.columns.forEach((column, i) => column.forEach((v, j) =>
          lines.push([title, "map", "", x, cell((i + 0.5) * (map.width / map.columns.length)), y, cell((j + 0.5) * (map.height / column.length)), "", "", "", "", value, cell(v)].join(","))));
      }
      for (const series of panel.series)
        series.x.forEach((value, i) => lines.push([title, cell(series.label), cell(series.names?.[i]), x, cell(value), y,
          ...["y", "lower", "upper", "left", "right"].map(key => cell(series[key]?.[i]))].join(",") + (maps ? ",,," : "")));
    });
    return lines.join("\n") + "\n";
  }

  /// What a legend shows of a series.
  function swatch(series) {
    const colour = chosen(palette, series.colour), fill = series.hollow ? "#ffffff" : colour;
    const dash = lineDash(series).replace("solid", "none").replace(/px/g, ""), line = series.mark !== "points" && series.mark !== "area" && (series.mark !== "band" || series.y);
    const shape = {
      circle: '<circle cx="14" cy="7" r="4"/>', square: '<rect x="10" y="3" width="8" height="8"/>', "triangle-up": '<path d="M14 2l5 9h-10z"/>', diamond: '<path d="M14 1.5l5 5.5-5 5.5-5-5.5z"/>',
      "triangle-down": '<path d="M14 12l5-9h-10z"/>', pentagon: '<path d="M14 2l5 4-2 5.5h-6l-2-5.5z"/>',
    }[chosen(symbols, series.symbol)];
    const filled = series.mark === "band" || series.mark === "area";
    const holder = element("span", { "aria-hidden": "true" });
    holder.innerHTML = '<svg width="28" height="14">' + (filled ? `<rect y="2" width="28" height="10" fill="${colour}" opacity="0.25"/>` : "") +
      (line ? `<path d="M0 7h28" stroke="${colour}" stroke-width="${Math.max(1.5, series.width)}" stroke-dasharray="${dash}"/>` : "") +
      (series.mark === "points" || series.mark === "both" ? `<g fill="${fill}" stroke="${colour}" stroke-width="1.2">${shape}</g>` : "") + "</svg>";
    return holder;
  }

  const config = { displayModeBar: false, responsive: false, doubleClick: "reset" };
  const drawnFigures = new Map();

  /// Panels are a share of their figure's width, and as high for it as on paper; those much lower than others, such as
  /// residuals, may be low.
  function heightOf(figure, i, width, most) {
    const shares = places(figure), [, , w, h] = shares[i];
    const low = h < 0.6 * Math.max(...shares.map(place => place[3]));
    return Math.round(Math.max(low ? 170 : 280, Math.min(most, (width * h * figure.height) / (w * figure.width))));
  }

  function sizeOf(drawn, i) {
    const width = drawn.plots[i].clientWidth;
    return { width, height: heightOf(drawn.figure, i, width, 440) };
  }

  function draw(section) {
    if (drawnFigures.has(section)) return;
    const figure = JSON.parse(section.querySelector("script.figure-data").textContent);
    const holder = section.querySelector(".plots");
    const drawn = { figure, plots: [], legends: [], states: figure.panels.map(stateOf), off: new Set(), legend: true };
    drawnFigures.set(section, drawn);
    const shares = places(figure), boxes = [];
    figure.panels.forEach((panel, i) => {
      const plot = element("div", { class: "plot", role: "img", "aria-label": [holder.dataset.label, panel.heading && "Panel " + panel.heading].filter(Boolean).join(" ") });
      const legend = element("ul", { class: "legend", "aria-label": "Legend" + (panel.heading ? " of " + panel.heading : "") });
      for (const { series, members } of entriesOf(figure, panel)) {
        const button = element("button", { type: "button", "aria-pressed": "true" }, swatch(series), series.label);
        button.disabled = members.length === 0;
        button.addEventListener("click", () => {
          const hide = button.getAttribute("aria-pressed") === "true";
          button.setAttribute("aria-pressed", String(!hide));
          hide ? drawn.off.add(members) : drawn.off.delete(members);
          const off = [...drawn.off].flat();
          drawn.states.forEach((state, p) => { state.hidden = new Set(off.filter(([panel]) => panel === p).map(([, s]) => s)); });
          for (const p of new Set(members.map(([panel]) => panel))) redraw(drawn, p);
        });
        legend.append(element("li", {}, button));
      }
      legend.hidden = legend.children.length === 0;
      const box = element("div", { class: "panel", style: `--part: calc(${100 * shares[i][2]}% - .75rem)` });
      if (panel.heading) box.append(element("p", { class: "panel-title" }, panel.heading));
      box.append(plot, legend);
      drawn.plots.push(plot);
      drawn.legends.push(legend);
      boxes.push({ box, top: shares[i][1], left: shares[i][0] });
    });
    boxes.sort((a, b) => a.top - b.top || a.left - b.left);
    holder.append(...boxes.map(({ box }) => box));
    figure.panels.forEach((panel, i) => {
      Plotly.newPlot(drawn.plots[i], traces(panel, drawn.states[i]), { ...layoutOf(panel, drawn.states[i]), ...sizeOf(drawn, i) }, config);
    });
    showButtons(section, drawn);
  }

  function redraw(drawn, i) {
    const panel = drawn.figure.panels[i];
    Plotly.react(drawn.plots[i], traces(panel, drawn.states[i]), { ...layoutOf(panel, drawn.states[i]), ...sizeOf(drawn, i) }, config);
  }

  /// Panels whose axis a button switches: those that are logarithmic to begin with, where there are such, else all that can be.
  function switched(figure, name) {
    const able = figure.panels.map((panel, i) => i).filter(i => !figure.panels[i][name].ticks && !figure.panels[i].map);
    const logarithmic = able.filter(i => figure.panels[i][name].log);
    return logarithmic.length ? logarithmic : able;
  }

  function showButtons(section, drawn) {
    for (const name of ["x", "y"]) {
      const button = section.querySelector(`[data-action="${name}"]`);
      const panels = switched(drawn.figure, name);
      button.disabled = panels.length === 0;
      button.setAttribute("aria-pressed", String(panels.length > 0 && panels.every(i => drawn.states[i][name])));
    }
    section.querySelector('[data-action="legend"]').setAttribute("aria-pressed", String(drawn.legend));
  }

  async function act(section, action) {
    draw(section);
    const drawn = drawnFigures.get(section);
    if (action === "csv") return save(drawn.figure.name + ".csv", "text/csv", asCsv(drawn.figure));
    if (action === "svg") return save(drawn.figure.name + ".svg", "image/svg+xml", await asSvg(drawn));
    if (action === "reset") return drawn.plots.forEach((plot, i) => Plotly.relayout(plot, { xaxis: layoutOf(drawn.figure.panels[i], drawn.states[i]).xaxis, yaxis: layoutOf(drawn.figure.panels[i], drawn.states[i]).yaxis }));
    if (action === "legend") {
      drawn.legend = !drawn.legend;
      for (const legend of drawn.legends) legend.hidden = !drawn.legend || legend.children.length === 0;
    } else {
      const logarithmic = section.querySelector(`[data-action="${action}"]`).getAttribute("aria-pressed") !== "true";
      for (const i of switched(drawn.figure, action)) {
        drawn.states[i][action] = logarithmic;
        redraw(drawn, i);
      }
    }
    showButtons(section, drawn);
  }

  const sections = [...document.querySelectorAll("section.figure")].filter(section => section.querySelector(".plots"));
  // what is folded has no place on the page and is not near
  const near = new IntersectionObserver(entries => {
    for (const { isIntersecting, target } of entries)
      if (isIntersecting) {
        near.unobserve(target);
        draw(target.closest("section.figure"));
      }
  }, { rootMargin: "400px" });
  for (const section of sections) {
    near.observe(section.querySelector(".plots"));
    for (const button of section.querySelectorAll(".tools button")) button.addEventListener("click", () => act(section, button.dataset.action));
    const data = section.querySelector("details.data");
    data.addEventListener("toggle", () => {
      if (data.open && !data.querySelector("pre").textContent) data.querySelector("pre").textContent = asCsv(JSON.parse(section.querySelector("script.figure-data").textContent));
    });
  }

  /// Figures drawn before and shown now, at the width they have now.
  function resizeAll() {
    for (const drawn of drawnFigures.values())
      drawn.plots.forEach((plot, i) => { if (plot.clientWidth) Plotly.relayout(plot, sizeOf(drawn, i)); });
  }
  let waiting = 0;
  let lastWidth = innerWidth;
  addEventListener("resize", () => {
    if (innerWidth === lastWidth) return;
    lastWidth = innerWidth;
    clearTimeout(waiting);
    waiting = setTimeout(resizeAll, 120);
  });

  // ---- folds --------------------------------------------------------------------------------------------------------

  const folds = [...document.querySelectorAll("main details:not(.data)")];
  const unfold = document.getElementById("unfold");
  let printing = false;

  unfold.addEventListener("click", () => {
    const open = unfold.getAttribute("aria-pressed") !== "true";
    for (const fold of folds) fold.open = open;
    unfold.setAttribute("aria-pressed", String(open));
  });
  // a window may have changed its width since
  for (const fold of folds) fold.addEventListener("toggle", () => { if (fold.open && !printing) resizeAll(); });

  /// A link to a part opens it, and what it is in.
  function reveal() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    for (let fold = target.querySelector(":scope > details") || target.closest("details"); fold; fold = fold.parentElement.closest("details")) fold.open = true;
    target.scrollIntoView();
  }
  addEventListener("hashchange", reveal);
  if (location.hash) reveal();

  // on paper: everything unfolded, everything drawn, one column
  let folded = [];
  addEventListener("beforeprint", () => {
    printing = true;
    folded = folds.filter(fold => !fold.open);
    for (const fold of folded) fold.open = true;
    sections.forEach(draw);
    for (const { figure, plots } of drawnFigures.values())
      plots.forEach((plot, i) => Plotly.relayout(plot, { width: 660, height: heightOf(figure, i, 660, 420) }));
  });
  addEventListener("afterprint", () => {
    for (const fold of folded) fold.open = false;
    printing = false;
    resizeAll();
  });
})();
