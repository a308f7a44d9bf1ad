# SPDX-License-Identifier: BSD-3-Clause
"""A page on paper: complete, dark on light, as wide as the sheet, and no chart across two sheets."""
import math
import re

from accessible import CHARTS, wider_than_its_window

PAPER = {"A4": (21.0, 29.7), "Letter": (21.59, 27.94)}  # cm
MARGIN = 1.0  # cm, what browsers take
PIXEL = 2.54 / 96  # cm: CSS
# A link at the head and at the foot of each chart, without a size: the file says on which sheet they are.
MARK = """document.querySelectorAll("figure.chart").forEach((figure, i) => {
  figure.style.position = "relative";
  for (const end of ["top", "bottom"]) {
    const link = Object.assign(document.createElement("a"), {href: `https://chart.invalid/${i}`, textContent: "|", className: "mark"});
    link.style.cssText = `position: absolute; left: 0; ${end}: 0; font-size: 4px; line-height: 4px`;
    figure.append(link);
  }});"""
UNMARK = "document.querySelectorAll('.mark').forEach((link) => link.remove())"


def sheets(pdf):
    """For each sheet of the file the charts whose head or foot is on it."""
    objects = dict(re.findall(rb"(?:^|\n)(\d+) 0 obj\n(.*?)endobj", pdf, re.S))
    found = []
    for body in objects.values():
        if not re.search(rb"/Type /Page\b(?!s)", body):
            continue
        annots = re.search(rb"/Annots (\[.*?\]|\d+ 0 R)", body, re.S)
        parts = body
        if annots:
            parts += b"".join(objects.get(number, b"") for number in re.findall(rb"(\d+) 0 R", annots.group(1)))
        found.append([int(n) for n in re.findall(rb"chart\.invalid/(\d+)", parts)])
    return found


def wrong_on_paper(browser, paper="A4"):
    width, height = PAPER[paper]
    inner = math.floor((width - 2 * MARGIN) / PIXEL)
    browser.show(1280, 900, "dark")
    browser.run("window.dispatchEvent(new Event('beforeprint'))")
    browser.show(inner, 900, "dark", "print")
    said = wider_than_its_window(browser) + browser.run(CHARTS)
    if browser.run("return getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)":
        said.append("the paper is not white")
    tall = browser.run("return document.documentElement.scrollHeight") * PIXEL
    browser.run("window.dispatchEvent(new Event('afterprint'))")
    browser.show(1280, 900, "dark")
    browser.run(MARK)
    found = sheets(browser.pdf(width, height, MARGIN))
    browser.run(UNMARK)
    charts = browser.run("return tiretherm.charts.length")
    least = tall / (height - 2 * MARGIN)
    # A chart that no longer fits leaves its place on the sheet free: at most a sheet more for each.
    if not math.floor(least) <= len(found) <= math.ceil(least) + charts:
        said.append(f"{len(found)} sheets for a page of {least:.1f}")
    for chart in range(charts):
        on = [sheet for sheet, marks in enumerate(found) for mark in marks if mark == chart]
        if len(on) != 2 or on[0] != on[1]:
            said.append(f"chart {chart + 1} is on the sheets {[sheet + 1 for sheet in on]}")
    return said
