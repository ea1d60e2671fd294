// SPDX-License-Identifier: Apache-2.0
// A result as a map to click. Positions are metres east and north of the south-west corner of the cells (L.CRS.Simple).
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const { grid, words } = data;
const count = grid.columns * grid.rows;

/** A number in the page's language. */
function numberText(value, digits = 3) {
  return value.toLocaleString(data.language, { maximumSignificantDigits: digits });
}

/** A value that was rounded to a step, with no more decimals than the step has. */
function steppedText(value, step) {
  const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  return value.toLocaleString(data.language, { maximumFractionDigits: Math.min(decimals, 12) });
}

/** An element with text and children; texts of the result never become markup. */
function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) key in made ? (made[key] = value) : made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** Unpacks cells: differences along the rows in steps, their four bytes apart from each other, compressed; 0: no data. */
async function unpacked(text, step) {
  const packed = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const values = new Float64Array(count);
  for (let row = 0, cell = 0; row < grid.rows; ++row)
    for (let column = 0, last = 0; column < grid.columns; ++column, ++cell) {
      last = (last + (bytes[cell] | bytes[cell + count] << 8 | bytes[cell + 2 * count] << 16 | bytes[cell + 3 * count] << 24)) | 0;
      values[cell] = last === 0 ? NaN : (last > 0 ? last - 1 : last) * step;
    }
  return values;
}

const held = new Map();
/** The cells of a raster { step, cells }, unpacked when they are first asked for. */
function cellsOf(raster) {
  if (!held.has(raster)) held.set(raster, unpacked(raster.cells, raster.step));
  return held.get(raster);
}

const k_snap = 0.25;
const map = L.map('map', { crs: L.CRS.Simple, attributionControl: false, zoomSnap: k_snap, zoomDelta: 0.5, minZoom: -12,
  maxZoom: Math.max(2, Math.log2(60 / grid.cell)), doubleClickZoom: false });
const extent = [[0, 0], [grid.rows * grid.cell, grid.columns * grid.cell]];
map.zoomControl.setPosition('bottomright');  // beside popups, also on a phone
map.zoomControl.getContainer().querySelectorAll('a').forEach((link, i) => link.setAttribute('title', i ? words.out : words.in));
L.control.scale({ imperial: false }).addTo(map);
map.fitBounds(extent);
map.setMaxBounds(L.latLngBounds(extent).pad(1));

/** A canvas over all cells, as a layer of the map. */
const CanvasLayer = L.ImageOverlay.extend({
  _initImage() {
    this._image = this._url;
    L.DomUtil.addClass(this._image, 'leaflet-image-layer');
    if (this._zoomAnimated) L.DomUtil.addClass(this._image, 'leaflet-zoom-animated');
  }
});
function cellCanvas(kind, finer = 1) {
  const canvas = element('canvas', { width: grid.columns * finer, height: grid.rows * finer, className: kind });
  canvas.setAttribute('aria-hidden', 'true');
  return canvas;
}
function paint(canvas, colourOf) {
  const context = canvas.getContext('2d'), image = context.createImageData(canvas.width, canvas.height);
  const pixels = new Uint32Array(image.data.buffer);
  for (let row = 0, pixel = 0; row < canvas.height; ++row)
    for (let column = 0; column < canvas.width; ++column, ++pixel) pixels[pixel] = colourOf(row, column);
  context.putImageData(image, 0, 0);
}
const opaque = ([r, g, b]) => (255 << 24 | b << 16 | g << 8 | r) >>> 0;

/** Lit from the north-west, 45 degrees high. */
async function paintRelief(canvas) {
  const ground = await cellsOf(data.ground);
  const at = (row, column) => ground[Math.min(grid.rows - 1, Math.max(0, row)) * grid.columns +
    Math.min(grid.columns - 1, Math.max(0, column))];
  paint(canvas, (row, column) => {
    const east = (at(row, column + 1) - at(row, column - 1)) / (2 * grid.cell);
    const south = (at(row + 1, column) - at(row - 1, column)) / (2 * grid.cell);
    const lit = (0.5 * east + 0.5 * south + Math.SQRT1_2) / Math.hypot(east, south, 1);
    const grey = Math.round(70 + 180 * Math.min(1, Math.max(0, lit)));
    return Number.isNaN(lit) ? 0 : opaque([grey, grey, grey]);
  });
}

