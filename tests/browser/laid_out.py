# SPDX-License-Identifier: BSD-3-Clause
"""A page is laid out for its window: panels stand below one another, tables are seen whole on a phone, no word is broken, fields
have a scale; and every chart becomes a picture."""
import json
import pathlib
import struct
import subprocess
import zlib

PANELS = """return tiretherm.charts.filter((chart) => chart.data.kind === "lines").map((chart) =>
  chart.echart.getModel().queryComponents({mainType: "grid"}).map((grid) => grid.coordinateSystem.getRect()).map((r) => [r.x, r.width]))"""
# Of each table: whether all of it is seen on a phone, where nobody scrolls a table sideways.
TABLES = """const right = (e) => e.getBoundingClientRect().right;
return innerWidth > 620 ? [] : [...document.querySelectorAll(".scroll")].flatMap((box) => {
  const beyond = [...box.querySelectorAll("td, th")].find((cell) => cell.getClientRects().length && right(cell) > right(box) + 1);
  return beyond ? [beyond.textContent] : [];
})"""
# Words that are broken within themselves: only behind "_", "." and "/" a name goes on in the next line.
WORDS = """const broken = new Set(), range = document.createRange();
for (const of of document.querySelectorAll("h1, h2, h3, .verdict, th, td, p, li")) {
  for (const node of [...of.childNodes].filter((one) => one.nodeType === Node.TEXT_NODE)) {
    for (const word of node.data.matchAll(/[\\p{L}\\d]{3,}/gu)) {
      range.setStart(node, word.index);
      range.setEnd(node, word.index + word[0].length);
      if (new Set([...range.getClientRects()].map((rect) => Math.round(rect.top))).size > 1) broken.add(word[0]);
    }
  }
}
return [...broken].slice(0, 5);"""
SCALES = """return tiretherm.charts.filter((chart) => ["field", "images", "cells"].includes(chart.data.kind)
  && chart.echart.getOption().visualMap[0].show === false).length"""
LEGENDS = """return tiretherm.charts.filter((chart) => chart.data.kind === "lines").filter((chart) => {
  const {option} = tiretherm.made(chart, tiretherm.looks.light, 800, true);
  const names = new Set(chart.data.panels.flatMap((panel) => panel.series.map((s) => s.name)));
  return !option.legend.show || option.legend.data.length !== names.size;
}).length"""


def wrong_layout(browser):
    """Panels over one axis begin and end at the same pixels, in all charts of a page; tables, words and scales are seen whole."""
    said = []
    panels = {tuple(panel) for chart in browser.run(PANELS) for panel in chart}
    if len(panels) > 1:
        said.append(f"panels do not stand below one another: {sorted(panels)}")
    said += [f"{text!r} of a table lies beyond the edge" for text in browser.run(TABLES)]
    said += [f"the word {word!r} is broken" for word in browser.run(WORDS)]
    if without := browser.run(SCALES):
        said.append(f"{without} fields have no scale")
    return said


DARK_PAPER = (0x15, 0x18, 0x1c)  # that of report.css


def first_pixel(picture):
    """Of a PNG with a byte a colour: whatever its filter, the first pixel stands as it is behind the filter's number."""
    bytes_, at, packed = picture.read_bytes(), 8, b""
    while at < len(bytes_):
        length, kind = struct.unpack(">I4s", bytes_[at:at + 8])
        packed += bytes_[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += length + 12
    return tuple(zlib.decompress(packed)[1:4])


def wrong_pictures(browser, program, page):
    """The page's charts as pictures: all of them, on dark paper where that is asked for, each with a name for every curve."""
    done = subprocess.run([str(program), "report", str(page.parent), "--png", "--json", "--width", "800", "--dark", "--time-limit", "300"],
                          capture_output=True, text=True)
    if done.returncode != 0:
        return [f"report --png failed: {done.stdout}{done.stderr}"]
    charts = json.loads(done.stdout)["charts"]
    said = [f"the chart {chart['title']} has no picture" for chart in charts if not chart.get("file")]
    for chart in charts:
        if chart.get("file") and (first := first_pixel(pathlib.Path(chart["file"]))) != DARK_PAPER:
            said.append(f"the picture of {chart['title']} begins with {first} and not with dark paper")
    if len(charts) != browser.run("return tiretherm.charts.length"):
        said.append(f"{len(charts)} pictures are not one of each chart")
    return said + wrong_legends(browser)


def wrong_legends(browser):
    without = browser.run(LEGENDS)
    return [f"{without} pictures have no legend"] if without else []
