# SPDX-License-Identifier: BSD-3-Clause
"""A page answers its reader: slider, zoom, legend and tooltip, by mouse and by keys."""
import math
import re

from held import frame_values, page_data, places

DRAWN = """tiretherm.charts[arguments[0]].echart.getZr().flush();
const canvas = tiretherm.charts[arguments[0]].plot.querySelector("canvas");
const bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
let sum = 0; for (let i = 0; i < bytes.length; i++) sum = (31 * sum + bytes[i]) % 4294967291; return sum;"""
SHOWN = """const chart = tiretherm.charts[arguments[0]];
return [+chart.input.value, chart.output.textContent, chart.input.getAttribute("aria-valuetext"),
        chart.echart.getOption().series[0].data.map((d) => d[2])];"""
ZOOMS = """return tiretherm.charts.map((chart) => { if (chart.data.kind !== "lines") return null;
  const {start, end} = chart.echart.getOption().dataZoom[0];
  return [start, end, ...chart.echart.getModel().getComponent("xAxis").axis.scale.getExtent()]; })"""
PANEL = """const chart = tiretherm.charts[arguments[0]];
chart.plot.scrollIntoView({block: "center"});
const box = chart.plot.getBoundingClientRect(), rect = chart.echart.getModel().getComponent("grid").coordinateSystem.getRect();
return [box.left + rect.x + rect.width / 2, box.top + rect.y + rect.height / 2];"""
PLACE = """const [index, at] = arguments, chart = tiretherm.charts[index];
chart.plot.scrollIntoView({block: "start"});
const box = chart.plot.getBoundingClientRect();
const [x, y] = chart.echart.convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, at);
return [box.left + x, box.top + y];"""
PIXEL = "return tiretherm.charts[arguments[0]].echart.convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, arguments[1])"
ON_PLOT = PLACE.replace("chart.echart.convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, at)", "at")
TIP = """const tips = [...tiretherm.charts[arguments[0]].plot.querySelectorAll(":scope > div")].filter((d) => !d.querySelector("svg, canvas"));
const seen = tips.find((d) => getComputedStyle(d).visibility !== "hidden" && +getComputedStyle(d).opacity > 0);
return seen ? seen.textContent : "";"""
LEGEND = """const [index, name] = arguments, chart = tiretherm.charts[index];
chart.plot.scrollIntoView({block: "start"});
const text = [...chart.plot.querySelectorAll("svg text")].find((t) => t.textContent === name);
if (!text) return null;
const box = text.getBoundingClientRect();
return [box.left + box.width / 2, box.top + box.height / 2];"""
# Curves are long and thicker than the lines of the grid. The library draws at the next frame unless it is told to.
CURVES = """const chart = tiretherm.charts[arguments[0]];
chart.echart.getZr().flush();
return [...chart.plot.querySelectorAll("svg path")].filter((path) => path.getAttribute("stroke") && path.getAttribute("fill") === "none"
  && parseFloat(getComputedStyle(path).strokeWidth) > 1.2 && path.getTotalLength() > 60).length;"""
SELECTED = "return tiretherm.charts[arguments[0]].echart.getOption().legend[0].selected[arguments[1]] !== false"


def of_kind(page, kind):
    return [(i, data) for i, data in enumerate(page_data(page)) if data["kind"] == kind]


def focus(browser, index, part):
    browser.run("const chart = tiretherm.charts[arguments[0]]; (arguments[1] ? chart[arguments[1]] : chart.figure).focus()", index, part)


# ---------------------------------------------------------------------------------------------------- slider


