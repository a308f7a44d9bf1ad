// SPDX-License-Identifier: BSD-3-Clause
// Draws each chart of a page as a picture with its title on top and leaves the pictures in the document as text, a line each:
//   INDEX PNG as base64        or, where a chart cannot be drawn,        INDEX - reason
// <body data-width="1600" data-dark data-at="600"> says how: at which moment, s or "end"; without it that which the page shows first. Runs after report.js, in a browser without a window.
(function () {
  "use strict";
  const width = +document.body.dataset.width;
  // Letters keep their share of a picture's width: a wide picture is a sharp one, not one with small letters.
  const layout = Math.max(width / 2, 640), ratio = width / layout;
  const slider = 40, margin = 14, letters = 17;

  function titleLines(context, title) {
    const lines = [""];
    for (const word of title.split(" ")) {
      const longer = lines[lines.length - 1] ? `${lines[lines.length - 1]} ${word}` : word;
      if (context.measureText(longer).width > layout - 2 * margin && lines[lines.length - 1]) {
        lines.push(word);
      } else {
        lines[lines.length - 1] = longer;
      }
    }
    return lines;
  }

  function picture(figure) {
    const chart = window.tiretherm && window.tiretherm.charts.find((one) => one.figure === figure);
    if (!chart) {
      throw new Error("a chart of this page has data that this version does not read");
    }
    const { at } = document.body.dataset, { times, time_unit: unit } = chart.data;
    if (at && times) {
      const wanted = at === "end" ? Infinity : +at / { s: 1, min: 60, h: 3600 }[unit];
      const last = times.length - 1, off = (f) => Math.abs(times[f] - wanted);
      window.tiretherm.showMoment(chart, wanted >= times[last] ? last : times.reduce((best, _, f) => (off(f) < off(best) ? f : best), 0));
    }
    const look = window.tiretherm.looks["dark" in document.body.dataset ? "dark" : "light"];
    const family = getComputedStyle(document.body).fontFamily;
    const { option, height: tall } = window.tiretherm.made(chart, look, layout, true);
    let height = tall;
    if ((option.dataZoom || []).some((zoom) => zoom.type === "slider")) {
      delete option.dataZoom;
      height -= slider;
    }
    for (const scale of [option.visualMap || []].flat()) {  // handles are for a hand; they have the ends of the scale
      const { min, max, formatter, text } = scale;
      Object.assign(scale, { calculable: false, text: text || [formatter(max), formatter(min)] });
    }
    option.series.forEach((series) => { series.progressive = 0; });  // all at once, not over several frames
    const place = document.body.appendChild(document.createElement("div"));
    const drawn = window.echarts.init(place, null, { renderer: "canvas", width: layout, height, devicePixelRatio: ratio });
    drawn.setOption({ animation: false, backgroundColor: look.paper, textStyle: { fontFamily: family }, ...option });
    const image = drawn.renderToCanvas({ pixelRatio: ratio, backgroundColor: look.paper });

    const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
    const font = `bold ${letters}px ${family}`;
    context.font = font;
    const lines = titleLines(context, chart.figure.getAttribute("aria-label") + (chart.output ? `, ${chart.output.textContent}` : ""));
    const top = Math.ceil(margin + 1.35 * letters * lines.length + 4);
    canvas.width = width;
    canvas.height = Math.ceil((top + height) * ratio);
    context.fillStyle = look.paper;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(image, 0, Math.round(top * ratio));
    context.scale(ratio, ratio);
    context.fillStyle = look.ink;
    context.font = font;
    lines.forEach((line, i) => context.fillText(line, margin, margin + letters * (0.9 + 1.35 * i)));
    const png = canvas.toDataURL("image/png").split(",")[1];
    if (!png) {
      throw new Error(`a picture of ${canvas.width} x ${canvas.height} pixels is too large`);
    }
    drawn.dispose();
    place.remove();
    return png;
  }

  document.addEventListener("DOMContentLoaded", () => {
    const figures = [...document.querySelectorAll("figure.chart")];
    const lines = figures.map((figure, i) => {
      try {
        return `${i} ${picture(figure)}`;
      } catch (error) {
        return `${i} - ${String(error.message).replace(/[\n<>&]/g, " ")}`;
      }
    });
    const found = document.createElement("pre");
    found.id = "pictures";
    found.textContent = `\n${lines.join("\n")}\n`;
    document.head.replaceChildren();
    document.body.replaceChildren(found);
  });
})();