// Pixels of a cell along each side: edges are smoothed for display, as on the pictures.
const finer = Math.min(4, Math.max(1, Math.floor(Math.sqrt(2e6 / count))));
const shown = cellCanvas('cells', finer);
if (data.ground) {
  const relief = cellCanvas('relief');
  new CanvasLayer(relief, extent).addTo(map);
  paintRelief(relief);
}
const overlay = new CanvasLayer(shown, extent, { opacity: 0.75 }).addTo(map);

const byId = id => document.getElementById(id);
let layer = data.layers.find(one => one.name === data.first), frame = -1, turn = 0;

/** Index of a value's class; -1: not drawn. */
function classOf(one, value) {
  if (Number.isNaN(value) || (one.blank && value === 0)) return -1;
  if (one.exact) return one.classes.findIndex(entry => entry.to === value);
  const index = one.classes.findIndex(entry => entry.to === null || value <= entry.to);
  return index < 0 ? one.classes.length - 1 : index;
}

/** Index of the class that a pixel shows: where the cells with one count less than half of the four around it, -1;
 * else that of their mean, or of exact values the one that counts most. */
function shownClass(look, values, classes, row, column) {
  const y = (row + 0.5) / finer - 0.5, x = (column + 0.5) / finer - 0.5, top = Math.floor(y), left = Math.floor(x);
  const at = (r, c) => r < 0 || c < 0 || r >= grid.rows || c >= grid.columns ? -1 : classes[r * grid.columns + c];
  const four = [at(top, left), at(top, left + 1), at(top + 1, left), at(top + 1, left + 1)];
  if (four.every(one => one === four[0])) return four[0];
  const weights = four.map((one, k) => one < 0 ? 0 : (1 - Math.abs(y - top - (k >> 1))) * (1 - Math.abs(x - left - (k & 1))));
  const covered = weights.reduce((sum, weight) => sum + weight);
  if (covered < 0.5) return -1;
  if (!look.exact) return classOf(look, weights.reduce((sum, weight, k) =>
    weight > 0 ? sum + weight * values[(top + (k >> 1)) * grid.columns + left + (k & 1)] : sum, 0) / covered);
  const countOf = of => four.reduce((sum, one, k) => one === of ? sum + weights[k] : sum, 0);
  return four.reduce((most, one) => countOf(one) > countOf(most) ? one : most);
}

/** Draws the layer, or a frame, that was chosen last. */
async function showLayer() {
  const asked = ++turn, look = frame < 0 ? layer : data.frames;
  const values = await cellsOf(frame < 0 ? layer : data.frames.list[frame]);
  if (asked !== turn) return;
  const colours = look.classes.map(entry => opaque(entry.colour));
  const classes = Int16Array.from(values, value => classOf(look, value));
  paint(shown, (row, column) => {
    const index = shownClass(look, values, classes, row, column);
    return index < 0 ? 0 : colours[index];
  });
  byId('legend').replaceChildren(element('h2', {}, look.title), ...look.classes.map(entry => {
    const swatch = element('span', { className: 'swatch' });
    swatch.style.background = `rgb(${entry.colour})`;
    return element('div', {}, swatch, entry.label);
  }), ...(look.notes || []).map(note => element('p', { className: 'small' }, note)));
  byId('time-text').textContent = frame < 0 ? '' : `${numberText(data.frames.list[frame].time, 4)} s`;
}

const choice = byId('layer');
choice.append(...data.layers.map(one => element('option', {}, one.title)));
if (data.frames) choice.append(element('option', {}, `${words.time}: ${data.frames.title}`));
choice.selectedIndex = data.layers.indexOf(layer);
choice.addEventListener('change', () => {
  const isTime = choice.selectedIndex === data.layers.length;
  if (!isTime) {
    layer = data.layers[choice.selectedIndex];
    play(false);
  }
  frame = isTime ? Number(byId('frame').value) : -1;
  showLayer();
  if (asked) ask(asked);
});

// ---- Outlines and features