def wrong_slider(browser, page):
    said = []
    for index, data in of_kind(page, "field"):
        if len(data["times"]) < 2:
            continue
        hottest = [max(frame_values(data, f)) for f in range(len(data["times"]))]
        warmest = data["hottest"]
        if "first" not in data and hottest[warmest] < max(hottest) - 0.05:  # a plateau creeps on, and colours are means of cells
            said.append(f"the hottest moment is not the hottest: {hottest[warmest]} of {max(hottest)}")
        drawn = {}

        def check(frame, how):
            value, text, spoken, held = browser.run(SHOWN, index)
            drawn[frame] = browser.run(DRAWN, index)
            number = float(re.match(r"[-+0-9.e]+", text).group(0))
            if value != frame:
                said.append(f"{how}: the slider is at {value} instead of {frame}")
            # The time is shown with five digits.
            if abs(number - data["times"][frame]) > 1e-4 * max(abs(data["times"][frame]), 1e-3) or spoken != text:
                said.append(f"{how}: the time is shown as {text}, spoken as {spoken}, and is {data['times'][frame]}")
            if max(abs(a - b) for a, b in zip(held, frame_values(data, frame))) > 1e-6:
                said.append(f"{how}: the field is not that of {text}")

        check(warmest, "opened")
        focus(browser, index, "input")
        browser.press("Home")
        check(0, "Home")
        browser.press("ArrowRight")
        check(1, "arrow to the right")
        browser.press("End")
        check(len(data["times"]) - 1, "End")
        browser.run("const input = tiretherm.charts[arguments[0]].input; input.value = 1; input.dispatchEvent(new Event('input'))", index)
        check(1, "a script")
        browser.run("tiretherm.charts[arguments[0]].figure.querySelector('button').focus()", index)
        browser.press(" ")
        check(warmest, "hottest moment")
        if hottest[0] != max(hottest) and drawn[0] == drawn[warmest]:
            said.append("the canvas does not change with the slider")
    return said


# ------------------------------------------------------------------------------------------------------ zoom


def wrong_zoom(browser, page):
    charts = of_kind(page, "lines")
    said = []

    def check(index, link, how, is_right):
        zooms = browser.run(ZOOMS)
        for other, data in charts:
            together = other == index or (link and data.get("link") == link)
            low, high = data["x"]["min"], data["x"]["max"]
            start, end, first, last = zooms[other]
            if together and not is_right(start, end):
                said.append(f"{how} on {charts_name(data)}: chart {other + 1} shows {start:.1f} to {end:.1f} %")
            off = max(abs(low + (high - low) * start / 100 - first), abs(low + (high - low) * end / 100 - last))
            if off > 1e-3 * (high - low):  # the library rounds to a pixel
                said.append(f"{how}: the axis of chart {other + 1} goes from {first} to {last}")

    for index, data in charts[:1] + charts[-1:]:
        link = data.get("link")
        focus(browser, index, None)
        browser.press("+")
        check(index, link, "+", lambda a, b: abs(a - 100 / 6) < 0.1 and abs(b - 500 / 6) < 0.1)  # two thirds, about the middle
        browser.press("ArrowRight")
        check(index, link, "arrow to the right", lambda a, b: a > 17 and abs(b - a - 200 / 3) < 0.1)
        browser.press("ArrowLeft", "ArrowLeft")
        check(index, link, "arrow to the left", lambda a, b: a < 16 and abs(b - a - 200 / 3) < 0.1)
        browser.press("-", "-")
        check(index, link, "-", lambda a, b: b - a > 99)
        browser.press("0")
        browser.wheel(*browser.run(PANEL, index), -240)
        check(index, link, "wheel alone", lambda a, b: (a, b) == (0, 100))
        browser.wheel(*browser.run(PANEL, index), -240, "Control")
        check(index, link, "ctrl and wheel", lambda a, b: a > 1 and b < 99)
        focus(browser, index, None)
        browser.press("0")
        check(index, link, "0", lambda a, b: (a, b) == (0, 100))
    return said


def charts_name(data):
    return data["panels"][0]["name"]


# -------------------------------------------------------------------------------------------- legend, tooltip


MOST_NAMES = 10  # in a legend, as report.js has it


def names_of(data):
    return {s["name"] for panel in data["panels"] for s in panel["series"]}


def wrong_legend(browser, page):
    """A click on a name hides its curve, another shows it again."""
    for index, data in of_kind(page, "lines"):
        name = next((s["name"] for s in data["panels"][0]["series"] if s["role"] == "line"), None)
        place = name and browser.run(LEGEND, index, name)
        if not place:
            continue
        before = browser.run(CURVES, index)
        browser.point_at(*place, click=True)
        hidden = browser.run(CURVES, index)
        if browser.run(SELECTED, index, name) or hidden >= before:
            return [f"a click on {name} in the legend does not hide its curve: {hidden} of {before} are drawn"]
        browser.point_at(*place, click=True)
        if not browser.run(SELECTED, index, name) or browser.run(CURVES, index) != before:
            return [f"a second click does not show {name} again"]
        return []
    has_names = any("line" in [s["role"] for s in data["panels"][0]["series"]] and len(names_of(data)) <= MOST_NAMES
                    for _, data in of_kind(page, "lines"))
    return ["no legend was found"] if has_names else []  # charts of many curves have boxes, charts of points no curve


