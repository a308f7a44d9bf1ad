// SPDX-License-Identifier: BSD-3-Clause
// Draws the charts of a page with Apache ECharts. Each <figure class="chart"> holds its data as JSON:
//   lines: panels above one another over one axis, with measured points, bands, levels, marks and spans
//   field: temperatures at several moments, with a slider: see fields.js
//   images: frames of a camera, with a slider: see images.js
//   bars, cells: see maps_and_bars.js
// Keys on a chart: + and - zoom, the arrows move, 0 shows all.
(function () {
  "use strict";
  const charts = [];
  let numberRoom = 30;  // px beside the panels of all charts of the page: their axes stand below one another
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  const { number, named, widthOf } = chartParts;
  const looks = { dark: chartParts.dark, light: chartParts.light };
  const reader = () => looks[dark.matches && !document.body.classList.contains("printing") ? "dark" : "light"];

  // They stand at the foot of the panel, where curves are rare, a line each.
  function namesOfMarks(marks, index, look) {
    return { type: "custom", name: "names of marks", silent: true, clip: false, z: 6, xAxisIndex: index, yAxisIndex: index, tooltip: { show: false }, data: marks.map((mark) => [mark.x, mark.y]),
      renderItem: (params, api) => {
        const i = params.dataIndex, area = params.coordSys, x = api.coord([marks[i].x, marks[i].y])[0], before = x > area.x + 0.5 * area.width;
        return x < area.x || x > area.x + area.width ? null : { type: "text", x: x + (before ? -7 : 7), y: area.y + area.height - 12 - 17 * (marks.length - 1 - i),
          style: { text: marks[i].name, align: before ? "right" : "left", verticalAlign: "middle", fontSize: 12, fill: look.ink, stroke: look.paper, lineWidth: 3 } };
      } };
  }

  // "belt edge, whole tire: critical 110 °C" of several at one height.
  function nameOfLevel(names) {
    const [what] = (names[0] || "").match(/:.*$/) || [""];
    return names.every((name) => name.endsWith(what)) ? names.map((name) => name.slice(0, name.length - what.length)).join(", ") + what : names.join("; ");
  }

  function seriesOf(panel, index, places, look, data, height) {
    const made = [], onlySolid = chartParts.hasBroken(data), [low, high] = chartParts.rangeOf(panel);
    for (const s of panel.series) {
      const { colour: of, dash } = chartParts.curve(places.get(s.group || s.name), look, onlySolid);
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
      const points = s.role === "points", many = points && s.points.length > 300;  // drawn as one shape
      made.push({ type: points ? "scatter" : "line", name: s.name, xAxisIndex: index, yAxisIndex: index, data: s.points,
        large: many, largeThreshold: 0, showSymbol: false, symbol: many ? "rect" : points ? "circle" : "none", symbolSize: many ? 4 : 5, itemStyle: { color: of, opacity: many ? 0.35 : points ? 0.75 : 1 },
        lineStyle: { color: of, width: s.role === "line" ? 1.8 : s.role === "faint" ? 0.8 : 1.5, opacity: s.role === "line" ? 1 : s.role === "faint" ? 0.35 : 0.75, type: s.role === "dashed" ? [7, 4] : s.role === "dotted" ? [2, 3] : dash }, z: points ? 2 : 3 });
    }
    for (const mark of panel.marks || []) {
      const { colour: of } = chartParts.curve(places.get(mark.group) || 0, look);
      made.push({ type: "scatter", name: "marks", xAxisIndex: index, yAxisIndex: index, data: [[mark.x, mark.y]], symbol: "circle", symbolSize: 9, z: 6, silent: true,
        itemStyle: { color: look.paper, borderColor: of, borderWidth: 2 }, tooltip: { show: false },
        markLine: { symbol: "none", silent: true, lineStyle: { color: of, width: 1, type: "dotted" }, label: { show: false }, data: [{ xAxis: mark.x }] } });
    }
    made.push(...(data.roomy && (panel.marks || []).length ? [namesOfMarks(panel.marks, index, look)] : []));
    // Names of levels that lie close together stand below the line, or at its other end.
    const sides = ["insideStartTop", "insideStartBottom", "insideEndTop", "insideEndBottom"];
    // A level near the top has its name below it: above it stand those of steps, but for a phone.
    const heights = [...new Set((panel.levels || []).map((level) => level.value))].sort((a, b) => b - a);
    let close = data.roomy && heights.length && heights[0] - low > 0.75 * (high - low) ? 1 : 0;
    const levels = heights.map((value, i) => {
      close = i > 0 && (heights[i - 1] - value) / Math.max(high - low, 1e-9) * height < 34 ? close + 1 : i > 0 ? 0 : close;
      return { yAxis: value, label: { position: sides[close % sides.length], lineHeight: 15, color: look.ink, textBorderColor: look.paper, textBorderWidth: 3,
        formatter: nameOfLevel(panel.levels.filter((level) => level.value === value && level.name).map((level) => level.name)) } };
    });
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
        const fits = named && span.name && share * (span.to - span.from) > widthOf(span.name, 11) + 6;
        const shaded = span.name ? held++ % 2 === 1 : false;
        return [{ xAxis: span.from, name: fits ? span.name : "", itemStyle: { color: shaded ? look.line : look.soft, opacity: span.name ? 0.55 : 0 } }, { xAxis: span.to }];
      }) };
  }

  function lines(data, look, width, places, picks) {
    data.roomy = width >= 560;
    const names = [...new Set(data.panels.flatMap((panel) => panel.series.map((s) => s.name)))];
    const roles = new Map(data.panels.flatMap((panel) => panel.series.map((s) => [s.name, s.role])));
    const printing = document.body.classList.contains("printing");
    const small = !data.roomy, gap = 34, left = numberRoom + 36, right = 22, foot = printing ? 54 : 96;  // room for the zoom, which paper has not
    const legendLeft = small ? 4 : left;
    const top = 20 + 24 * (picks ? 0 : chartParts.rowsOf(names, width - legendLeft - right));  // picks stand below the chart
    const tall = data.panels.map((panel) => (panel.short ? 130 : small ? 250 : 340));
    const sum = tall.reduce((all, one) => all + one, 0), room = 590 - gap * (tall.length - 1);  // of a sheet of paper
    const heights = tall.map((one) => (printing && sum > room ? Math.floor(one * room / sum) : one));
    const option = { grid: [], xAxis: [], yAxis: [], series: [] };
    let y = top;
    data.panels.forEach((panel, i) => {
      const last = i + 1 === data.panels.length;
      option.grid.push({ left, right, top: y, height: heights[i], outerBoundsMode: "none" });
      option.xAxis.push({ type: "value", gridIndex: i, min: data.x.min, max: data.x.max, name: last ? named(data.x) : "", nameLocation: "middle", nameGap: 28,
        axisLabel: { show: last, color: look.ink, hideOverlap: true }, nameTextStyle: { color: look.ink }, axisLine: { onZero: false, lineStyle: { color: look.faint } },
        splitLine: { lineStyle: { color: look.soft } }, axisPointer: { label: { show: last } } });
      placed(option.xAxis[i], data.x);
      option.yAxis.push({ type: "value", gridIndex: i, scale: true, name: named(panel), nameLocation: "middle", nameGap: numberRoom + 14, nameTextStyle: { color: look.ink },
        axisLabel: { color: look.ink, formatter: (v) => number(v) }, axisLine: { show: true, onZero: false, lineStyle: { color: look.faint } }, splitLine: { lineStyle: { color: look.line } } });
      const made = seriesOf(panel, i, places, look, data, heights[i]);
      const first = made.find((series) => series.type === "line") || made[0];
      if (first && (data.spans || []).length) {
        first.markArea = bandsOf(data, look, width - left - right, i === 0 && (data.roomy || !(panel.levels || []).length));
      }
      option.series.push(...made);
      y += heights[i] + gap;
    });
    const all = data.panels.map((_, i) => i);
    Object.assign(option, {
      legend: { show: !picks, top: 2, left: legendLeft, right, itemWidth: 28, textStyle: { color: look.ink },
        data: names.map((name) => ({ name, ...(roles.get(name) === "points" ? { icon: "circle" } : {}),
          itemStyle: { opacity: ["points", "range", "band"].includes(roles.get(name)) ? 1 : 0 } })) },
      tooltip: { trigger: "axis", confine: true, valueFormatter: number },
      axisPointer: { link: [{ xAxisIndex: "all" }] },
      dataZoom: [{ type: "inside", xAxisIndex: all, filterMode: "none", zoomOnMouseWheel: "ctrl", moveOnMouseMove: true },
        { type: "slider", show: !printing, xAxisIndex: all, filterMode: "none", left, right, bottom: 18, height: 20, showDataShadow: false, textStyle: { color: look.ink } }],
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
    data.frames = fieldChart.frames(data);
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
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: data.first || "hottest moment" });
    button.addEventListener("click", () => showMoment(chart, data.hottest));
    row.append(label, chart.input, button);
    if (data.times.length < 2) {
      chart.input.hidden = button.hidden = true;
    }
    chart.figure.insertBefore(row, chart.plot);
    showMoment(chart, chart.frame);
  }

  /** Option of ECharts and height of a chart. @param alone a picture, which has no boxes beside it and needs its legend */
  function made(chart, look, width, alone) {
    return chart.data.kind === "field" ? fieldChart.field(chart.data, look, width, chart.frame)
      : chart.data.kind === "images" ? imageChart.images(chart.data, look, width, chart.frame)
      : chart.data.kind === "lines" ? lines(chart.data, look, width, chart.places, !!chart.picks && !alone)
        : mapsAndBars[chart.data.kind](chart.data, look, width);
  }

  function draw(chart) {
    const look = reader(), { option, height } = made(chart, look, chart.plot.clientWidth);
    chart.plot.style.height = `${Math.round(height)}px`;
    const renderer = chart.data.times ? "canvas" : "svg";
    chart.echart = window.echarts.getInstanceByDom(chart.plot) || window.echarts.init(chart.plot, null, { renderer });
    chart.echart.resize({ width: chart.plot.clientWidth, height: Math.round(height) });
    if (chart.data.kind === "lines" && chart.drawn) {
      const { start, end } = chart.echart.getOption().dataZoom[0];
      option.dataZoom.forEach((zoom) => Object.assign(zoom, { start, end }));
    }
    chart.echart.setOption({ animation: false, aria: { enabled: true }, backgroundColor: "transparent",
      textStyle: { fontFamily: getComputedStyle(document.body).fontFamily }, ...option }, { notMerge: true });
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
      const { colour, dash } = chartParts.curve(chart.places.get(pick.group), look, chartParts.hasBroken(chart.data));
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

  // On a phone a table that is too wide is set row by row, see report.css: each number beside the heading of its column.
  function stackTables() {
    for (const box of document.querySelectorAll(".scroll")) {
      const [head] = box.querySelectorAll("thead tr");
      const headings = head ? [...head.cells].map((cell) => cell.textContent) : [];
      for (const row of box.querySelectorAll("tbody tr")) {
        const cells = [...row.cells], first = cells.findIndex((cell) => cell.textContent);
        const isRight = (i) => !!cells[i] && cells[i].classList.contains("right");
        const isRank = !!head && !headings[first] && isRight(first) && !!cells[first + 1] && !isRight(first + 1);  // the order tells it
        row.classList.toggle("part", first > 0);
        cells.forEach((cell, i) => {
          const isName = i === first + (isRank ? 1 : 0) && (!!head || i === 0);
          cell.classList.toggle("rank", isRank && i === first);
          cell.classList.toggle("name", isName);
          if (headings[i] && (!isName || (first === 0 ? isRight(i) : /^\d+$/.test(cell.textContent)))) cell.dataset.heading = headings[i];
        });
      }
      box.classList.remove("stacked");
      box.classList.toggle("stacked", box.scrollWidth > box.clientWidth + 1);
    }
  }

  function start() {
    stackTables();
    for (const figure of document.querySelectorAll("figure.chart")) {
      const chart = { figure, plot: figure.querySelector(".plot"), data: JSON.parse(figure.querySelector("script").textContent) };
      charts.push(chart);
    }
    const places = chartParts.assign(charts.map((chart) => chart.data));
    numberRoom = Math.max(numberRoom, ...charts.map((chart) => Math.ceil(chartParts.widestNumber(chart.data))));
    for (const [i, chart] of charts.entries()) {
      chart.places = places[i];
      chart.figure.addEventListener("keydown", (event) => onKey(chart, event));
      if (chart.data.kind === "lines") {
        addPicks(chart);
      }
      try {
        (chart.data.times ? addMoments : draw)(chart);
      } catch (error) {  // the others are drawn
        chart.plot.textContent = `This chart cannot be drawn: ${error.message}`;
        chart.failed = true;
      }
    }
    for (const group of new Set(charts.map((chart) => chart.data.link).filter(Boolean))) {
      window.echarts.connect(group);
    }
    const again = () => charts.filter((chart) => !chart.failed).forEach(draw);
    let width = window.innerWidth;
    window.addEventListener("resize", () => {
      if (window.innerWidth !== width) {
        width = window.innerWidth;
        stackTables();
        again();
      }
    });
    dark.addEventListener("change", again);
    window.addEventListener("beforeprint", () => { document.body.classList.add("printing"); again(); });
    window.addEventListener("afterprint", () => { document.body.classList.remove("printing"); again(); });
    window.tiretherm = { charts };  // for tests
    Object.assign(window.tiretherm, { looks, made, showMoment });  // for export.js
  }
  document.addEventListener("DOMContentLoaded", start);
})();
