// SPDX-License-Identifier: BSD-3-Clause
// Draws the charts of a page with Apache ECharts. Each <figure class="chart"> holds its data as JSON:
//   lines: panels above one another over one axis, with measured points, bands, levels, marks and spans
//   field: temperatures of quadrilaterals at several moments, with a slider
//   bars, cells: see maps_and_bars.js
// Keys on a chart: + and - zoom, the arrows move, 0 shows all.
(function () {
  "use strict";
  const charts = [];
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  const { number, named, plain, inferno } = chartParts;
  const looks = { dark: chartParts.dark, light: chartParts.light };
  const reader = () => looks[dark.matches && !document.body.classList.contains("printing") ? "dark" : "light"];

  function seriesOf(panel, index, places, look, middle) {
    const made = [];
    for (const s of panel.series) {
      const { colour: of, dash } = chartParts.curve(places.get(s.group || s.name), look);
      if (s.role === "band") {
        const low = s.points.map((p) => [p[0], p[1]]);
        const rise = s.points.map((p) => [p[0], p[2] - p[1]]);
        const shared = { type: "line", xAxisIndex: index, yAxisIndex: index, stack: `band ${index} ${s.name}`, stackStrategy: "all", symbol: "none", silent: true,
          itemStyle: { color: of }, lineStyle: { opacity: 0 }, tooltip: { show: false } };
        made.push({ ...shared, name: s.name, data: low }, { ...shared, name: s.name, data: rise, areaStyle: { color: of, opacity: 0.2 } });
        continue;
      }
      if (s.role === "range") {
        made.push({ type: "custom", name: s.name, xAxisIndex: index, yAxisIndex: index, data: s.points, itemStyle: { color: of },
          encode: { x: 0, y: [1, 2] }, z: 4,
          renderItem: (params, api) => {
            const a = api.coord([api.value(0), api.value(1)]), b = api.coord([api.value(0), api.value(2)]);
            const style = { stroke: of, lineWidth: 3, fill: look.paper };
            const end = (p) => ({ type: "circle", shape: { cx: p[0], cy: p[1], r: 5 }, style: { ...style, lineWidth: 2 } });
            return { type: "group", children: [{ type: "line", shape: { x1: a[0], y1: a[1], x2: b[0], y2: b[1] }, style }, end(a), end(b)] };
          } });
        continue;
      }
      const points = s.role === "points";
      made.push({ type: points ? "scatter" : "line", name: s.name, xAxisIndex: index, yAxisIndex: index, data: s.points,
        symbol: points ? "circle" : "none", symbolSize: 5, itemStyle: { color: of, opacity: points ? (s.points.length > 300 ? 0.3 : 0.75) : 1 },
        lineStyle: { color: of, width: s.role === "line" ? 1.8 : s.role === "faint" ? 0.8 : 1.5, opacity: s.role === "line" ? 1 : s.role === "faint" ? 0.35 : 0.75, type: s.role === "dashed" ? [7, 4] : s.role === "dotted" ? [2, 3] : dash }, z: points ? 2 : 3 });
    }
    for (const [i, mark] of (panel.marks || []).entries()) {
      const { colour: of } = chartParts.curve(places.get(mark.group) || 0, look);
      made.push({ type: "scatter", name: "marks", xAxisIndex: index, yAxisIndex: index, data: [[mark.x, mark.y]], symbol: "pin", symbolSize: 26, z: 6, silent: true,
        itemStyle: { color: of, borderColor: look.paper, borderWidth: 1 }, tooltip: { show: false },
        label: { show: true, formatter: mark.name, position: mark.x > middle ? "left" : "right", offset: [0, 30 + 17 * i], color: look.ink, fontSize: 12, textBorderColor: look.paper, textBorderWidth: 3 } });
    }
    const heights = [...new Set((panel.levels || []).map((level) => level.value))];
    const levels = heights.map((value) => ({ yAxis: value, label: { position: "insideStartTop", color: look.ink, textBorderColor: look.paper, textBorderWidth: 3,
      formatter: panel.levels.filter((level) => level.value === value && level.name).map((level) => level.name).join("; ") } }));
    if (made.length && levels.length) {
      made[0].markLine = { symbol: "none", silent: true, lineStyle: { color: look.ink, type: "dashed" }, data: levels };
    }
    return made;
  }

  // Steps, laps and runs as bands of every panel; their names stand in the first one where they have room.
  function bandsOf(data, look, width, named) {
    const share = width / Math.max(data.x.max - data.x.min, 1e-9);
    let held = 0;
    return { silent: true, label: { color: look.ink, position: "insideTop", fontSize: 11 },
      data: data.spans.map((span) => {
        const fits = named && span.name && share * (span.to - span.from) > 6.2 * span.name.length;
        const shaded = span.name ? held++ % 2 === 1 : false;
        return [{ xAxis: span.from, name: fits ? span.name : "", itemStyle: { color: shaded ? look.line : look.soft, opacity: span.name ? 0.55 : 0 } }, { xAxis: span.to }];
      }) };
  }

  function lines(data, look, width, places, picks) {
    const names = [...new Set(data.panels.flatMap((panel) => panel.series.map((s) => s.name)))];
    const drawn = new Map(data.panels.flatMap((panel) => panel.series.map((s) => [s.name, ["points", "range", "band"].includes(s.role) ? "mark" : "line"])));
    const printing = document.body.classList.contains("printing");
    const small = width < 560, gap = 34, foot = printing ? 54 : 96;  // room for the zoom, which paper has not
    let rows = picks ? 0 : 1, reach = 0;  // of the legend; a long one stands below the chart, to be picked from
    for (const name of names) {
      const wide = 44 + 6.8 * name.length;
      if (!picks && reach + wide > width - 76 && reach > 0) { rows += 1; reach = 0; }
      reach += wide;
    }
    const top = 20 + 24 * rows;
    const tall = data.panels.map((panel) => (panel.short ? 130 : small ? 250 : 340));
    const sum = tall.reduce((all, one) => all + one, 0), room = 590 - gap * (tall.length - 1);  // of a sheet of paper
    const heights = tall.map((one) => (printing && sum > room ? Math.floor(one * room / sum) : one));
    const option = { grid: [], xAxis: [], yAxis: [], series: [] };
    let y = top;
    data.panels.forEach((panel, i) => {
      const last = i + 1 === data.panels.length;
      option.grid.push({ left: 66, right: 22, top: y, height: heights[i] });
      option.xAxis.push({ type: "value", gridIndex: i, min: data.x.min, max: data.x.max, name: last ? named(data.x) : "", nameLocation: "middle", nameGap: 28,
        axisLabel: { show: last, color: look.ink, hideOverlap: true }, nameTextStyle: { color: look.ink }, axisLine: { onZero: false, lineStyle: { color: look.faint } },
        splitLine: { lineStyle: { color: look.soft } }, axisPointer: { label: { show: last } } });
      placed(option.xAxis[i], data.x);
      option.yAxis.push({ type: "value", gridIndex: i, scale: true, name: named(panel), nameLocation: "middle", nameGap: 46, nameTextStyle: { color: look.ink },
        axisLabel: { color: look.ink, formatter: (v) => number(v) }, splitLine: { lineStyle: { color: look.line } } });
      const made = seriesOf(panel, i, places, look, 0.5 * (data.x.min + data.x.max));
      const first = made.find((series) => series.type === "line") || made[0];
      if (first && (data.spans || []).length) {
        first.markArea = bandsOf(data, look, width - 88, i === 0);
      }
      option.series.push(...made);
      y += heights[i] + gap;
    });
    const all = data.panels.map((_, i) => i);
    Object.assign(option, {
      legend: { show: !picks, top: 2, left: small ? 4 : 56, right: 16, itemWidth: 28, textStyle: { color: look.ink },
        data: names.map((name) => ({ name, itemStyle: { opacity: drawn.get(name) === "line" ? 0 : 1 } })) },
      tooltip: { trigger: "axis", confine: true, valueFormatter: number },
      axisPointer: { link: [{ xAxisIndex: "all" }] },
      dataZoom: [{ type: "inside", xAxisIndex: all, filterMode: "none", zoomOnMouseWheel: "ctrl", moveOnMouseMove: true },
        { type: "slider", show: !printing, xAxisIndex: all, filterMode: "none", bottom: 18, height: 20, showDataShadow: false, textStyle: { color: look.ink } }],
    });
    return { option, height: y - gap + foot };
  }

  /** Names in the place of the numbers 0, 1, ... of an axis. */
  function placed(axis, { labels, notes }) {
    if (labels) {
      const customValues = labels.map((_, i) => i);
      Object.assign(axis.axisLabel, { customValues, showMinLabel: true, showMaxLabel: true, formatter: (v) => labels[v] });
      axis.axisTick = { customValues };
      axis.axisPointer = { label: { show: false, formatter: (p) => (notes && notes[Math.round(p.value)]) || labels[Math.round(p.value)] || "" } };
    }
    return axis;
  }

  function frames(data) {
    const bytes = Uint8Array.from(atob(data.values), (c) => c.charCodeAt(0));
    const steps = new Uint16Array(bytes.buffer);
    const cells = data.polygons.length / (2 * data.corners), scale = (data.high - data.low) / 65535;
    return data.times.map((_, f) => Array.from(steps.subarray(f * cells, (f + 1) * cells), (s) => data.low + scale * s));
  }

  function cornersOf(data, cell) {
    const first = 2 * data.corners * cell;
    return Array.from({ length: data.corners }, (_, i) => [data.polygons[first + 2 * i], data.polygons[first + 2 * i + 1]]);
  }

  function fieldData(data, values) {
    const middle = (corners) => corners.reduce((sum, value) => sum + value, 0) / corners.length;
    return values.map((T, cell) => {
      const corners = cornersOf(data, cell);
      return [middle(corners.map((p) => p[0])), middle(corners.map((p) => p[1])), T, cell];
    });
  }

  // Names of the layers: in a specimen at the left edge, in a section below the crown with a line to each.
  function layersOf(data, look, width) {
    const places = data.layer_places || [], inside = (data.names || []).length > 0, n = places.length;
    return { type: "custom", name: "layers", silent: true, z: 8, animation: false, tooltip: { show: false }, data: width < 560 && inside ? [] : places.map((_, i) => [0, 0, i]),
      renderItem: (params, api) => {
        const i = params.dataIndex, at = api.coord([places[i].x, places[i].y]);
        const style = { text: places[i].name.replace(/_/g, " "), fontSize: 12, fill: look.ink, stroke: look.paper, lineWidth: 3, verticalAlign: "middle" };
        if (!inside) {
          return { type: "text", x: at[0] + 8, y: at[1], style: { ...style, fill: "#fff", stroke: "#000" } };
        }
        // The rightmost name stands highest, so that no line crosses a name.
        const low = api.coord([places[n - 1].x, places[n - 1].y])[1] + 38 + 17 * (n - 1 - i);
        return { type: "group", children: [
          { type: "line", shape: { x1: at[0], y1: at[1], x2: at[0], y2: low }, style: { stroke: look.ink, lineWidth: 1 } },
          { type: "circle", shape: { cx: at[0], cy: at[1], r: 2.4 }, style: { fill: "#fff", stroke: "#000", lineWidth: 0.8 } },
          { type: "text", x: at[0] + 5, y: low, style }] };
      } };
  }

  function field(data, look, width, frame) {
    const left = 62, right = width < 560 ? 18 : 110, top = 14, foot = 50;
    const wide = Math.max(data.x.max - data.x.min, 1e-9), high = Math.max(data.y.max - data.y.min, 1e-9);
    let inner = width - left - right, tall = inner * high / wide;
    if (tall > 620) { tall = 620; inner = tall * wide / high; }
    tall = Math.max(tall, 60);
    const mark = data.marks && data.marks[frame];
    // Drawn at once, not in pieces over several frames: paper and slider show the whole field.
    const series = [{ type: "custom", name: "temperature", data: fieldData(data, data.frames[frame]), encode: { x: 0, y: 1, value: 2 }, clip: true, animation: false, progressive: 0,
      renderItem: (params, api) => {
        const fill = api.visual("color"), points = cornersOf(data, api.value(3)).map((p) => api.coord(p));
        return { type: "polygon", shape: { points }, style: { fill, stroke: fill, lineWidth: 0.6 } };
      } }];
    series.push({ type: "custom", name: "borders", silent: true, data: (data.borders || []).map((_, i) => [0, 0, i]), z: 3, animation: false, tooltip: { show: false },
      renderItem: (params, api) => {
        const line = data.borders[params.dataIndex];
        const points = Array.from({ length: line.length / 2 }, (_, i) => api.coord([line[2 * i], line[2 * i + 1]]));
        return { type: "polyline", shape: { points }, style: { stroke: "rgba(255,255,255,0.65)", lineWidth: 1, fill: null } };
      } });
    const labelled = [];  // names of spots that lie close together stand above one another
    for (const spot of data.spots || []) {
      const at = spot.at[frame];
      const close = labelled.filter((other) => Math.abs(other[0] - at[0]) < 0.25 * wide && Math.abs(other[1] - at[1]) < 0.1 * high).length;
      labelled.push(at);
      if (!at) continue;
      const passed = at[2] >= spot.critical;
      series.push({ type: "scatter", name: spot.name, data: [at], symbol: "diamond", symbolSize: 15, z: 7, animation: false,
        itemStyle: { color: passed ? "#ffffff" : "rgba(255,255,255,0.35)", borderColor: "#000", borderWidth: 1.6 },
        label: { show: true, formatter: `${spot.name} ${at[2].toFixed(1)} °C`, position: "top", distance: 9 + 15 * close, color: look.ink, fontSize: 12, fontWeight: passed ? "bold" : "normal",
          textBorderColor: look.paper, textBorderWidth: 3 },
        tooltip: { formatter: () => `${plain(spot.name)}: ${at[2].toFixed(1)} °C, critical ${number(spot.critical)} °C` } });
    }
    series.push(layersOf(data, look, width));
    if (mark) {
      series.push({ type: "scatter", name: "hottest place", data: [[mark[0], mark[1], mark[2]]], symbolSize: 13, z: 5, animation: false,
        itemStyle: { color: "rgba(255,255,255,0.25)", borderColor: "#fff", borderWidth: 2.5, shadowColor: "#000", shadowBlur: 3 },
        tooltip: { formatter: () => `hottest place: ${mark[2].toFixed(1)} °C` } });
    }
    series.push({ type: "scatter", name: "names", silent: true, data: (data.names || []).map((n) => ({ value: [n.x, n.y], label: { formatter: n.name, align: n.align || "center" } })), symbolSize: 0, labelLayout: { hideOverlap: true },
      label: { show: true, color: look.ink, fontSize: 12 }, z: 6, animation: false, tooltip: { show: false } });
    return { height: Math.max(tall, width < 560 ? 0 : 110) + top + foot, option: {
      grid: { left, width: inner, top, height: tall },
      xAxis: { type: "value", min: data.x.min, max: data.x.max, name: named(data.x), nameLocation: "middle", nameGap: 26, nameTextStyle: { color: look.ink },
        axisLabel: { color: look.ink, hideOverlap: true, showMinLabel: false, showMaxLabel: false, formatter: number }, splitLine: { show: false }, axisLine: { onZero: false } },
      yAxis: { type: "value", min: data.y.min, max: data.y.max, inverse: !!data.y.down, name: named(data.y), nameLocation: "middle", nameGap: 42, nameTextStyle: { color: look.ink },
        axisLabel: { color: look.ink, hideOverlap: true, showMinLabel: false, showMaxLabel: false, formatter: number }, splitLine: { show: false }, axisLine: { onZero: false } },
      visualMap: { type: "continuous", seriesIndex: 0, dimension: 2, min: data.low, max: data.high > data.low ? data.high : data.low + 1, inRange: { color: inferno }, calculable: true,
        orient: "vertical", right: 0, top: "middle", itemHeight: Math.max(60, Math.min(160, tall - 30)), textStyle: { color: look.ink }, show: width >= 560,
        formatter: (v) => `${(+v).toFixed(1)} °C` },
      tooltip: { trigger: "item", confine: true, formatter: (p) => {
        const layer = data.layer_names ? data.layer_names[data.layers[p.value[3]]] : "";
        return `${p.value[2].toFixed(2)} °C${layer ? `<br>${plain(layer)}` : ""}`;
      } },
      series,
    } };
  }

  function showMoment(chart, frame) {
    chart.frame = frame;
    const t = chart.data.times[frame];
    chart.output.textContent = `${number(t)} ${chart.data.time_unit}`;
    chart.input.setAttribute("aria-valuetext", chart.output.textContent);
    chart.input.value = frame;
    draw(chart);
  }

  function addMoments(chart) {
    const data = chart.data;
    data.frames = frames(data);
    chart.frame = data.hottest;
    const row = document.createElement("div");
    row.className = "moment";
    const label = document.createElement("label");
    label.textContent = "time ";
    chart.output = document.createElement("output");
    chart.input = Object.assign(document.createElement("input"), { type: "range", min: 0, max: data.times.length - 1, step: 1, value: chart.frame });
    label.append(chart.output);
    chart.input.setAttribute("aria-label", "time");
    chart.input.addEventListener("input", () => showMoment(chart, +chart.input.value));
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: "hottest moment" });
    button.addEventListener("click", () => showMoment(chart, data.hottest));
    row.append(label, chart.input, button);
    if (data.times.length < 2) {
      chart.input.hidden = button.hidden = true;
    }
    chart.figure.insertBefore(row, chart.plot);
    showMoment(chart, chart.frame);
  }

  /** Option of ECharts and height of a chart. */
  function made(chart, look, width) {
    return chart.data.kind === "field" ? field(chart.data, look, width, chart.frame)
      : chart.data.kind === "lines" ? lines(chart.data, look, width, chart.places, !!chart.picks)
        : mapsAndBars[chart.data.kind](chart.data, look, width);
  }

  function draw(chart) {
    const look = reader(), { option, height } = made(chart, look, chart.plot.clientWidth);
    chart.plot.style.height = `${Math.round(height)}px`;
    const renderer = chart.data.kind === "field" ? "canvas" : "svg";
    chart.echart = window.echarts.getInstanceByDom(chart.plot) || window.echarts.init(chart.plot, null, { renderer });
    chart.echart.resize({ width: chart.plot.clientWidth, height: Math.round(height) });
    const zoom = chart.data.kind === "lines" && chart.drawn ? chart.echart.getOption().dataZoom[0] : null;
    chart.echart.setOption({ animation: false, aria: { enabled: true }, backgroundColor: "transparent",
      textStyle: { fontFamily: getComputedStyle(document.body).fontFamily }, ...option }, { notMerge: true });
    if (zoom) {
      chart.echart.dispatchAction({ type: "dataZoom", start: zoom.start, end: zoom.end });
    }
    if (chart.picks) {
      showPicks(chart, look);
    }
    chart.drawn = true;
    const shown = chart.echart.getOption().series;
    chart.figure.dataset.series = shown.length;  // for tests: what the chart itself holds
    chart.figure.dataset.last = JSON.stringify(shown[0] && shown[0].data.length ? shown[0].data[shown[0].data.length - 1] : null);
    if (chart.data.link && chart.data.kind === "lines") {
      chart.echart.group = chart.data.link;
    }
  }

  const most_names = 10;  // in the legend of a chart

  // A chart with many curves: a box for each group of them, in the place of a legend.
  function addPicks(chart) {
    const groups = [...chart.places.keys()];
    const names = new Set(chart.data.panels.flatMap((panel) => panel.series.map((s) => s.name)));
    if (names.size <= most_names) {
      return;
    }
    const box = Object.assign(document.createElement("fieldset"), { className: "picks" });
    box.append(Object.assign(document.createElement("legend"), { textContent: "curves" }));
    chart.picks = groups.map((group) => {
      const label = document.createElement("label"), input = Object.assign(document.createElement("input"), { type: "checkbox", checked: true });
      const line = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      line.innerHTML = '<line x1="0" y1="6" x2="26" y2="6" stroke-width="2.4"/>';
      line.setAttribute("width", 26);
      line.setAttribute("height", 12);
      line.setAttribute("aria-hidden", "true");
      label.append(input, line, ` ${group}`);
      box.append(label);
      const own = [...new Set(chart.data.panels.flatMap((panel) => panel.series.filter((s) => (s.group || s.name) === group).map((s) => s.name)))];
      const pick = { group, input, line: line.firstChild, own };
      input.addEventListener("change", () => apply(chart, [pick]));
      return pick;
    });
    for (const [text, checked] of [["all", true], ["none", false]]) {
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: text });
      button.addEventListener("click", () => { chart.picks.forEach((pick) => { pick.input.checked = checked; }); apply(chart, chart.picks); });
      box.append(button);
    }
    chart.figure.insertBefore(box, chart.plot.nextSibling);
  }

  function apply(chart, picks) {
    for (const pick of picks) {
      pick.own.forEach((name) => chart.echart.dispatchAction({ type: pick.input.checked ? "legendSelect" : "legendUnSelect", name }));
    }
  }

  function showPicks(chart, look) {
    for (const pick of chart.picks) {
      const { colour, dash } = chartParts.curve(chart.places.get(pick.group), look);
      pick.line.setAttribute("stroke", colour);
      pick.line.setAttribute("stroke-dasharray", dash === "solid" ? "none" : dash.join(" "));
    }
    apply(chart, chart.picks.filter((pick) => !pick.input.checked));
  }

  // For those who hear the page: what a key has done.
  function tell(chart, text) {
    if (!chart.spoken) {
      chart.spoken = document.createElement("span");
      chart.spoken.setAttribute("role", "status");
      chart.spoken.style.cssText = "position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)";
      chart.figure.append(chart.spoken);
    }
    chart.spoken.textContent = text;
  }

  function onKey(chart, event) {
    if (chart.data.kind !== "lines" || event.target !== chart.figure) {
      return;
    }
    const zoom = chart.echart.getOption().dataZoom[0];
    const middle = (zoom.start + zoom.end) / 2, half = (zoom.end - zoom.start) / 2;
    let range = null;
    if (event.key === "+" || event.key === "=") range = [middle - half / 1.5, middle + half / 1.5];
    else if (event.key === "-") range = [middle - half * 1.5, middle + half * 1.5];
    else if (event.key === "0" || event.key === "Home") range = [0, 100];
    else if (event.key === "ArrowLeft") range = [Math.max(0, zoom.start - half / 3), Math.max(2 * half, zoom.end - half / 3)];
    else if (event.key === "ArrowRight") range = [Math.min(100 - 2 * half, zoom.start + half / 3), Math.min(100, zoom.end + half / 3)];
    if (range) {
      event.preventDefault();
      const [start, end] = [Math.max(0, range[0]), Math.min(100, range[1])];
      chart.echart.dispatchAction({ type: "dataZoom", start, end });
      const { x } = chart.data, at = (percent) => number(+(x.min + 0.01 * percent * (x.max - x.min)).toPrecision(4));
      tell(chart, `${x.name} ${at(start)} to ${at(end)} ${x.unit || ""}`);
    }
  }

  function start() {
    for (const figure of document.querySelectorAll("figure.chart")) {
      const chart = { figure, plot: figure.querySelector(".plot"), data: JSON.parse(figure.querySelector("script").textContent) };
      charts.push(chart);
    }
    const places = chartParts.assign(charts.map((chart) => chart.data));
    for (const [i, chart] of charts.entries()) {
      chart.places = places[i];
      chart.figure.addEventListener("keydown", (event) => onKey(chart, event));
      if (chart.data.kind === "lines") {
        addPicks(chart);
      }
      if (chart.data.kind === "field") {
        addMoments(chart);
      } else {
        draw(chart);
      }
    }
    for (const group of new Set(charts.map((chart) => chart.data.link).filter(Boolean))) {
      window.echarts.connect(group);
    }
    const again = () => charts.forEach(draw);
    let width = window.innerWidth;
    window.addEventListener("resize", () => {
      if (window.innerWidth !== width) {
        width = window.innerWidth;
        again();
      }
    });
    dark.addEventListener("change", again);
    window.addEventListener("beforeprint", () => { document.body.classList.add("printing"); again(); });
    window.addEventListener("afterprint", () => { document.body.classList.remove("printing"); again(); });
    window.tiretherm = { charts };  // for tests
    Object.assign(window.tiretherm, { looks, made });  // for export.js
  }
  document.addEventListener("DOMContentLoaded", start);
})();
