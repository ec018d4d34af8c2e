#include "chart_page.h"

#include <fmt/format.h>

#include "output/plot_colour.h"

namespace taut {
namespace {

constexpr std::string_view page_head = R"HTML(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>taut: speed against accuracy</title>
<style>
body { font: 16px/1.45 "DejaVu Sans", Verdana, sans-serif; color: #333; background: #fff; margin: 1.5rem auto; max-width: 68rem; padding: 0 1rem; }
h1 { font-size: 1.4rem; margin: 0 0 .8rem; }
.bar { display: flex; flex-wrap: wrap; gap: .4rem 1.4rem; align-items: center; margin: .4rem 0; }
select { font: inherit; padding: .15rem .4rem; }
#methods label { white-space: nowrap; cursor: pointer; }
#methods label.off { opacity: .4; }
svg { width: 100%; height: auto; display: block; }
svg text { fill: #333; font-size: 15px; }
#tip { position: absolute; pointer-events: none; background: #fff; border: 1px solid #888; border-radius: 4px; box-shadow: 0 2px 8px #0003; padding: .4rem .6rem; font-size: .85rem; white-space: pre-line; }
#tip[hidden] { display: none; }
#notes { font-size: .85rem; color: #555; }
#notes p { margin: .3rem 0; overflow-wrap: anywhere; }
</style>
</head>
<body>
<h1>Speed against accuracy</h1>
<div class="bar">
<label>Scene <select id="scene"></select></label>
<label>Error <select id="error"></select></label>
<label>Cost <select id="cost"><option value="seconds">time</option><option value="link_solves">link solves</option></select></label>
</div>
<div class="bar" id="methods"></div>
<svg id="plot" viewBox="0 0 1000 640" role="img" aria-label="Cost over error, both logarithmic"></svg>
<div id="tip" hidden></div>
<div id="notes"></div>
<script type="application/json" id="data">)HTML";

constexpr std::string_view page_script = R"HTML(</script>
<script>
'use strict';
const charts = JSON.parse(document.getElementById('data').textContent);
const at = id => document.getElementById(id);
const box = { left: 85, right: 985, top: 15, bottom: 575 };
const titles = { trajectory: 'trajectory', strain: 'strain of the links', energy: 'energy', sag: 'sag' };
const state = { scene: charts[0].scene, error: '', cost: 'seconds', off: new Set() };

function readAddress() {
  const wanted = new URLSearchParams(location.hash.slice(1));
  if (charts.some(c => c.scene === wanted.get('scene'))) state.scene = wanted.get('scene');
  if (wanted.has('error')) state.error = wanted.get('error');
  if (['seconds', 'link_solves'].includes(wanted.get('cost'))) state.cost = wanted.get('cost');
  state.off = new Set((wanted.get('without') || '').split(',').filter(name => name));
}
function writeAddress() {
  const shown = new URLSearchParams({ scene: state.scene, error: state.error, cost: state.cost });
  if (state.off.size) shown.set('without', [...state.off].join(','));
  history.replaceState(null, '', '#' + shown);
}
function element(name, attributes, parent, text) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (text !== undefined) made.textContent = text;
  return parent.appendChild(made);
}
function choices(select, entries, chosen) {
  select.replaceChildren(...entries.map(([value, text]) => new Option(text, value, false, value === chosen)));
}
// The cases that no other of them beats in both cost and error, from cheap to dear.
function front(cases) {
  const best = [];
  for (const c of [...cases].sort((a, b) => a[state.cost] - b[state.cost] || a.errors[state.error] - b.errors[state.error]))
    if (!best.length || c.errors[state.error] < best[best.length - 1].errors[state.error]) best.push(c);
  return best;
}
function axis(values, from, to) {
  const low = Math.log10(Math.min(...values)) - 0.15, high = Math.log10(Math.max(...values)) + 0.15;
  const place = value => from + (to - from) * (Math.log10(value) - low) / (high - low);
  const decades = [];
  for (let d = Math.ceil(low); d <= Math.floor(high); ++d) decades.push(d);
  return { place, decades };
}
function superscript(number) {
  return String(number).replace('-', '⁻').replace(/\d/g, d => '⁰¹²³⁴⁵⁶⁷⁸⁹'[d]);
}
function describe(c) {
  const number = value => value.toPrecision(3);
  const lines = [c.curve];
  for (const [name, value] of Object.entries(c.settings)) lines.push(name.replaceAll('_', ' ') + ': ' + value);
  for (const [name, value] of Object.entries(c.errors)) lines.push(name + ' error: ' + number(value));
  lines.push('time: ' + number(c.seconds) + ' s (least of ' + c.processor_seconds.length + ')', 'link solves: ' + c.link_solves.toLocaleString('en'));
  return lines.join('\n');
}
function showTip(event, c) {
  const tip = at('tip');
  tip.textContent = describe(c);
  tip.hidden = false;
  const right = event.pageX + 16 + tip.offsetWidth > document.documentElement.clientWidth;
  tip.style.left = (right ? event.pageX - 16 - tip.offsetWidth : event.pageX + 16) + 'px';
  tip.style.top = (event.pageY + 12) + 'px';
}
function drawAxes(plot, x, y, chart) {
  for (const d of x.decades) {
    const px = x.place(10 ** d);
    element('line', { x1: px, x2: px, y1: box.top, y2: box.bottom, stroke: '#ddd' }, plot);
    element('text', { x: px, y: box.bottom + 22, 'text-anchor': 'middle' }, plot, '10' + superscript(d));
  }
  for (const d of y.decades) {
    const py = y.place(10 ** d);
    element('line', { x1: box.left, x2: box.right, y1: py, y2: py, stroke: '#ddd' }, plot);
    element('text', { x: box.left - 8, y: py + 5, 'text-anchor': 'end' }, plot, '10' + superscript(d));
  }
  element('path', { d: `M${box.left} ${box.top}V${box.bottom}H${box.right}`, fill: 'none', stroke: '#333' }, plot);
  element('text', { x: (box.left + box.right) / 2, y: 625, 'text-anchor': 'middle' }, plot, 'error: ' + titles[state.error] + ' (more accurate →)');
  element('text', { transform: `translate(20 ${(box.top + box.bottom) / 2}) rotate(-90)`, 'text-anchor': 'middle' }, plot,
          state.cost === 'seconds' ? 'processor time (s)' : 'link solves');
}
function draw() {
  const chart = charts.find(c => c.scene === state.scene);
  if (!chart.errors.includes(state.error)) state.error = chart.errors[0];
  choices(at('scene'), charts.map(c => [c.scene, c.title]), state.scene);
  choices(at('error'), chart.errors.map(e => [e, titles[e]]), state.error);
  at('cost').value = state.cost;
  at('methods').replaceChildren(...chart.curves.map(curve => {
    const label = document.createElement('label'), check = document.createElement('input');
    check.type = 'checkbox';
    check.checked = !state.off.has(curve.name);
    check.onchange = () => { state.off[check.checked ? 'delete' : 'add'](curve.name); draw(); };
    label.className = check.checked ? '' : 'off';
    label.style.color = letters[curve.colour % letters.length];
    label.append(check, ' ' + curve.name);
    return label;
  }));
  const smallest = chart.smallest_error_judged[state.error];
  const shown = chart.cases.filter(c => !c.diverged && !state.off.has(c.curve) && c.errors[state.error] <= 3 && c.errors[state.error] > smallest);
  const plot = at('plot');
  plot.replaceChildren();
  if (shown.length) {
    const x = axis(shown.map(c => c.errors[state.error]), box.right, box.left);
    const y = axis(shown.map(c => c[state.cost]), box.bottom, box.top);
    const point = c => `${x.place(c.errors[state.error]).toFixed(1)},${y.place(c[state.cost]).toFixed(1)}`;
    drawAxes(plot, x, y, chart);
    element('polyline', { points: front(shown).map(point).join(' '), fill: 'none', stroke: '#ddd', 'stroke-width': 12, 'stroke-linejoin': 'round' }, plot);
    chart.curves.forEach((curve, i) => {
      const colour = colours[curve.colour % colours.length];
      const own = shown.filter(c => c.curve === curve.name), line = front(own);
      const variant = chart.curves.slice(0, i).filter(other => other.colour === curve.colour).length;
      element('polyline', { points: line.map(point).join(' '), fill: 'none', stroke: colour, 'stroke-width': 2.5, 'stroke-dasharray': ['none', '7 5', '2 4'][Math.min(variant, 2)] }, plot);
      for (const c of own) {
        const [cx, cy] = point(c).split(',');
        const best = line.includes(c);
        const dot = element('circle', { cx, cy, r: best ? 6 : 4.5, fill: colour, 'fill-opacity': best ? 1 : 0.35, tabindex: 0 }, plot);
        dot.onmousemove = dot.onmouseover = event => showTip(event, c);
        dot.onmouseout = () => { at('tip').hidden = true; };
        element('title', {}, dot, describe(c));
      }
    });
  }
  const diverged = chart.cases.filter(c => c.diverged && !state.off.has(c.curve));
  const notes = [
    `${chart.links} links, ${chart.horizon} s. Bold points: the best of their method. Grey band: the best of all shown.`,
    'Reference: ' + chart.reference + '.', chart.remark && 'Note: ' + chart.remark + '.',
    diverged.length ? `Diverged or refused (${diverged.length}): ` + diverged.map(c => c.curve + ' ' + (c.settings.steps_per_second ? c.settings.steps_per_second + '/s' : c.settings.tolerance + ' m') + (c.settings.passes > 1 ? ' × ' + c.settings.passes : '')).join(', ') + '.' : 'No run diverged.',
    chart.omissions.length && 'Left out: ' + chart.omissions.join('; ') + '.',
    `${chart.completed} cases run, ${chart.planned - chart.completed} open; left out: ${chart.left_out.off_the_front} off their method's front, ${chart.left_out.no_gain} without gain, ${chart.left_out.too_dear} too slow.`,
    `${chart.processor}; ${chart.build}; ${chart.flags}; commit ${chart.commit}.`].filter(note => note);
  at('notes').replaceChildren(...notes.map(note => { const p = document.createElement('p'); p.textContent = note; return p; }));
  at('tip').hidden = true;
  writeAddress();
}
at('scene').onchange = event => { state.scene = event.target.value; draw(); };
at('error').onchange = event => { state.error = event.target.value; draw(); };
at('cost').onchange = event => { state.cost = event.target.value; draw(); };
readAddress();
draw();
</script>
</body>
</html>
)HTML";

// Inside a script element only its own end is special.
std::string fit_for_script(std::string_view json) {
  std::string safe;
  for (const char c : json) safe += c == '<' ? "\\u003c" : std::string(1, c);
  return safe;
}

}  // namespace

std::string chart_page(const std::vector<std::string>& charts) {
  std::string page(page_head), colours;
  page += '[';
  for (std::size_t i = 0; i < charts.size(); ++i) page += (i > 0 ? "," : "") + fit_for_script(charts[i]);
  page += ']';
  std::string letters;
  for (std::size_t i = 0; i < plot_styles; ++i) {
    colours += fmt::format("{}'{}'", i > 0 ? ", " : "", plot_colour(i));
    letters += fmt::format("{}'{}'", i > 0 ? ", " : "", plot_text_colour(i));
  }
  page += fmt::format("</script>\n<script>const colours = [{}], letters = [{}];", colours, letters);
  page += page_script;
  return page;
}

}  // namespace taut
