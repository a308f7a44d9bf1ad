# SPDX-License-Identifier: BSD-3-Clause
"""Screenshots of pages for the manual: taken in Chromium, and compared with those that are there."""
import base64
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests" / "browser"))
sys.dont_write_bytecode = True
from chromium import Chromium, programs  # noqa: E402,F401  programs() is for who asks whether there is a browser

READY = "return !!window.tiretherm && tiretherm.charts.every((chart) => chart.drawn) && document.fonts.status === 'loaded'"
# From the top of one element to the bottom of another, with the space around them.
FRAME = """const [first, last] = [...arguments].map((selector) => document.querySelector(selector));
if (!first || !last) return null;
return [first.getBoundingClientRect().top + scrollY, last.getBoundingClientRect().bottom + scrollY];"""
SPACE = 14  # pixels
# Both pictures in blocks of 4 x 4 pixels: the share of blocks whose mean differs in a colour by more than 0.15 of the scale, wherever
# within a pixel the other picture is laid. Fonts of another version put letters and lines a pixel elsewhere at most; what is left is
# their smoothing. A curve of 1.8 pixels fills 0.45 of a block.
BLOCK, BOUND = 4, 0.15
SHARE = 0.002  # of the blocks: a third of a curve across the page is more, another number of a few digits is not
DIFFERENCE = """const [one, two, block, bound, done] = arguments;
const image = async (data) => { const img = new Image(); img.src = `data:image/png;base64,${data}`; await img.decode(); return img; };
(async () => {
  const [a, b] = [await image(one), await image(two)];
  if (Math.abs(a.width - b.width) > 2 || Math.abs(a.height - b.height) > 0.03 * a.height) return done(1);
  const w = Math.floor(a.width / block), h = Math.floor(Math.min(a.height, b.height) / block);
  const blocks = (img, dx, dy) => {
    const canvas = Object.assign(document.createElement("canvas"), {width: block * w, height: block * h});
    const context = canvas.getContext("2d", {willReadFrequently: true});
    context.drawImage(img, dx, dy);
    const pixels = context.getImageData(0, 0, block * w, block * h).data, sums = new Float64Array(3 * w * h);
    for (let y = 0; y < block * h; y++) for (let x = 0; x < block * w; x++) for (let c = 0; c < 3; c++)
      sums[3 * (Math.floor(y / block) * w + Math.floor(x / block)) + c] += pixels[4 * (y * block * w + x) + c];
    return sums;
  };
  const p = blocks(a, 0, 0), most = bound * 255 * block * block, is_other = new Uint8Array(w * h).fill(1);
  for (const dx of [-1, 0, 1]) for (const dy of [-1, 0, 1]) {
    const q = blocks(b, dx, dy);
    for (let i = 0; i < w * h; i++) if (is_other[i] && [0, 1, 2].every((c) => Math.abs(p[3 * i + c] - q[3 * i + c]) <= most)) is_other[i] = 0;
  }
  done(is_other.reduce((sum, one) => sum + one, 0) / (w * h));
})();"""


def screenshot(browser, page, entry):
    """PNG of what `first` to `last` of the entry (CSS selectors) enclose, without what `hide` names.
    Letters are DejaVu Sans everywhere. @errors LookupError where the page has no such element"""
    style = 'body { font-family: "DejaVu Sans", sans-serif !important; }'
    if "hide" in entry:
        style += f"{entry['hide']} {{ display: none !important; }}"
    shown = page.with_name("screenshot.html")
    shown.write_text(page.read_text().replace("</style>", style + "</style>", 1))
    width = entry.get("width", 1200)
    browser.show(width, 900)
    browser.load(shown)
    browser.until(READY, "all charts to be drawn")
    frame = browser.run(FRAME, entry["first"], entry["last"])
    if frame is None:
        raise LookupError(f"the page has no {entry['first']} or no {entry['last']}")
    top = max(0, frame[0] - SPACE)
    return browser.screenshot(0, round(top), width, round(frame[1] + SPACE - top))


def difference(browser, one, two):
    """Share of the picture that differs, 0 to 1; 1 where the sizes do."""
    texts = [base64.b64encode(picture).decode() for picture in (one, two)]
    return browser.run_async(DIFFERENCE, *texts, BLOCK, BOUND)
