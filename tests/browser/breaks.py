# SPDX-License-Identifier: BSD-3-Clause
"""Pages that are wrong in one place: each check must find what it is there for."""
from accessible import wider_than_its_window, wrong_for_some_readers
from driven import wrong_legend, wrong_slider, wrong_tab_order, wrong_tooltip, wrong_zoom
from held import wrong_charts
from laid_out import wrong_layout, wrong_legends
from printed import wrong_on_paper


def console(browser, _):
    return browser.console()


def network(browser, _):
    return [address for address in browser.requests() if not address.startswith(("file:", "data:", "blob:"))]


def readers(browser, _):
    return wrong_for_some_readers(browser)


def wide(browser, _):
    return wider_than_its_window(browser)


def layout(browser, _):
    return wrong_layout(browser)


def narrow(browser, _):
    browser.show(390, 844, "light")
    return wrong_layout(browser)


def legends(browser, _):
    return wrong_legends(browser)


def paper(browser, _):
    return wrong_on_paper(browser)


BREAKS = [  # page, what stands there, what is put in its place, the check that must find it, a word of what it says
    ("compare", "window.tiretherm = { charts }", "window.tiretherm = { charts }; missing.call()", console, "missing"),
    ("compare", "<main>", '<main><img alt="" src="http://tire.invalid/tire.png">', network, "tire.invalid"),
    ("compare", "--faint: #57606a", "--faint: #a0a8b0", readers, "color-contrast"),
    ("compare", 'ink: "#1b1f24"', 'ink: "#a0a8b0"', readers, "the text"),
    ("compare", "lineStyle: { color: of, width", 'lineStyle: { color: "#c0e0f0", width', readers, "the curve"),
    ("compare", "data: s.points,\n", "data: s.points.map((p) => [p[0], p[1] + 0.01]),\n", wrong_charts, "the curve"),
    ("compare", "chart.echart.group = ", "chart.group = ", wrong_zoom, "chart 2"),
    ("compare", "valueFormatter: number }", "valueFormatter: (v) => number(v + 1) }", wrong_tooltip, "tooltip"),
    ("compare", "legend: {", "legend: { selectedMode: false,", wrong_legend, "legend"),
    ("compare", '<figure class="chart" tabindex="0"', '<figure class="chart"', wrong_tab_order, "tab key"),
    ("compare", "figure:focus-visible { outline:", "figure:focus-visible { outline: none; outline-x:", wrong_tab_order, "not seen"),
    ("compare", "<main>", '<main><p style="min-width: 2000px">wide</p>', wide, "wider"),
    ("compare", "break-inside: avoid", "break-inside: auto; padding-bottom: 30cm", paper, "sheets"),
    ("compare", "option.grid.push({ left, right", "option.grid.push({ left: left + 9 * i, right", layout, "below one another"),
    ("compare", 'classList.toggle("stacked"', 'classList.toggle("stack"', narrow, "beyond the edge"),
    ("compare", "overflow-wrap: break-word; }\nheader", "word-break: break-all; }\nheader", narrow, "is broken"),
    ("run of a section", "{ orient: \"horizontal\", top: 2,", "{ show: false, orient: \"horizontal\", top: 2,", narrow, "no scale"),
    ("run with hot spots", "!!chart.picks && !alone", "!!chart.picks", legends, "no legend"),
    ("run of a section", "showMoment(chart, data.hottest)", "showMoment(chart, 0)", wrong_slider, "hottest moment"),
    ("run of a section", "chart.frame = frame;", "", wrong_slider, "field"),
]
