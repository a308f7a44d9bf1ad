# SPDX-License-Identifier: BSD-3-Clause
"""A page can be read by everybody: the rules of axe-core for WCAG 2.1, level AA, and what they do not look at: the charts."""
import pathlib

AXE = pathlib.Path(__file__).parent / "axe" / "axe.min.js"
RUN_AXE = """const done = arguments[0];
axe.run({runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"], resultTypes: ["violations"]}).then((found) => done(found.violations.map(
  (rule) => [rule.id, rule.help, rule.nodes.length, rule.nodes[0].target.join(" "), rule.nodes[0].any.map((check) => check.message)[0] || ""])),
  (failure) => done([["axe", String(failure), 1, "", ""]]));"""
# Texts of the charts: contrast with the paper (WCAG 1.4.3: 4.5) and size; curves: contrast of 3 (1.4.11).
CHARTS = """const channel = (v) => (v /= 255, v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
const light = (c) => 0.2126 * channel(c[0]) + 0.7152 * channel(c[1]) + 0.0722 * channel(c[2]);
const parts = (text) => (text.match(/[\\d.]+/g) || []).map(Number);
const paper = parts(getComputedStyle(document.body).backgroundColor);
const contrast = (colour, opacity, ground = paper) => { const on = [0, 1, 2].map((i) => opacity * colour[i] + (1 - opacity) * ground[i]);
  const [a, b] = [light(on), light(ground)]; return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05); };
const opacity = (look, own, colour) => +look.opacity * +look[own] * (colour.length > 3 ? colour[3] : 1);
const said = [];
const under = (text) => {  // what a text in a cell of a map stands on
  const box = text.getBoundingClientRect(), x = (box.left + box.right) / 2, y = (box.top + box.bottom) / 2;
  let ground = paper;
  for (const shape of text.ownerSVGElement.querySelectorAll("path, rect")) {
    if (shape.closest("defs, clipPath")) continue;
    if (!(shape.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING)) break;
    const b = shape.getBoundingClientRect(), fill = getComputedStyle(shape).fill, colour = parts(fill);
    if (fill !== "none" && !fill.startsWith("url") && (colour.length < 4 || colour[3] > 0.99) && b.left <= x && x <= b.right && b.top <= y && y <= b.bottom) ground = colour;
  }
  return ground;
};
for (const chart of tiretherm.charts) chart.echart.dispatchAction({ type: "updateAxisPointer", currTrigger: "leave" });
const onColour = (fill) => ["rgb(0, 0, 0)", "rgb(255, 255, 255)"].includes(fill);  // pure black and white are for texts on a colour
document.querySelectorAll(".plot svg text").forEach((text) => {
  const look = getComputedStyle(text), colour = parts(look.fill), size = parseFloat(look.fontSize);
  const found = contrast(colour, opacity(look, "fillOpacity", colour), onColour(look.fill) ? under(text) : paper);
  if (found < 4.5) said.push(`the text ${text.textContent} has a contrast of ${found.toFixed(1)}`);
  if (size < 11) said.push(`the text ${text.textContent} has ${size} pixels`);
});
for (const chart of tiretherm.charts) if (chart.data.kind === "lines") for (const s of chart.echart.getOption().series) {
  if (s.type !== "line" || s.lineStyle.opacity === 0) continue;  // the edge of a band has no colour
  document.body.style.setProperty("outline-color", s.lineStyle.color);
  const found = contrast(parts(getComputedStyle(document.body).outlineColor), 1);
  document.body.style.removeProperty("outline-color");
  if (found < 3) said.push(`the curve ${s.name} has a contrast of ${found.toFixed(1)}`);
}
return [...new Set(said)];"""
WIDE = """const width = document.documentElement.clientWidth;
const out = [...document.querySelectorAll("main *, header *")].filter((e) => !e.closest(".scroll > *") && e.getClientRects().length
  && e.getBoundingClientRect().right > width + 1 && !e.closest("svg"));
return document.documentElement.scrollWidth <= width && !out.length ? "" : `${document.documentElement.scrollWidth} pixels of ${width}, `
  + (out[0] ? out[0].outerHTML.slice(0, 80) : "")"""


def wrong_for_some_readers(browser):
    """What breaks a rule as the page is shown now, a sentence each."""
    if not browser.run("return !!window.axe"):
        browser.run(AXE.read_text())
    said = [f"{rule} ({words}), {count} times, first {target}: {why}" for rule, words, count, target, why in browser.run_async(RUN_AXE)]
    return said + browser.run(CHARTS)


def wider_than_its_window(browser):
    wide = browser.run(WIDE)
    return [f"it is wider than its window: {wide}"] if wide else []
