"""An animation of a scene: one HTML file that needs nothing from outside."""

from __future__ import annotations

import json
from collections.abc import Iterable
from html import escape

from verify.views.plots.drawing import SCHEMES
from verify.views.plots.scene_drawing import COLOURS, end_time
from verify.views.plots.scene_path import legs
from verify.views.scene import Step, Told

_PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Three inelastic hard spheres</title>
<style>
:root {{ color-scheme: light dark; {light} }}
@media (prefers-color-scheme: dark) {{ :root {{ {dark} }} }}
body {{ margin: 0; font: 16px/1.5 sans-serif; background: var(--paper); color: var(--ink); }}
main {{ max-width: 60rem; margin: 0 auto; padding: 1rem; }}
canvas {{ width: 100%; aspect-ratio: 16/10; display: block; }}
.controls {{ display: flex; gap: .8rem; align-items: center; flex-wrap: wrap; }}
input[type=range] {{ flex: 1; min-width: 10rem; }}
button {{ font: inherit; padding: .2rem 1rem; }}
</style></head><body><main>
<p>{verdict}</p>
<canvas aria-label="the three spheres, moving"></canvas>
<div class="controls">
<button type="button" id="play">pause</button>
<label>moment <input id="moment" type="range" min="0" max="1" step="0.0005" value="0"></label>
<label>zoom <input id="zoom" type="range" min="0" max="16" step="0.05" value="0"></label>
</div>
<p id="now" aria-live="off"></p>
<p>Each collision takes the same time on the screen, so that those that come ever faster can be
seen; the clock below the drawing shows how much time has really passed.</p>
</main>
<script>
"use strict";
const scene = {data};
{program}
</script></body></html>
"""

_PROGRAM = """
const canvas = document.querySelector("canvas"), pen = canvas.getContext("2d");
const moment = document.getElementById("moment"), zoom = document.getElementById("zoom");
const play = document.getElementById("play"), now = document.getElementById("now");
const legs = scene.legs, stops = legs.map(leg => leg.time).concat([scene.end]);
let playing = !matchMedia("(prefers-reduced-motion: reduce)").matches, before = null, share = 0;
const colour = name => getComputedStyle(document.documentElement).getPropertyValue("--" + name);

function at(part) {
  const where = part * legs.length, k = Math.min(Math.floor(where), legs.length - 1);
  const leg = legs[k], time = leg.time + (where - k) * (stops[k + 1] - leg.time);
  const places = leg.places.map((x, i) => x.map((a, j) =>
    a + (time - leg.time) * leg.velocities[i][j]));
  return {k, time, places, fresh: where - k < 0.25 ? leg.pair : ""};
}
function draw(state) {
  const ratio = devicePixelRatio || 1;
  canvas.width = canvas.clientWidth * ratio; canvas.height = canvas.clientHeight * ratio;
  const ends = scene.box, pixels = Math.min(canvas.width / ends.width, canvas.height / ends.height);
  const scale = pixels * 2 ** zoom.value;
  const focus = zoom.value > 0 ? contact(state) : [ends.x, ends.y];
  const place = p => [canvas.width / 2 + (p[0] - focus[0]) * scale,
                      canvas.height / 2 - (p[1] - focus[1]) * scale];
  state.places.forEach((_, i) => {
    pen.beginPath(); pen.strokeStyle = colour(scene.colours[i]); pen.globalAlpha = 0.5;
    for (let k = 0; k <= state.k; k++) pen.lineTo(...place(legs[k].places[i]));
    pen.lineTo(...place(state.places[i])); pen.stroke();
  });
  state.places.forEach((p, i) => {
    const [x, y] = place(p);
    pen.beginPath(); pen.arc(x, y, scale / 2, 0, 2 * Math.PI);
    pen.fillStyle = pen.strokeStyle = colour(scene.colours[i]);
    pen.globalAlpha = 0.25; pen.fill(); pen.globalAlpha = 1;
    pen.lineWidth = (state.fresh.includes(i) ? 4 : 1.5) * ratio; pen.stroke();
    pen.fillStyle = colour("ink"); pen.font = 16 * ratio + "px sans-serif";
    pen.textAlign = "center"; pen.fillText(i, x, y);
  });
  now.textContent = "time " + state.time.toPrecision(12) + ", after " + state.k + " collision" +
    (state.k === 1 ? "" : "s") + (state.fresh ? ": " + state.fresh : "");
}
function contact(state) {
  const next = legs[Math.min(state.k + 1, legs.length - 1)].pair || "01";
  const [a, b] = [...next].map(i => state.places[+i]);
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}
function tick(stamp) {
  if (playing && before !== null) {
    share += (stamp - before) / (1200 * legs.length);
    if (share > 1.1) share = 0;
    moment.value = Math.min(share, 1);
  }
  before = stamp; draw(at(Math.min(share, 1))); requestAnimationFrame(tick);
}
moment.oninput = () => { share = +moment.value; };
play.onclick = () => { playing = !playing; play.textContent = playing ? "pause" : "play"; };
if (!playing) play.textContent = "play";
requestAnimationFrame(tick);
"""


def scene_page(told: Told, steps: Iterable[Step]) -> str:
    """The file."""
    path = legs(told, steps, most=60)
    points = [p for leg in path for p in leg.places]
    low = [min(p[k] for p in points) - 0.7 for k in (0, 1)]
    high = [max(p[k] for p in points) + 0.7 for k in (0, 1)]
    box = {"x": (low[0] + high[0]) / 2, "y": (low[1] + high[1]) / 2}
    box |= {"width": high[0] - low[0], "height": high[1] - low[1]}
    data = {
        "legs": [leg._asdict() for leg in path],
        "end": end_time(told, path),
        "colours": COLOURS,
        "box": box,
    }
    schemes = {
        name: " ".join(f"--{key}: {value};" for key, value in colours.items())
        for name, colours in SCHEMES.items()
    }
    verdict = "<br>".join(map(escape, told.lines))
    return _PAGE.format(verdict=verdict, data=json.dumps(data), program=_PROGRAM, **schemes)
