# SPDX-License-Identifier: BSD-3-Clause
"""A page is laid out for its window: panels stand below one another, tables show numbers, fields have a scale; and every chart
becomes a picture."""
import json
import subprocess

PANELS = """return tiretherm.charts.filter((chart) => chart.data.kind === "lines").map((chart) =>
  chart.echart.getModel().queryComponents({mainType: "grid"}).map((grid) => grid.coordinateSystem.getRect()).map((r) => [r.x, r.width]))"""
# Of each table with numbers: whether its first number and its first name are seen together.
NUMBERS = """return [...document.querySelectorAll(".scroll")].flatMap((box) => {
  const row = box.querySelector("tbody td.right") && box.querySelector("tbody tr"), name = row && row.cells[0];
  const cell = row && [...row.cells].slice(1).find((one) => /\\d/.test(one.textContent));
  const right = (e) => e.getBoundingClientRect().right;
  return !cell || right(cell) <= right(box) + 1 ? [] : [name.textContent];
})"""
SCALES = """return tiretherm.charts.filter((chart) => ["field", "cells"].includes(chart.data.kind)
  && chart.echart.getOption().visualMap[0].show === false).length"""
LEGENDS = """return tiretherm.charts.filter((chart) => chart.data.kind === "lines").filter((chart) => {
  const {option} = tiretherm.made(chart, tiretherm.looks.light, 800, true);
  const names = new Set(chart.data.panels.flatMap((panel) => panel.series.map((s) => s.name)));
  return !option.legend.show || option.legend.data.length !== names.size;
}).length"""


def wrong_layout(browser):
    """Panels over one axis begin and end at the same pixels, in all charts of a page; numbers and scales are seen."""
    said = []
    panels = {tuple(panel) for chart in browser.run(PANELS) for panel in chart}
    if len(panels) > 1:
        said.append(f"panels do not stand below one another: {sorted(panels)}")
    said += [f"the table that begins with {name!r} shows no number" for name in browser.run(NUMBERS)]
    if without := browser.run(SCALES):
        said.append(f"{without} fields have no scale")
    return said


def wrong_pictures(browser, program, page):
    """The page's charts as pictures: all of them, each with a name for every curve."""
    done = subprocess.run([str(program), "report", str(page.parent), "--png", "--json", "--width", "800", "--time-limit", "300"],
                          capture_output=True, text=True)
    if done.returncode != 0:
        return [f"report --png failed: {done.stdout}{done.stderr}"]
    charts = json.loads(done.stdout)["charts"]
    said = [f"the chart {chart['title']} has no picture" for chart in charts if not chart.get("file")]
    if len(charts) != browser.run("return tiretherm.charts.length"):
        said.append(f"{len(charts)} pictures are not one of each chart")
    return said + wrong_legends(browser)


def wrong_legends(browser):
    without = browser.run(LEGENDS)
    return [f"{without} pictures have no legend"] if without else []
