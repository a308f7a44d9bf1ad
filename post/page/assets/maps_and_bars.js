// SPDX-License-Identifier: BSD-3-Clause
// Options of ECharts for what has no curves:
//   bars:  signed values by name, with intervals, or several side by side
//   cells: rectangles with a colour for their value, over numbers or words
const mapsAndBars = (function () {
  "use strict";
  const { number, named, plain, inferno, signed, widthOf, folded } = chartParts;

  // A level as a line across the bars; its name stands above.
  function levelsOf(data, look) {
    return { symbol: "none", silent: true, lineStyle: { color: look.ink, type: "dashed" },
      data: (data.levels || []).map((level) => ({ xAxis: level.value, label: { formatter: level.name, color: look.ink, position: "end" } })) };
  }

  function intervals(items, look) {
    return { type: "custom", name: "95 %", silent: true, z: 5, tooltip: { show: false }, encode: { x: [0, 1], y: 2 },
      data: items.map((item, i) => [item.low, item.high, i]).filter((p) => p[0] !== undefined && p[0] !== null),
      renderItem: (params, api) => {
        const a = api.coord([api.value(0), api.value(2)]), b = api.coord([api.value(1), api.value(2)]);
        const line = (x1, y1, x2, y2) => ({ type: "line", shape: { x1, y1, x2, y2 }, style: { stroke: look.ink, lineWidth: 1.6 } });
        return { type: "group", children: [line(a[0], a[1], b[0], b[1]), line(a[0], a[1] - 5, a[0], a[1] + 5), line(b[0], b[1] - 5, b[0], b[1] + 5)] };
      } };
  }

  function bars(data, look, width) {
    const items = [...data.items].reverse(), names = data.series || [], of = Math.max(names.length, 1);
    const small = width < 560, top = 10 + (names.length ? 24 * chartParts.rowsOf(names, width - 24) : 0) + ((data.levels || []).some((level) => level.name) ? 20 : 0);
    const above = small ? 18 : 0;  // px for the name, which stands over its bars where there is no room beside them
    const height = top + 62 + (16 + 16 * of + above) * items.length;
    const shade = (i) => chartParts.curve(i, look).colour;
    const label = { show: true, position: "right", color: look.ink, formatter: (p) => number(p.value) };
    const series = names.length
      ? names.map((name, s) => ({ type: "bar", name, data: items.map((item) => item.values[s]), barMaxWidth: 16, barGap: "10%", itemStyle: { color: shade(s) }, label }))
      : [{ type: "bar", name: data.x.name, barMaxWidth: 18, label: { ...label, show: !items.some((item) => item.low !== undefined) },
          data: items.map((item) => ({ value: item.value, itemStyle: { color: shade(item.value < 0 ? 0 : 1),
            ...(item.marked ? { borderColor: look.ink, borderWidth: 2 } : {}) }, label: { position: item.value < 0 ? "left" : "right" } })) }];
    if ((data.levels || []).length) series[0].markLine = levelsOf(data, look);
    if (items.some((item) => item.low !== undefined)) series.push(intervals(items, look));
    const least = items.some((item) => item.value < 0) ? (small ? "24%" : "9%") : 0;
    return { height, option: {
      grid: { left: 10, right: 64, top, bottom: 46, containLabel: true },
      legend: { show: names.length > 0, top: 2, data: names, textStyle: { color: look.ink } },
      // Beyond the longest bar there is room for its number.
      xAxis: { type: "value", boundaryGap: [least, "9%"], name: named(data.x), nameLocation: "middle", nameGap: 28, nameTextStyle: { color: look.ink },
        axisLabel: { color: look.ink, hideOverlap: true, formatter: number }, splitLine: { lineStyle: { color: look.line } } },
      yAxis: { type: "category", data: items.map((item) => item.name), axisTick: { show: false }, z: 4,
        axisLabel: { color: look.ink, width: small ? width - 30 : 340, overflow: "truncate", interval: 0, inside: small, margin: small ? 0 : 8,
          ...(small ? { verticalAlign: "bottom", padding: [0, 0, 8 * of + 4, 0] } : {}) } },
      tooltip: { trigger: "axis", axisPointer: { type: "shadow" }, confine: true, formatter: (rows) => {
        const item = items[rows[0].dataIndex], unit = data.x.unit || "";
        const interval = item.low === undefined ? "" : `<br>95 %: ${number(item.low)} to ${number(item.high)} ${unit}`;
        return `${plain(item.name)}<br>${rows.filter((row) => row.seriesType === "bar").map((row) =>
          `${plain(row.seriesName)}: ${number(row.value)} ${unit}`).join("<br>")}${interval}`;
      } },
      series,
    } };
  }

  const axisOf = (axis, look, extra) => ({ type: "value", min: axis.words ? 0 : axis.min, max: axis.words ? axis.words.length : axis.max,
    name: named(axis), nameLocation: "middle", nameTextStyle: { color: look.ink }, splitLine: { show: false }, axisLine: { onZero: false },
    ...(axis.words ? { interval: 1, axisTick: { show: false }, axisLabel: { show: false } }
      : { axisLabel: { color: look.ink, hideOverlap: true, formatter: number } }), ...extra });

  // Words stand upright where two lines have room for them, without a break inside a name.
  const areTurned = (words, step) => words.some((word) => widthOf(word) > 2 * step - 24 || word.split(" ").some((part) => widthOf(part) > step - 6));

  // The words of an axis, each in the middle of its step. ECharts has no axis of numbers with words between the marks.
  function wordsOf(data, look, side, room) {
    const words = data[side].words || [], along = side === "x";
    return { type: "custom", name: `${side} words`, silent: true, clip: false, tooltip: { show: false }, data: words.map((_, i) => [0, 0, i]),
      renderItem: (params, api) => {
        const i = params.dataIndex, area = params.coordSys, at = api.coord(along ? [i + 0.5, 0] : [0, i + 0.5]);
        const step = along ? area.width / words.length : area.height / words.length;
        const turned = along && areTurned(words, step);
        return { type: "text", x: along ? at[0] : area.x - 8, y: along ? area.y + area.height + 8 : at[1], rotation: turned ? 0.7 : 0,
          style: { text: folded(words[i], along && !turned ? step - 6 : room), fill: look.ink, fontSize: 12, lineHeight: turned || !along ? 13 : 15,
            align: along && !turned ? "center" : "right", verticalAlign: along ? "top" : "middle" } };
      } };
  }

  function cells(data, look, width) {
    const small = width < 560, words = (axis) => (axis.words || []).reduce((most, word) => Math.max(most, widthOf(word) + 4), 0);
    const room = { x: Math.min(words(data.x), small ? 130 : 210), y: Math.min(words(data.y), small ? 110 : 260) };
    const left = data.y.words ? 14 + room.y + (data.y.name ? 22 : 0) : 66, right = small ? 18 : 118;
    const inner = Math.max(width - left - right, 80);
    const turned = data.x.words && areTurned(data.x.words, inner / data.x.words.length);
    const foot = data.x.words ? 34 + (turned ? 0.65 * room.x + 8 : 28) : 52, top = small ? 46 : 14;
    const rows = data.y.words ? data.y.words.length : 12;
    const tall = Math.min(Math.max(rows * 30, 90), data.y.words ? 620 : 400);
    const values = data.cells.map((cell, i) => [0.5 * (cell.at[0] + cell.at[1]), 0.5 * (cell.at[2] + cell.at[3]), cell.at[4], i]);
    const shown = (cell) => cell.text || number(+cell.at[4].toPrecision(data.signed ? 2 : 4));
    // Black stands off better where the relative luminance (WCAG) is above 0.18: at least 4.6:1 either way.
    const linear = (c) => ((c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    const channels = (css) => (css[0] === "#" ? [1, 3, 5].map((i) => parseInt(css.slice(i, i + 2), 16)) : (css.match(/\d+(\.\d+)?/g) || [0, 0, 0]).map(Number));
    const isLight = (css) => { const [r, g, b] = channels(css).map(linear); return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.18; };
    const series = [{ type: "custom", name: data.name, data: values, encode: { x: 0, y: 1, value: 2 }, clip: true,
      renderItem: (params, api) => {
        const cell = data.cells[api.value(3)], a = api.coord([cell.at[0], cell.at[2]]), b = api.coord([cell.at[1], cell.at[3]]);
        const fill = api.visual("color"), wide = Math.abs(b[0] - a[0]), high = Math.abs(b[1] - a[1]), text = shown(cell);
        const rect = { type: "rect", shape: { x: Math.min(a[0], b[0]), y: Math.min(a[1], b[1]), width: wide, height: high },
          style: { fill, stroke: look.paper, lineWidth: wide > 6 && high > 6 ? 1 : 0 } };
        const children = [rect];
        if (cell.marked) children.push({ type: "rect", z2: 10, shape: { x: rect.shape.x + 2, y: rect.shape.y + 2, width: Math.max(wide - 4, 1), height: Math.max(high - 4, 1) },
          style: { fill: "none", stroke: isLight(fill) ? "#000" : "#fff", lineWidth: 1.8, lineDash: [5, 3] } });
        if (wide > 6.6 * text.length + 4 && high > 15) children.push({ type: "text", z2: 11, x: rect.shape.x + wide / 2, y: rect.shape.y + high / 2,
          style: { text, fill: isLight(fill) ? "#000" : "#fff", fontSize: 11, align: "center", verticalAlign: "middle" } });
        return { type: "group", children };
      } }];
    if (data.x.words) series.push(wordsOf(data, look, "x", room.x));
    if (data.y.words) series.push(wordsOf(data, look, "y", room.y));
    const wordAt = (axis, v) => (axis.words ? plain(axis.words[Math.floor(v)]) : `${plain(axis.name)} ${number(v)} ${plain(axis.unit || "")}`);
    return { height: tall + top + foot, option: {
      grid: { left, width: inner, top, height: tall },
      xAxis: axisOf(data.x, look, { nameGap: data.x.words ? foot - 18 : 28 }),
      yAxis: axisOf(data.y, look, { inverse: !!data.y.words, nameGap: data.y.words ? left - 16 : 48 }),
      visualMap: { type: "continuous", seriesIndex: 0, dimension: 2, min: data.low, max: data.high > data.low ? data.high : data.low + 1,
        inRange: { color: data.signed ? signed : inferno }, textStyle: { color: look.ink }, calculable: false,
        ...(small ? { orient: "horizontal", top: 2, left: "center", itemHeight: 120, itemWidth: 12 }
          : { orient: "vertical", right: 2, top: "middle", itemHeight: Math.max(60, Math.min(150, tall - 50)) }),
        text: [`${number(data.high)} ${data.unit || ""}`, `${number(data.low)} ${data.unit || ""}`] },
      tooltip: { trigger: "item", confine: true, formatter: (p) => {
        const cell = data.cells[p.value[3]];
        return `${plain(data.name)}: ${cell.text ? plain(cell.text) : number(cell.at[4])} ${plain(data.unit || "")}<br>${wordAt(data.y, p.value[1])}<br>${wordAt(data.x, p.value[0])}${
          cell.marked && data.marked ? `<br>${plain(data.marked)}` : ""}`;
      } },
      series,
    } };
  }
  return { bars, cells };
})();