def numbers(text):
    return [float(n) for n in re.findall(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?", text)]


def wrong_tooltip(browser, page):
    """At a point of a curve and in the hottest place of a field: the value with the digits that are shown."""
    said = []

    def check(index, at, value, tolerance, what, place=PLACE):
        browser.point_at(2, 2)
        browser.point_at(*browser.run(place, index, at))
        text = browser.until(TIP, f"a tooltip on {what}", index, seconds=10)
        if not any(abs(n - value) <= tolerance for n in numbers(text)):
            said.append(f"the tooltip on {what} says {text!r} and not {value}")

    for index, data in of_kind(page, "lines")[:1]:
        curve = data["panels"][0]["series"][0]
        inside = [p for p in curve["points"] if None not in p and data["x"]["min"] < p[0] < data["x"]["max"]]
        if inside and curve["role"] in ("line", "dashed", "points"):
            # Of some in the middle that which is nearest to a whole pixel, as the mouse is: there no other sample is nearer.
            middle = inside[len(inside) // 2:][:40]
            point = min(middle, key=lambda p: abs((x := browser.run(PLACE, index, p)[0]) - round(x)))
            check(index, point, point[1], 1e-4 * abs(point[1]), curve["name"])  # five digits
    for index, data in of_kind(page, "field")[:1]:
        mark = browser.run(PIXEL, index, data["marks"][data["hottest"]][:2])
        free = [(value, place) for value, place in zip(frame_values(data, data["hottest"]), places(browser, index))
                if place and math.dist(place, mark) > 15]  # px, where no mark covers it
        if free:
            value, place = min(free)
            check(index, place, value, 0.006, "the coldest place", ON_PLOT)  # two digits are shown
    for index, data in [(i, bars) for i, bars in of_kind(page, "bars") if "value" in bars["items"][0]][:1]:
        item = max(data["items"], key=lambda one: abs(one["value"]))
        row = len(data["items"]) - 1 - data["items"].index(item)
        check(index, [item["value"] / 2, row], item["value"], 1e-4 * abs(item["value"]), item["name"])
    browser.point_at(2, 2)  # away from all charts
    return said


# -------------------------------------------------------------------------------------------------- tab order

PASSED = """const at = document.activeElement;
if (at === document.body || at === document.documentElement) return null;
const look = getComputedStyle(at), all = [...document.querySelectorAll(arguments[0])];
return [all.indexOf(at), at.tagName + " " + (at.getAttribute("aria-label") || at.textContent).slice(0, 40),
        look.outlineStyle !== "none" && parseFloat(look.outlineWidth) > 0];"""
FROM_THE_TOP = """document.body.tabIndex = -1; document.body.focus(); document.body.removeAttribute("tabindex");
return document.querySelectorAll(arguments[0]).length;"""
STATIONS = "a[href], figure.chart, .scroll, input:not([hidden]), button:not([hidden])"


def wrong_tab_order(browser, _):
    """The tab key reaches links, tables, charts, sliders and buttons in the order of the page, and one sees where it is."""
    said, order = [], []
    count = browser.run(FROM_THE_TOP, STATIONS)
    for _ in range(count + 5):
        browser.press("Tab")
        passed = browser.run(PASSED, STATIONS)
        if passed is None:
            break
        index, name, is_seen = passed
        order.append(index)
        if not is_seen:
            said.append(f"the focus on {name} is not seen")
    if order != list(range(count)):
        said.append(f"the tab key passes {order} of {count} places")
    return said


def wrong_answers(browser, page):
    return [sentence for check in (wrong_slider, wrong_zoom, wrong_legend, wrong_tooltip, wrong_tab_order)
            for sentence in check(browser, page)]
