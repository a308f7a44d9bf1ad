// SPDX-License-Identifier: BSD-3-Clause
// Options of ECharts for temperatures of quadrilaterals: the colours, borders and names of layers and zones, hot spots with their names.
const fieldChart = (function () {
  "use strict";
  const { number, named, plain, inferno, widthOf } = chartParts;

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
    const small = width < 560, left = 62, right = small ? 18 : 110, top = (small ? 40 : 14) + 15 * (data.spots || []).length, foot = 50;
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
        textStyle: { color: look.ink },
        formatter: (v) => `${(+v).toFixed(1)} °C`, ...(small
          ? { orient: "horizontal", top: 2, left: "center", itemHeight: 120, itemWidth: 12, calculable: false, text: [data.high, data.low].map((v) => `${v.toFixed(1)} °C`) }
          : { orient: "vertical", right: 0, top: "middle", itemHeight: Math.max(60, Math.min(160, tall - 30)) }) },
      tooltip: { trigger: "item", confine: true, formatter: (p) => {
        const layer = data.layer_names ? data.layer_names[data.layers[p.value[3]]] : "";
        return `${p.value[2].toFixed(2)} °C${layer ? `<br>${plain(layer)}` : ""}`;
      } },
      series,
    } };
  }
  return { field, frames };
})();
