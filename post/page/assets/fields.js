// SPDX-License-Identifier: BSD-3-Clause
// Options of ECharts for temperatures of quadrilaterals: the colours, borders and names of layers and zones, isotherms of a plane, hot
// spots with their names, the contact above an unrolled tread.
const fieldChart = (function () {
  "use strict";
  const { number, named, plain, inferno, widthOf } = chartParts;

  function frames(data) {
    const bytes = Uint8Array.from(atob(data.values), (c) => c.charCodeAt(0));
    const steps = new Uint16Array(bytes.buffer);
    const cells = steps.length / data.times.length, scale = (data.high - data.low) / 65535;
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

  // Round temperatures of isotherms, strictly between the ends of the scale.
  function levelsOf(data) {
    const about = (data.high - data.low) / 8, power = 10 ** Math.floor(Math.log10(about)), edge = 0.16 * about;
    const step = [1, 2, 2.5, 5, 10].find((one) => one * power >= 0.999 * about) * power, first = Math.ceil((data.low + edge) / step);
    return Array.from({ length: Math.max(0, Math.floor((data.high - edge) / step) - first + 1) }, (_, i) => +((first + i) * step).toPrecision(6));
  }

  // Where a field on rows and columns of cells has a level: pieces of lines between the middles of cells, straight on to the edges.
  function isotherm(data, values, level) {
    const nx = data.columns, ny = values.length / nx;
    const side = (n, cell, axis) => [cornersOf(data, cell(0))[0][axis], ...Array.from({ length: n }, (_, i) => {
      const corners = cornersOf(data, cell(i));
      return 0.5 * (corners[0][axis] + corners[2][axis]);
    }), cornersOf(data, cell(n - 1))[2][axis]];
    const x = side(nx, (i) => i, 0), y = side(ny, (i) => i * nx, 1), pieces = [];
    // At an edge it goes on as it came there from the last two cells.
    const onwards = (at, i, n, of) => {
      if (i > 0 && i <= n) return of(i - 1);
      const [last, before] = i ? [n - 1, n - 2] : [0, 1];
      return of(last) + (of(last) - of(before)) * (at[i] - at[last + 1]) / (at[last + 1] - at[before + 1]);
    };
    const T = (i, j) => onwards(y, j, ny, (row) => onwards(x, i, nx, (column) => values[row * nx + column]));
    for (let j = 0; j <= ny; j += 1) {
      for (let i = 0; i <= nx; i += 1) {
        const square = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]], crossed = [];
        square.forEach(([a, b], k) => {
          const [c, d] = square[(k + 1) % 4], from = T(a, b), to = T(c, d);
          if ((from < level) === (to < level)) return;
          const share = (level - from) / (to - from);
          crossed.push([x[a] + share * (x[c] - x[a]), y[b] + share * (y[d] - y[b])]);
        });
        for (let k = 0; k + 1 < crossed.length; k += 2) pieces.push([crossed[k], crossed[k + 1]]);
      }
    }
    return pieces;
  }

  // Each with its number in the right half, at changing heights so that numbers stay apart.
  function isotherms(data, values) {
    const levels = data.columns > 1 && values.length > data.columns && data.high > data.low ? levelsOf(data) : [];
    let placed = [];
    return { type: "custom", name: "isotherms", silent: true, z: 4, clip: true, animation: false, tooltip: { show: false }, data: levels.map((_, i) => [0, 0, i]),
      renderItem: (params, api) => {
        const i = params.dataIndex, area = params.coordSys, level = levels[i], pieces = isotherm(data, values, level).map((piece) => piece.map((p) => api.coord(p)));
        const bright = (level - data.low) / (data.high - data.low) > 0.55, place = area.y + [0.3, 0.55, 0.8][i % 3] * area.height;
        if (i === 0) placed = [];
        const path = { type: "path", shape: { pathData: pieces.map(([a, b]) => `M${a[0]} ${a[1]}L${b[0]} ${b[1]}`).join("") },
          style: { fill: "none", stroke: bright ? "rgba(0,0,0,0.6)" : "rgba(255,255,255,0.65)", lineWidth: 1 } };
        const free = pieces.map(([a]) => a).filter(([px, py]) => px > area.x + 0.5 * area.width && px < area.x + area.width - 18 && py > area.y + 9
          && py < area.y + area.height - 9 && placed.every((other) => Math.hypot(px - other[0], 1.6 * (py - other[1])) > 30));
        if (!free.length) return { type: "group", children: [path] };
        const at = free.reduce((best, p) => (Math.abs(p[1] - place) < Math.abs(best[1] - place) ? p : best));
        placed.push(at);
        return { type: "group", children: [path, { type: "text", x: at[0], y: at[1], style: { text: number(level), align: "center", verticalAlign: "middle", fontSize: 11,
          fill: bright ? "#000" : "#fff", stroke: bright ? "#fff" : "#000", lineWidth: 2 } }] };
      } };
  }

  // A bar above the map where the contact is; it may go on at the left edge.
  function contactOf(data, look, frame) {
    const contact = data.contacts && data.contacts[frame];
    return { type: "custom", name: "contact", silent: true, clip: false, animation: false, tooltip: { show: false },
      data: contact ? [-360, 0].map((turn) => [Math.max(contact[0] + turn, data.x.min), Math.min(contact[1] + turn, data.x.max)]).filter(([from, to]) => to > from) : [],
      renderItem: (params, api) => {
        const area = params.coordSys, [from, to] = [0, 1].map((i) => api.coord([api.value(i), data.y.min])[0]), text = "contact", half = 0.5 * widthOf(text) + 4;
        return { type: "group", children: [
          { type: "rect", shape: { x: from, y: area.y - 9, width: to - from, height: 6 }, style: { fill: look.ink } },
          ...(params.dataIndex ? [] : [{ type: "text", x: Math.min(Math.max(0.5 * (from + to), area.x + half), area.x + area.width - half), y: area.y - 18,
            style: { text, align: "center", verticalAlign: "middle", fontSize: 12, fill: look.ink } }])] };
      } };
  }

  // A cell whose sides lie along the axes ends at whole pixels, so that neighbours leave no seam.
  function drawnCell(data, api) {
    const fill = api.visual("color"), points = cornersOf(data, api.value(3)).map((p) => api.coord(p));
    if (data.corners !== 4) return { type: "polygon", shape: { points }, style: { fill, stroke: fill, lineWidth: 0.6 } };
    const [[x0, y0], [x1, y1]] = [points[0], points[2]].map((p) => p.map(Math.round));
    return { type: "rect", shape: { x: Math.min(x0, x1), y: Math.min(y0, y1), width: Math.abs(x1 - x0), height: Math.abs(y1 - y0) }, style: { fill } };
  }

  const axisOf = (axis, look, nameGap) => ({ type: "value", min: axis.min, max: axis.max, inverse: !!axis.down, name: named(axis), nameLocation: "middle", nameGap,
    nameTextStyle: { color: look.ink }, splitLine: { show: false }, axisLine: { onZero: false }, axisTick: { customValues: axis.ticks },
    axisLabel: { color: look.ink, hideOverlap: true, showMinLabel: false, showMaxLabel: false, formatter: number,
      ...(axis.ticks ? { customValues: axis.ticks, showMinLabel: true, showMaxLabel: true } : {}) } });

  function field(data, look, width, frame) {
    const small = width < 560, left = 62, right = small ? 18 : 110, foot = 50;
    const top = (small ? 40 : 14) + 15 * (data.spots || []).length + (data.contacts ? 26 : 0);
    const wide = Math.max(data.x.max - data.x.min, 1e-9), high = Math.max(data.y.max - data.y.min, 1e-9);
    let inner = width - left - right, tall = inner * high / wide;
    if (data.x.unit !== data.y.unit) tall = Math.min(Math.max(0.3 * inner, 160), 330);
    if (tall > 620) { tall = 620; inner = tall * wide / high; }
    tall = Math.max(tall, 60);
    const mark = data.marks && data.marks[frame];
    // Drawn at once, not in pieces over several frames: paper and slider show the whole field.
    const series = [{ type: "custom", name: "temperature", data: fieldData(data, data.frames[frame]), encode: { x: 0, y: 1, value: 2 }, clip: true, animation: false, progressive: 0,
      renderItem: (params, api) => drawnCell(data, api) }];
    series.push({ type: "custom", name: "borders", silent: true, data: (data.borders || []).map((_, i) => [0, 0, i]), z: 3, animation: false, tooltip: { show: false },
      renderItem: (params, api) => {
        const line = data.borders[params.dataIndex];
        const points = Array.from({ length: line.length / 2 }, (_, i) => api.coord([line[2 * i], line[2 * i + 1]]));
        return { type: "polyline", shape: { points }, style: { stroke: "rgba(255,255,255,0.65)", lineWidth: 1, fill: null } };
      } });
    // Names of hot spots stand above the section, a line each, so that none covers another.
    const spots = (data.spots || []).map((spot) => ({ ...spot, at: spot.at[frame] })).filter((spot) => spot.at);
    series.push({ type: "custom", name: "names of spots", silent: true, z: 8, animation: false, tooltip: { show: false }, data: spots.map((_, i) => [0, 0, i]),
      renderItem: (params, api) => {
        const i = params.dataIndex, { name, at, critical } = spots[i], text = `${name} ${at[2].toFixed(1)} °C`;
        const [x, y] = api.coord([at[0], at[1]]), row = top - 15 * (spots.length - i) + 4, half = 0.55 * widthOf(text) + 3;
        const middle = Math.min(Math.max(x + (i % 2 ? half : -half), half), width - half);
        return { type: "group", children: [
          { type: "line", shape: { x1: x, y1: row, x2: x, y2: y - 8 }, style: { stroke: look.ink, lineWidth: 1 } },
          { type: "text", x: middle, y: row, style: { text, align: "center", verticalAlign: "middle", fontSize: 12,
            fontWeight: at[2] >= critical ? "bold" : "normal", fill: look.ink, stroke: look.paper, lineWidth: 3 } }] };
      } });
    for (const spot of spots) {
      const at = spot.at, passed = at[2] >= spot.critical;
      series.push({ type: "scatter", name: spot.name, data: [at], symbol: "diamond", symbolSize: 15, z: 7, animation: false,
        itemStyle: { color: passed ? "#ffffff" : "rgba(255,255,255,0.35)", borderColor: "#000", borderWidth: 1.6 },
        tooltip: { formatter: () => `${plain(spot.name)}: ${at[2].toFixed(1)} °C, critical ${number(spot.critical)} °C` } });
    }
    series.push(layersOf(data, look, width), isotherms(data, data.frames[frame]), contactOf(data, look, frame));
    if (mark) {
      series.push({ type: "scatter", name: "hottest place", data: [[mark[0], mark[1], mark[2]]], symbolSize: 13, z: 5, animation: false,
        itemStyle: { color: "rgba(255,255,255,0.25)", borderColor: "#fff", borderWidth: 2.5, shadowColor: "#000", shadowBlur: 3 },
        tooltip: { formatter: () => `hottest place: ${mark[2].toFixed(1)} °C` } });
    }
    series.push({ type: "scatter", name: "names", silent: true, data: (data.names || []).map((n) => ({ value: [n.x, n.y], label: { formatter: n.name, align: n.align || "center" } })), symbolSize: 0, labelLayout: { hideOverlap: true },
      label: { show: true, color: look.ink, fontSize: 12 }, z: 6, animation: false, tooltip: { show: false } });
    return { height: Math.max(tall, width < 560 ? 0 : 110) + top + foot, option: {
      grid: { left, width: inner, top, height: tall },
      xAxis: axisOf(data.x, look, 26),
      yAxis: axisOf(data.y, look, 42),
      visualMap: { type: "continuous", seriesIndex: 0, dimension: 2, min: data.low, max: data.high > data.low ? data.high : data.low + 1, inRange: { color: inferno }, calculable: true,
        textStyle: { color: look.ink },
        formatter: (v) => `${(+v).toFixed(1)} °C`, ...(small
          ? { orient: "horizontal", top: 2, left: "center", itemHeight: 120, itemWidth: 12, calculable: false, text: [data.high, data.low].map((v) => `${v.toFixed(1)} °C`) }
          : { orient: "vertical", right: 0, top: "middle", itemHeight: Math.max(60, Math.min(160, tall - 30)) }) },
      tooltip: { trigger: "item", confine: true, formatter: (p) => {
        const where = data.layer_names ? plain(data.layer_names[data.layers[p.value[3]]] || "")
          : [data.x, data.y].map((axis, i) => `${axis.name} ${number(p.value[i])} ${axis.unit}`).join("<br>");
        return `${p.value[2].toFixed(2)} °C${where ? `<br>${where}` : ""}`;
      } },
      series,
    } };
  }
  return { field, frames };
})();
