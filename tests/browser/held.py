# SPDX-License-Identifier: BSD-3-Clause
"""What the charts of a page hold and draw is the data of the page: each number is read back from the charting library."""
import base64
import html
import json
import re
import struct

READY = "return !!window.tiretherm && tiretherm.charts.length > 0 && tiretherm.charts.every((chart) => chart.drawn)"
HELD = """tiretherm.charts.forEach((chart) => chart.echart.getZr().flush());  // drawn now, not at the next frame
return tiretherm.charts.map((chart) => ({
  kind: chart.data.kind, marks: chart.plot.querySelectorAll("svg path, canvas").length, frame: chart.frame,
  series: chart.echart.getOption().series.map((s) => ({name: s.name, type: s.type, panel: s.xAxisIndex || 0,
    data: (s.data || []).map((d) => d && d.value !== undefined ? d.value : d)}))}))"""
PLACES = """const chart = tiretherm.charts[arguments[0]], {polygons, corners} = chart.data, places = [];
for (let q = 0; q < polygons.length; q += 2 * corners) {
  // The corners of the four-sided cell, of which two sides may be arcs of several pieces.
  const four = [0, corners / 2 - 1, corners / 2, corners - 1].map((i) => q + 2 * i);
  const p = four.map((i) => chart.echart.convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, [polygons[i], polygons[i + 1]]));
  const area = 0.5 * Math.abs(p.reduce((sum, a, i) => { const b = p[(i + 1) % 4]; return sum + a[0] * b[1] - b[0] * a[1]; }, 0));
  const longest = Math.max(...p.map((a, i) => Math.hypot(a[0] - p[(i + 1) % 4][0], a[1] - p[(i + 1) % 4][1])));
  places.push(area / longest < 5 ? null : [0, 1].map((c) => p.reduce((sum, a) => sum + a[c] / 4, 0)));
}
return places;"""
PIXELS = """const canvas = tiretherm.charts[arguments[0]].plot.querySelector("canvas");
const ratio = canvas.width / canvas.clientWidth, context = canvas.getContext("2d");
return arguments[1].map(([x, y]) => Array.from(context.getImageData(Math.round(x * ratio), Math.round(y * ratio), 1, 1).data));"""


def page_data(page):
    """The data of the charts as they stand in the file, in its order."""
    return [json.loads(text) for text in re.findall(r'<script type="application/json">(.*?)</script>', page.read_text(), re.S)]


def near(a, b):
    return a is b or (a is not None and b is not None and abs(a - b) <= 1e-9 * max(1.0, abs(a), abs(b)))  # round-off alone


def same(points, others):
    return len(points) == len(others) and all(len(p) == len(q) and all(map(near, p, q)) for p, q in zip(points, others))


def wrong_lines(data, series):
    said = []
    for i, panel in enumerate(data["panels"]):
        for curve in panel["series"]:
            found = [s["data"] for s in series if s["name"] == curve["name"] and s["panel"] == i]
            if curve["role"] == "band":  # two areas on one another: the lower end, and what is between
                found = [[[*low, None if rise[1] is None else low[1] + rise[1]] for low, rise in zip(one, two)]
                         for one, two in zip(found[::2], found[1::2])]
            if not any(same(curve["points"], one) for one in found):
                said.append(f"the curve {curve['name']} of {panel['name']} is not what the page's data say")
    return said


def wrong_bars(data, series):
    names = data.get("series") or [data["x"]["name"]]
    held = {s["name"]: s["data"] for s in series if s["type"] == "bar"}
    wanted = {name: [item["values"][i] if "values" in item else item["value"] for item in reversed(data["items"])]
              for i, name in enumerate(names)}  # the library counts bars from below
    return [] if held == wanted else [f"the bars of {data['x']['name']} are not the page's data"]


def wrong_cells(data, series):
    return [] if [cell["at"][4] for cell in data["cells"]] == [place[2] for place in series[0]["data"]] else [
        f"the cells of {data['name']} are not the page's data"]


def frame_values(data, frame):
    """Temperatures of a moment, degC."""
    bytes_ = base64.b64decode(data["values"])
    steps = struct.unpack(f"<{len(bytes_) // 2}H", bytes_)
    count = len(steps) // len(data["times"])
    return [data["low"] + (data["high"] - data["low"]) / 65535 * s for s in steps[frame * count:(frame + 1) * count]]


def wrong_field(data, series, frame):
    held = [[place[2]] for place in series[0]["data"]]
    return [] if same([[v] for v in frame_values(data, frame)], held) else ["the field is not that of its moment"]


def wrong_images(data, series, frame):
    """Three panels: measured, simulated, simulated - measured."""
    values = frame_values(data, frame)
    measured, simulated = values[:len(values) // 2], values[len(values) // 2:]
    wanted = [measured, simulated, [s - m for m, s in zip(measured, simulated)]]
    return [f"the panel {one['name']} is not that of its frame" for one, panel in zip(series, wanted)
            if not same([[v] for v in panel], [[place[2]] for place in one["data"]])]


def places(browser, index):
    """Middle of each quadrilateral of the canvas, where it is as thick as some pixels; None of the others."""
    return browser.run(PLACES, index)


def wrong_colours(browser, index, data, frame):
    """The canvas shows the temperatures: pixels in the middle of quadrilaterals have the colours of the scale."""
    values = frame_values(data, frame)
    seen = [(value, place) for value, place in zip(values, places(browser, index)) if place]
    seen = seen[::max(1, len(seen) // 60)]
    if not seen:
        return []
    pixels = browser.run(PIXELS, index, [place for _, place in seen])
    scale = browser.run("return tiretherm.charts[arguments[0]].echart.getOption().visualMap[0].inRange.color", index)
    stops = [[int(text[i:i + 2], 16) for i in (1, 3, 5)] for text in scale]
    right = 0
    for (value, _), pixel in zip(seen, pixels):
        at = (value - data["low"]) / max(data["high"] - data["low"], 1e-9) * (len(stops) - 1)
        i = min(int(at), len(stops) - 2)
        colour = [a + (at - i) * (b - a) for a, b in zip(stops[i], stops[i + 1])]
        right += all(abs(a - b) <= 4 for a, b in zip(colour, pixel))  # of 255: the library rounds
    # Names, borders between layers and the mark of the hottest place hide some of the places.
    return [] if right >= 0.7 * len(seen) else [f"the canvas has the colour of the temperature at {right} of {len(seen)} places"]


def wrong_charts(browser, page):
    """Sentences on charts that do not hold or do not draw their data."""
    said = []
    wanted, charts = page_data(page), browser.run(HELD)
    if len(wanted) != len(charts):
        return [f"{len(charts)} of {len(wanted)} charts are drawn"]
    for index, (data, chart) in enumerate(zip(wanted, charts)):
        if not chart["marks"] or not any(s["data"] for s in chart["series"]):
            said.append(f"a chart of {data['kind']} is empty")
        elif data["kind"] == "lines":
            said += wrong_lines(data, chart["series"])
        elif data["kind"] == "bars":
            said += wrong_bars(data, chart["series"])
        elif data["kind"] == "cells":
            said += wrong_cells(data, chart["series"])
        elif data["kind"] == "images":
            said += wrong_images(data, chart["series"], chart["frame"])
        elif data["kind"] == "field":
            said += wrong_field(data, chart["series"], chart["frame"]) + wrong_colours(browser, index, data, chart["frame"])
    return said