const projected = points => points.map(([x, y]) => [y, x]);
/** A feature as Leaflet draws it: points, lines, or areas of rings. */
function drawn(shape, feature) {
  const style = { color: feature.colour || shape.colour, weight: shape.width, dashArray: shape.dashed ? '6 5' : null,
    fillOpacity: 0, interactive: false };
  if (feature.points) return L.featureGroup(projected(feature.points).map(place =>
    L.circleMarker(place, { ...style, radius: 5, weight: 2, fill: true, fillOpacity: 0.6 })));
  return feature.lines ? L.polyline(feature.lines.map(projected), style)
    : L.polygon(feature.areas.map(rings => rings.map(projected)), style);
}
for (const shape of data.shapes) shape.group = L.featureGroup(shape.features.map(feature => drawn(shape, feature)));
for (const shape of data.shapes) {
  const swatchOf = colour => {
    const swatch = element('span', { className: 'swatch' });
    swatch.style.cssText = `height: 0; border: 0; border-top: 3px ${shape.dashed ? 'dashed' : 'solid'} ${colour}; vertical-align: .25em`;
    return swatch;
  };
  const input = element('input', { type: 'checkbox', checked: shape.visible }), looks = shape.looks || [];
  const show = () => input.checked ? shape.group.addTo(map) : shape.group.remove();
  input.addEventListener('change', show);
  show();
  byId('outlines').append(element('label', {}, input, ' ', ...(looks.length ? [] : [swatchOf(shape.colour)]), shape.title),
    ...looks.map(look => element('div', { className: 'look' }, swatchOf(look.colour), look.label)));
}
byId('outlines').hidden = data.shapes.length === 0;

