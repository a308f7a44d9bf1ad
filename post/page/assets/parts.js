// SPDX-License-Identifier: BSD-3-Clause
// What all charts of a page share: colours of curves and of fields, numbers and names of axes.
const chartParts = (function () {
  "use strict";
  // Eight colours each for light and for dark paper. They stand off from it by 3:1 or more, and from each other by a CIEDE2000 of 19 or
  // more, also as people without the cones for red or for green see them; tests/post/page/test_palette.cpp measures it.
  const curvesOnLight = ["#0548d0", "#fb5494", "#0d7e67", "#849e1b", "#4f2617", "#1e96ff", "#6c0050", "#765e00"];
  const curvesOnDark = ["#20a8fd", "#e49300", "#e4e3b1", "#2e7263", "#2ff8f9", "#bf3404", "#5361b3", "#cd93a3"];
  // matplotlib's inferno (N. J. Smith, S. van der Walt, 2015; CC0): joined by straight lines, these are within 1.5/255 of its 256.
  const inferno = ["#000004", "#040312", "#0b0724", "#150b37", "#210c4a", "#2e0a5a", "#3c0965", "#4a0c6b", "#57106d", "#63146e", "#70196e",
    "#7d1e6d", "#89226a", "#962766", "#a32b61", "#af315c", "#bb3755", "#c63e4d", "#d14644", "#db4f3b", "#e35932", "#eb6528",
    "#f1711e", "#f67f14", "#f98d0a", "#fb9c06", "#fcab0f", "#fbba1f", "#f9ca32", "#f5d949", "#f2e865", "#f3f586", "#fcffa4"];
  // From blue over a light grey to brown, lightness alike on both sides and even in L*.
  const signed = ["#004f9c", "#3b6cb0", "#6f8bc2", "#9bacd3", "#c6cde3", "#f1f1f1", "#e6c7bc", "#d69f8a", "#c1795c", "#a85332", "#8d2d06"];

  const light = { ink: "#1b1f24", faint: "#57606a", line: "#d0d7de", paper: "#ffffff", soft: "#eef1f4", curves: curvesOnLight };
  const dark = { ink: "#e6e9ec", faint: "#a3abb4", line: "#3a414a", paper: "#15181c", soft: "#2a3037", curves: curvesOnDark };

  const channels = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
  const mixed = (a, b, share) => `#${channels(a).map((c, i) => Math.round(c + share * (channels(b)[i] - c)).toString(16).padStart(2, "0")).join("")}`;

  // The look of the curve in place i of a chart: from the ninth on other shades, and other lines that tell them apart, unless
  // the chart itself says something by broken lines.
  function curve(i, look, onlySolid) {
    const n = look.curves.length, round = Math.floor(i / n) % 4, base = look.curves[i % n];
    return { colour: round === 0 ? base : round === 2 ? mixed(base, look.curves[(i + 1) % n], 0.5) : mixed(base, look.ink, round === 1 ? 0.4 : 0.65),
      dash: onlySolid ? "solid" : ["solid", [9, 3, 2, 3], [2, 2], [12, 3, 2, 3, 2, 3]][round] };
  }

  const rolesOf = (data) => new Set((data.panels || []).flatMap((panel) => panel.series.map((s) => s.role)));
  const hasBroken = (data) => ["dashed", "dotted"].some((role) => rolesOf(data).has(role));

  const groupsOf = (data) => [...new Set((data.panels || []).flatMap((panel) => panel.series.map((s) => s.group || s.name)))];

  // A place for each group of each chart: the same in all charts of a page, and never twice in one.
  function assign(all) {
    const known = new Map();
    return all.map((data) => {
      const own = new Map(), taken = new Set(), groups = groupsOf(data);
      for (const group of groups) {
        if (known.has(group) && !taken.has(known.get(group))) {
          own.set(group, known.get(group));
          taken.add(known.get(group));
        }
      }
      for (const group of groups) {
        if (own.has(group)) continue;
        let place = 0;
        while (taken.has(place)) place += 1;
        own.set(group, place);
        taken.add(place);
        if (!known.has(group)) known.set(group, place);
      }
      return own;
    });
  }

  const context = document.createElement("canvas").getContext("2d");
  // Of a text in a chart, px.
  function widthOf(text, size = 12) {
    context.font = `${size}px ${getComputedStyle(document.body).fontFamily}`;
    return context.measureText(text).width;
  }

  // Rows of a legend of these names, about.
  function rowsOf(names, width) {
    let rows = 1, reach = 0;
    for (const name of names) {
      const wide = 44 + widthOf(name);
      if (reach + wide > width && reach > 0) { rows += 1; reach = 0; }
      reach += wide;
    }
    return rows;
  }

  // A long name in lines of this width at most, px, broken at blanks and behind "_", "." and "/" alone.
  function folded(text, room) {
    const lines = [""];
    for (const piece of text.split(/(?<=[ _./])/)) {
      const last = lines.length - 1;
      if (lines[last] && widthOf((lines[last] + piece).trim()) > room) lines.push(piece);
      else lines[last] += piece;
    }
    return lines.map((line) => line.trim()).join("\n");
  }

  // Lowest and highest number of a panel: of its curves and of its levels.
  function rangeOf(panel) {
    let low = Infinity, high = -Infinity;
    const take = (v) => { if (Number.isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v); } };
    panel.series.forEach((s) => s.points.forEach((p) => p.slice(1).forEach(take)));
    (panel.levels || []).forEach((level) => take(level.value));
    return low <= high ? [low, high] : [0, 1];
  }

  // The widest number beside the panels of a chart, about.
  function widestNumber(data) {
    return Math.max(0, ...(data.panels || []).flatMap((panel) => {
      const [low, high] = rangeOf(panel), decimals = Math.max(0, -Math.floor(Math.log10(Math.max((high - low) / 5, 1e-6))));
      return [low, high].map((v) => widthOf(Math.abs(v) >= 1e5 ? number(v) : v.toFixed(Math.min(decimals, 6))));
    }));
  }

  const number = (v) => (v === null || v === undefined || Number.isNaN(v) ? "-"
    : Math.abs(v) >= 1e5 || (v !== 0 && Math.abs(v) < 1e-3) ? v.toExponential(3) : String(+v.toPrecision(5)));
  const named = (axis) => (axis.unit ? `${axis.name} (${axis.unit})` : axis.name);
  const plain = (text) => String(text).replace(/[<&]/g, "");
  return { light, dark, inferno, signed, curve, hasBroken, assign, number, named, plain, widthOf, rowsOf, folded, rangeOf, widestNumber };
})();
