// SPDX-License-Identifier: BSD-3-Clause
// The page of a live session: the tires as they are now, and curves of what they were.
(function () {
  "use strict";
  const { light, dark, inferno, curve, plain, number } = chartParts;
  const at = (id) => document.getElementById(id), words = (name) => name.replaceAll("_", " ");
  const kept = 600, closest = 0.5;  // s of a curve, and between its points
  const pause = 250, patience = 2000;  // ms
  const paper = matchMedia("(prefers-color-scheme: dark)");
  let tires = [], chart = null, frame = null, due = false, heard = 0;

  // Of the scale from low to high, and black or white on it, whichever is easier to read.
  const shade = (share) => inferno[Math.round(Math.min(1, Math.max(0, share)) * (inferno.length - 1))];
  function onShade(hex) {
    const [r, g, b] = [1, 3, 5].map((i) => (parseInt(hex.slice(i, i + 2), 16) / 255) ** 2.2);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.18 ? "#000000" : "#ffffff";
  }

  // What an output is now as users see it; a sensor that reads nothing has null.
  function shown(tire, output) {
    const value = frame.tires[tire.name][output.name];
    return value === null ? null : output.shown.factor * (value - output.shown.zero);
  }
  const unit = (output) => ({ degC: "°C", 1: "" })[output.shown.unit] ?? output.shown.unit;
  function spelt(output, value) {
    if (value === null) return "–";
    return `${output.unit === "K" ? value.toFixed(1) : number(value)} ${unit(output)}`.trim();
  }

  function rowOf(output) {
    const row = document.createElement("div"), name = document.createElement("dt"), value = document.createElement("dd");
    name.textContent = words(output.name);
    row.className = output.unit === "K" ? "" : "small";
    row.append(name, value);
    return row;
  }

  function begin(hello) {
    at("title").textContent = hello.title || hello.case;
    at("source").textContent = hello.case;
    at("version").textContent = hello.tiretherm;
    tires = Object.entries(hello.tires).map(([name, { outputs }]) => ({ name, outputs: outputs.map((output) => ({ ...output, row: rowOf(output), points: [] })) }));
    at("tires").className = tires.length > 1 ? "" : "one";
    at("tires").replaceChildren(...tires.map((tire) => {
      const drawn = document.createElement("section"), heading = document.createElement("h2"), rows = document.createElement("dl");
      heading.textContent = tire.name;
      drawn.className = "tire";
      rows.append(...tire.outputs.map((output) => output.row));
      drawn.append(heading, rows);
      return drawn;
    }));
    at("ramp").style.background = `linear-gradient(90deg, ${inferno.join(",")})`;
    frame = null;
    layOut();
  }

  const temperatures = () => tires.flatMap((tire, t) => tire.outputs.filter((output) => output.unit === "K").map((output, o) => ({ tire, t, output, o })));

  // Four tires: a panel for each place, a curve for each tire. One tire: all its places in one panel.
  function panels() {
    return tires.length > 1 ? [...new Set(temperatures().map(({ output }) => output.name))] : [""];
  }

  function layOut() {
    if (chart) chart.dispose();
    const names = panels(), look = paper.matches ? dark : light, label = { color: look.faint, fontSize: 12 }, line = { lineStyle: { color: look.line } };
    const panelHeight = Math.min(330, Math.max(200, (innerHeight - 380) / names.length));  // px
    at("plot").style.height = `${50 + names.length * panelHeight}px`;
    chart = echarts.init(at("plot"), null, { renderer: "svg" });
    window.tiretherm = { charts: [{ echart: chart, data: { kind: "lines" } }] };
    chart.setOption({
      animation: false,
      textStyle: { fontFamily: getComputedStyle(document.body).fontFamily },
      legend: { top: 0, type: "scroll", textStyle: { color: look.ink, fontSize: 12 }, pageTextStyle: label },
      tooltip: { trigger: "axis", confine: true, valueFormatter: (v) => `${v.toFixed(1)} °C` },
      grid: names.map((_, i) => ({ left: 52, right: 18, top: 56 + i * panelHeight, height: panelHeight - 66 })),
      xAxis: names.map((_, i) => ({ type: "value", gridIndex: i, scale: true, min: "dataMin", max: "dataMax",
        axisLabel: { ...label, formatter: number, showMaxLabel: false }, axisLine: line, splitLine: line,
        name: i + 1 === names.length ? "time (s)" : "", nameLocation: "middle", nameGap: 26, nameTextStyle: label })),
      yAxis: names.map((name, i) => ({ type: "value", gridIndex: i, scale: true, axisLabel: label, axisLine: line, splitLine: line,
        name: plain(`${words(name)} (°C)`).trim(), nameTextStyle: { ...label, align: "left", padding: [0, 0, 0, -44] } })),
    });
    draw();
  }

  function drawCurves() {
    const look = paper.matches ? dark : light, names = panels(), several = tires.length > 1;
    chart.setOption({ series: temperatures().map(({ tire, t, output, o }, id) => {
      const drawn = curve(several ? t : o, look), panel = several ? names.indexOf(output.name) : 0;
      return { id, type: "line", name: several ? tire.name : words(output.name), xAxisIndex: panel, yAxisIndex: panel, data: output.points, symbol: "none",
        lineStyle: { color: drawn.colour, type: drawn.dash, width: 2 }, itemStyle: { color: drawn.colour } };
    }) });
  }

  function drawTires() {
    const now = temperatures().map((one) => ({ ...one, value: shown(one.tire, one.output) })).filter(({ value }) => value !== null);
    const values = now.map(({ value }) => value), step = 20;
    const low = step * Math.floor(Math.min(step, ...values) / step), high = step * Math.ceil(Math.max(5 * step, ...values) / step);
    at("low").textContent = `${low} °C`;
    at("high").textContent = `${high} °C`;
    tires.forEach((tire) => tire.outputs.forEach((output) => { output.row.lastChild.textContent = spelt(output, shown(tire, output)); }));
    now.forEach(({ output, value }) => {
      const colour = shade((value - low) / (high - low));
      output.row.style.background = colour;
      output.row.style.color = onShade(colour);
    });
    const hottest = now.reduce((a, b) => (b.value > a.value ? b : a), now[0]);
    at("answer").textContent = hottest ? `Hottest: ${tires.length > 1 ? hottest.tire.name + ", " : ""}${words(hottest.output.name)}, ${spelt(hottest.output, hottest.value)}` : "";
  }

  function draw() {
    due = false;
    if (!chart) return;
    drawCurves();
    if (!frame) return;
    drawTires();
    at("clock").textContent = frame.step ? `${frame.time.toFixed(1)} s, step ${frame.step}` : "";
  }

  function say(state) {
    if (at("state").textContent !== state) at("state").textContent = state;
  }
  const tellPace = () => say(!frame.step ? "Waiting for a simulator." : Date.now() - heard < patience ? "Running:" : "The simulator is silent:");

  function take(next) {
    if (frame && (next.step < frame.step || next.time < frame.time)) {
      tires.forEach((tire) => tire.outputs.forEach((output) => { output.points = []; }));
    }
    frame = next;
    heard = Date.now();
    tellPace();
    temperatures().forEach(({ tire, output }) => {
      const points = output.points;
      if (points.length > 1 && next.time - points[points.length - 2][0] < closest) points.pop();
      points.push([next.time, shown(tire, output)]);
      while (points[0][0] < next.time - kept) points.shift();
    });
    if (!due) {
      due = true;
      setTimeout(draw, pause);
    }
  }

  const source = new EventSource("events");
  source.addEventListener("hello", (event) => begin(JSON.parse(event.data)));
  source.onmessage = (event) => take(JSON.parse(event.data));
  source.onerror = () => say("The session has ended.");
  setInterval(() => { if (frame && source.readyState === EventSource.OPEN) tellPace(); }, pause);
  paper.addEventListener("change", layOut);
  addEventListener("resize", () => chart && chart.resize());
})();