/** Distance of a place to a segment [m]. */
function distance([x, y], [ax, ay], [bx, by]) {
  const length = (bx - ax) ** 2 + (by - ay) ** 2;
  const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length)) : 0;
  return Math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay));
}
const nearLine = (place, line, reach) => line.some((point, i) => i > 0 && distance(place, line[i - 1], point) <= reach);
const inRings = ([x, y], rings) => rings.reduce((inside, ring) => ring.reduce((now, [ax, ay], i) => {
  const [bx, by] = ring[(i + 1) % ring.length];
  return (ay > y) !== (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax ? !now : now;
}, inside), false);
function isAt(feature, place, reach) {
  if (feature.points) return feature.points.some(point => Math.hypot(point[0] - place[0], point[1] - place[1]) <= reach);
  return feature.lines ? feature.lines.some(line => nearLine(place, line, reach))
    : feature.areas.some(rings => inRings(place, rings));
}

// ---- Click

function cellAt([x, y]) {
  const column = Math.floor(x / grid.cell), row = grid.rows - 1 - Math.floor(y / grid.cell);
  return column < 0 || row < 0 || column >= grid.columns || row >= grid.rows ? -1 : row * grid.columns + column;
}

/** A value with its error or interval; empty: no data. */
async function valueText(one, cell) {
  const upper = one.upper ? (await cellsOf(one.upper))[cell] : NaN, drawn = (await cellsOf(one))[cell];
  if (Number.isNaN(drawn) && !(upper > 0)) return '';
  const value = Number.isNaN(drawn) ? 0 : drawn;  // zeros are not drawn
  if (one.exact) return one.classes.find(entry => entry.to === value)?.label || '';
  let text = steppedText(value, one.step);
  if (one.margin) text += ` ± ${numberText((await cellsOf(one.margin))[cell] || 0, 2)}`;
  if (one.low) {
    const [low, high] = [(await cellsOf(one.low))[cell], (await cellsOf(one.high))[cell]];
    text += ` (${Number.isNaN(low) ? '?' : steppedText(low, one.step)} – ${Number.isNaN(high) ? '?' : steppedText(high, one.step)})`;
  }
  if (upper > value) text += ` (≤ ${steppedText(upper, one.step)})`;
  return one.unit ? `${text} ${one.unit}` : text;
}

/** Longitude and latitude, between the places of a lattice of known ones. */
function degreesAt([x, y]) {
  const n = data.degrees.count - 1, a = x / (grid.columns * grid.cell) * n, b = y / (grid.rows * grid.cell) * n;
  const i = Math.min(n - 1, Math.max(0, Math.floor(a))), j = Math.min(n - 1, Math.max(0, Math.floor(b)));
  const at = (list, p, q) => list[q * (n + 1) + p];
  return ['longitudes', 'latitudes'].map(key => {
    const list = data.degrees[key], s = a - i, t = b - j;
    return (1 - t) * ((1 - s) * at(list, i, j) + s * at(list, i + 1, j)) + t * ((1 - s) * at(list, i, j + 1) + s * at(list, i + 1, j + 1));
  });
}
function placeRows([x, y]) {
  const rows = [[data.crs, `${(grid.west + x).toFixed(1)}, ${(grid.south + y).toFixed(1)}`]];
  if (data.degrees) {
    const [longitude, latitude] = degreesAt([x, y]);
    rows.push([words.degrees, `${latitude.toFixed(6)}, ${longitude.toFixed(6)}`]);
  }
  return rows;
}
function table(title, rows) {
  return element('table', {}, ...(title ? [element('caption', {}, title)] : []), element('tbody', {}, ...rows.map(([name, text]) =>
    element('tr', {}, element('th', { scope: 'row' }, name), element('td', {}, text)))));
}

let asked = null;  // the place whose values are shown
map.on('popupclose', () => { asked = null; });
/** Shows all that is known of a place in the panel, and in a popup what the map shows there. */
async function ask(place) {
  const cell = cellAt(place), isInside = cell >= 0;  // features may lie beside the cells
  const rows = [], others = [];
  if (isInside && frame >= 0) {
    const one = data.frames.list[frame], value = (await cellsOf(one))[cell];
    if (!Number.isNaN(value)) rows.push([`${data.frames.title}, ${numberText(one.time, 4)} s`, `${steppedText(value, one.step)} ${data.frames.unit}`]);
  }
  for (const one of isInside ? data.layers : []) {
    const text = await valueText(one, cell);
    if (text) (one === layer && frame < 0 ? rows : others).push([one.title, text]);
  }
  if (isInside && data.ground) rows.push([data.ground.title, `${steppedText((await cellsOf(data.ground))[cell], data.ground.step)} m`]);
  const isNarrow = window.matchMedia('(max-width: 45rem)').matches;  // the panel is below the map
  const reach = 8 * 2 ** -map.getZoom(), tables = [table(words.here, rows.concat(placeRows(place)))];
  const here = [table('', isNarrow ? rows.concat(others, placeRows(place)) : rows)];
  for (const shape of data.shapes)
    for (const feature of shape.features)
      if (feature.rows.length > 0 && map.hasLayer(shape.group) && isAt(feature, place, reach)) {
        const object = table(shape.title, feature.rows);
        tables.push(object);
        here.push(object.cloneNode(true));
      }
  if (!isInside && here.length === 1) return;
  if (others.length > 0) tables.push(table(words.maps, others));
  byId('values').replaceChildren(...tables);
  L.popup({ maxHeight: 200, maxWidth: 300 }).setLatLng([place[1], place[0]]).setContent(element('div', {}, ...here)).openOn(map);
  asked = place;
}

// ---- Line

let line = null;
const sketch = L.polyline([], { color: '#c0006e', weight: 3 }).addTo(map);
function setDrawing(on) {
  byId('line').setAttribute('aria-pressed', String(on));
  line = on ? [] : null;
  byId('line-help').hidden = !on;
  if (on) { sketch.setLatLngs([]); byId('chart').replaceChildren(); byId('save').hidden = true; }
}
const along = data.layers.filter(one => data.along.includes(one.name));
/** Samples of a line, half a cell apart: distance, place, ground, and the values of depth and speed. */
async function profileOf(points) {
  const ground = data.ground ? await cellsOf(data.ground) : null, columns = await Promise.all(along.map(cellsOf)), samples = [];
  let done = 0;
  for (let i = 1; i < points.length; ++i) {
    const [[ax, ay], [bx, by]] = [points[i - 1], points[i]], length = Math.hypot(bx - ax, by - ay);
    const steps = Math.max(1, Math.ceil(length / (0.5 * grid.cell)));
    for (let k = i > 1 ? 1 : 0; k <= steps; ++k) {
      const place = [ax + (bx - ax) * k / steps, ay + (by - ay) * k / steps], cell = cellAt(place);
      samples.push({ distance: done + length * k / steps, place, ground: ground && cell >= 0 ? ground[cell] : NaN,
        values: columns.map(values => cell >= 0 ? values[cell] : NaN) });
    }
    done += length;
  }
  return samples;
}
/** One chart: a curve against distance, with the greatest and the least value. */
function chart(title, samples, valueOf, fromZero) {
  const values = samples.map(valueOf), known = values.filter(value => !Number.isNaN(value));
  const [width, height, left, top] = [320, 110, 46, 14], end = samples[samples.length - 1].distance || 1;
  const low = fromZero ? 0 : Math.min(...known), high = Math.max(...known, low + 1e-9);
  const x = i => left + (width - left - 6) * samples[i].distance / end, y = value => height - 18 - (height - 18 - top) * (value - low) / (high - low);
  let path = '', pen = false;
  values.forEach((value, i) => { path += Number.isNaN(value) ? '' : `${pen ? 'L' : 'M'}${x(i).toFixed(1)} ${y(value).toFixed(1)}`; pen = !Number.isNaN(value); });
  const svg = (name, attributes, text) => {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    return made;
  };
  const page = svg('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': title });
  page.append(svg('path', { d: path, fill: 'none', stroke: '#0072b2', 'stroke-width': 1.6 }),
    svg('path', { d: `M${left} ${top}V${height - 18}H${width - 6}`, fill: 'none', stroke: '#666' }));
  const write = (text, px, py, anchor) => page.append(svg('text', { x: px, y: py, 'font-size': 10, 'text-anchor': anchor, fill: '#1a1a1a' }, text));
  write(title, left, 10, 'start');
  if (known.length > 0) { write(numberText(high), left - 4, top + 8, 'end'); write(numberText(low), left - 4, height - 18, 'end'); }
  write('0', left, height - 6, 'middle'); write(`${numberText(end, 4)} m`, width - 6, height - 6, 'end');
  return page;
}
async function endLine() {
  const points = line;
  setDrawing(false);
  const [first] = points || [];
  if (!first || points.every(([x, y]) => Math.hypot(x - first[0], y - first[1]) < grid.cell)) return;  // a double click
  sketch.setLatLngs(projected(points));
  const samples = await profileOf(points), number = value => Number.isNaN(value) ? '' : String(Number(value.toPrecision(9)));
  byId('chart').replaceChildren(...along.map((one, i) => chart(`${one.title}${one.unit ? ` [${one.unit}]` : ''}`, samples, sample => sample.values[i], true)),
    ...(data.ground ? [chart(`${data.ground.title} [m]`, samples, sample => sample.ground, false)] : []));
  const rows = samples.map(sample => [sample.distance, grid.west + sample.place[0], grid.south + sample.place[1], sample.ground, ...sample.values].map(number).join(','));
  const head = ['distance_m', 'x', 'y', 'ground_m', ...along.map(one => one.column)].join(',');
  byId('save').hidden = false;
  byId('save').onclick = () => element('a', { download: 'line.csv',
    href: `data:text/csv;charset=utf-8,${encodeURIComponent([head, ...rows].join('\n') + '\n')}` }).click();
}
byId('line').addEventListener('click', () => line ? endLine() : setDrawing(true));
function pointed(place) {
  if (!line) return ask(place);
  line.push(place);
  sketch.setLatLngs(projected(line));
}
map.on('click', event => pointed([event.latlng.lng, event.latlng.lat]));
map.on('dblclick', () => { if (line) endLine(); });
// Without a mouse: arrows move the map, Enter asks for its middle.
map.getContainer().addEventListener('keydown', event => {
  const middle = map.getCenter();
  if (event.key === 'Enter' && event.target === map.getContainer()) pointed([middle.lng, middle.lat]);
  if (event.key === 'Escape') { map.closePopup(); setDrawing(false); }
});

