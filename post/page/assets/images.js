// SPDX-License-Identifier: BSD-3-Clause
// Options of ECharts for the frames of a camera: measured, simulated, and simulated - measured, side by side or on a phone below one
// another. The first two have one scale, the differences one about zero.
const imageChart = (function () {
  "use strict";
  const { number, plain, inferno, signed, widthOf } = chartParts;
  const names = ["measured", "simulated", "simulated - measured"];
  const leftOut = "#b8b8b8";

  function panelsOf(values) {
    const half = values.length / 2, measured = values.slice(0, half), simulated = values.slice(half);
    return [measured, simulated, simulated.map((T, i) => T - measured[i])];
  }

  function panel(data, values, index) {
    const [across, down] = data.square;
    return { type: "custom", name: names[index], xAxisIndex: index, yAxisIndex: index, encode: { x: 0, y: 1, value: 2 }, clip: true, animation: false, progressive: 0,
      data: values.map((value, i) => {
        const row = Math.floor(data.pixels[i] / data.columns), column = data.pixels[i] % data.columns;
        return [-data.half_width + (column + 0.5) * across, -data.half_height + (row + 0.5) * down, value];
      }),
      renderItem: (params, api) => {
        const x = api.value(0), y = api.value(1);
        const [[x0, y0], [x1, y1]] = [-0.5, 0.5].map((s) => api.coord([x + s * across, y + s * down]).map(Math.round));
        return { type: "rect", shape: { x: x0, y: y0, width: x1 - x0, height: y1 - y0 }, style: { fill: api.visual("color") } };
      } };
  }

  function scaleOf(look, width, seriesIndex, low, high, unit, colours, middle, top) {
    const text = [high, low].map((v) => `${number(+v.toPrecision(4))} ${unit}`), length = 140;
    const total = length + 36 + text.reduce((sum, one) => sum + widthOf(one), 0);
    return { type: "continuous", seriesIndex, dimension: 2, min: low, max: high > low ? high : low + 1, inRange: { color: colours }, orient: "horizontal",
      calculable: false, itemHeight: length, itemWidth: 12, textStyle: { color: look.ink }, text,
      top, left: Math.round(Math.max(0, Math.min(middle - 0.5 * total, width - total))) };
  }

  function images(data, look, width, frame) {
    const stacked = width < 560, left = 56, gap = 44, right = 16, head = 30, foot = 46, bar = 40;
    const inner = Math.min(stacked ? width - left - right : (width - left - right - 2 * gap) / 3, 420), tall = inner * data.half_height / data.half_width;
    const at = (i) => ({ x: left + (stacked ? 0 : i * (inner + gap)), y: head + (stacked ? i * (head + tall + foot) + (i > 1 ? bar : 0) : 0) });
    const option = { grid: [], xAxis: [], yAxis: [], title: [] };
    const series = panelsOf(data.frames[frame]).map((values, i) => panel(data, values, i));
    names.forEach((name, i) => {
      const { x, y } = at(i), axis = { type: "value", gridIndex: i, splitLine: { show: false }, axisLine: { onZero: false }, axisLabel: { color: look.ink, formatter: number, hideOverlap: true, showMinLabel: false, showMaxLabel: false } };
      option.title.push({ text: name, left: x + 0.5 * inner, top: y - 24, textAlign: "center", textStyle: { fontSize: 13, color: look.ink } });
      option.grid.push({ left: x, top: y, width: inner, height: tall, outerBoundsMode: "none", show: true, backgroundColor: leftOut, borderWidth: 0 });
      option.xAxis.push({ ...axis, min: -data.half_width, max: data.half_width, name: "from the image's centre (mm)", nameLocation: "middle", nameGap: 26, nameTextStyle: { color: look.ink } });
      option.yAxis.push({ ...axis, min: -data.half_height, max: data.half_height, inverse: true });
    });
    const end = (i) => at(i).y + tall + foot;
    const first = stacked ? left + 0.5 * inner : left + inner + 0.5 * gap;
    return { height: end(2) + bar, option: { ...option,
      visualMap: [scaleOf(look, width, [0, 1], data.low, data.high, "°C", inferno, first, end(1)),
        scaleOf(look, width, [2], -data.reach, data.reach, "K", signed, at(2).x + 0.5 * inner, end(2))],
      tooltip: { trigger: "item", confine: true, formatter: (p) => {
        const [x, y, value] = p.value;
        return `${plain(p.seriesName)} ${value.toFixed(2)} ${p.seriesIndex === 2 ? "K" : "°C"}<br>${number(x)} mm across, ${number(y)} mm down`;
      } },
      series } };
  }
  return { images };
})();