// ---- Opacity and time

byId('opacity').addEventListener('input', event => overlay.setOpacity(event.target.value / 100));
let timer = 0;
/** Lets the frames run, or stops them. */
function play(on) {
  const slider = byId('frame');
  clearInterval(timer);
  timer = on ? setInterval(() => { slider.value = (Number(slider.value) + 1) % data.frames.list.length; showFrame(); }, 250) : 0;
  byId('play').setAttribute('aria-pressed', String(on));
  byId('play').textContent = on ? words.pause : words.play;
}
function showFrame() {
  frame = Number(byId('frame').value);
  choice.selectedIndex = data.layers.length;
  showLayer();
}
if (data.frames) {
  const slider = byId('frame');
  slider.max = data.frames.list.length - 1;
  slider.addEventListener('input', showFrame);
  byId('play').addEventListener('click', () => play(timer === 0));
} else byId('time').hidden = true;

// ---- Paper

/** The map in the middle of an A4 page that is turned as its ground is; what is beside it goes below. */
const box = map.getContainer(), sheet = element('style'), isUpright = grid.rows > grid.columns;
window.addEventListener('beforeprint', () => {
  const [width, most] = isUpright ? [186, 190] : [273, 125], mm = 96 / 25.4;
  sheet.textContent = `@page { size: A4 ${isUpright ? 'portrait' : 'landscape'}; }`;
  document.head.append(sheet);
  const height = Math.min(most, width * grid.rows / grid.columns);
  Object.assign(box.style, { width: `${Math.min(width, height * grid.columns / grid.rows) * mm}px`, height: `${height * mm}px` });
  map.closePopup();
  map.options.zoomSnap = 0;
  map.invalidateSize(false);
  map.fitBounds(extent, { animate: false });
});
window.addEventListener('afterprint', () => {
  Object.assign(box.style, { width: '', height: '' });
  map.options.zoomSnap = k_snap;
  map.invalidateSize(false);
  map.fitBounds(extent, { animate: false });
});
showLayer();
