// SPDX-License-Identifier: MIT
import {ask, onLate} from "./asking.js";
import {Drawing, drawSlide, drawSum, drawSummands, element} from "./drawing.js";
import * as files from "./files.js";
import {show} from "./gallery.js";
import * as history from "./history.js";
import * as proofs from "./proofs.js";
import * as saved from "./saved.js";
import {SlideControls} from "./slide_controls.js";
import {address, layers, read, stateOf} from "./state.js";
import {captions, countsLine, placementLine, segmentLine, verdictLines, words} from "./words.js";

const $ = (id) => document.getElementById(id);
let state = read("");
let answer = null;  // the last one
let valid = null;  // the last one of valid P and Q
let selected = null;  // {of, chain, vertex}
let drag = null;
let held = null;  // the move that arrow keys ask for and the core has not got yet
const summands = new Drawing($("summands")), sum = new Drawing($("sum"));
const handles = new Map();
const slide = new SlideControls(() => ({valid, what: state.what, q: state.q}), summands, () => draw());
onLate(() => { $("status").textContent = "Computing."; });
summands.redraw = sum.redraw = () => draw();

/** The state has been reached: it is in the address, and can be come back to. */
function keep(dragged) {
  const now = address(state);
  window.history.replaceState(null, "", now);
  history.record(now, dragged);
  $("undo").disabled = !history.canUndo();
  $("redo").disabled = !history.canRedo();
}

/** Proved are sums of regions, exactly. */
const isProvable = () => state.what === "sum" && !state.grid
  && !["p", "q"].some((of) => answer?.[of].kinds.some((kind) => kind === "line" || kind === "point"));
const provable = () => ({...state, proved: state.proved && isProvable()});

/** With the proved sum, if P and Q are to be what they are. */
const request = (edit) => ({p: state.p, q: state.q, x: state.x, step: state.step, what: state.what, open: state.open,
  grid: state.grid, side: state.side, s: state.s,
  sum: !edit || edit.of === "x" ? proofs.sumOf(provable()) : undefined, ...(edit && {edit})});

/** Takes an answer as the new state, or says why there is none. */
function take(given, after, dragged) {
  const {error, refused} = given;
  $("error").hidden = !error;
  $("error").textContent = error ?? "";
  if (refused) {
    $("status").textContent = "Nothing was changed.";
    if (!valid) $("stale").hidden = true;
    return;
  }
  const followed = answer && turned(given);
  answer = given;
  if (followed) follow(followed);
  state.p = answer.p.wkt;
  state.q = answer.q.wkt;
  state.x = answer.x;
  if (!error) valid = answer;
  slide.check();
  after?.();
  if (valid) {
    state.cycle = Math.min(state.cycle, Math.max(0, valid.cycles.length - 1));
    state.at = Math.min(state.at, Math.max(0, (valid.cycles[state.cycle]?.length ?? 1) - 1));
  }
  if (!drag) keep(dragged);
  draw();
  prove();
  tell();
}

function prove() {
  if (drag || !answer) return;
  proofs.prove(provable(), () => {
    tell();
    if (proofs.sumOf(provable())) update();
  });
}

/** Where the selected vertex is now, if the core has turned its chain, which keeps the first vertex. */
function turned(given) {
  const [before, after] = [answer, given].map((one) => one[selected?.of]?.points?.[selected.chain]);
  if (!before || after?.length !== before.length) return null;
  const mirrored = (v) => (before.length - v) % before.length;
  const others = [...before.keys()].filter((v) => v !== selected.vertex);
  return others.every((v) => after[mirrored(v)] === before[v]) && others.some((v) => after[v] !== before[v])
    ? {...selected, vertex: mirrored(selected.vertex)} : null;
}

function update(edit, after) {
  held = null;
  ask(() => request(edit), (given) => take(given, after));
}

/** Moves by some steps. Keys held down are faster than a slow core: their steps add up. */
function move(edit) {
  if (held && ["of", "chain", "vertex"].every((name) => held[name] === edit[name])) {
    held.at = held.at.map((c, i) => c + edit.at[i]);
    return;
  }
  held = edit;
  ask(() => {
    if (held === edit) held = null;
    return request(edit);
  }, take);
}

function fit() {
  if (!answer) return;
  summands.fit([...answer.p.chains, ...answer.q.chains, ...(answer.placement?.q ?? [])].flat());
  if (!valid) return;
  const ends = ([a, b, c, d]) => [[a, b], [c, d]], {outer, dangling, isolated} = valid.sum;
  sum.fit([...outer.flat(), ...isolated, ...[...dangling, ...valid.cycles.flat()].flatMap(ends), answer.at]);
}

function refit() {
  typed.clear();
  fit();
}

function draw() {
  if (!answer) return;
  drawSummands(summands, answer, state.layers);
  if (slide.shown) drawSlide(summands, slide.shown, answer.q);
  if (valid) drawSum(sum, {...valid, verdict: answer.verdict}, state.layers, state, answer !== valid);
  drawHandles();
}

/** Handles keep their elements, and with them the focus. */
function handle(key, drawing, kind, make) {
  if (!handles.has(key)) {
    const made = element("g", {class: "handle " + kind, role: "button"}, element("circle", {class: "target", r: 13}), make());
    handles.set(key, drawing.handles.appendChild(made));
  }
  return handles.get(key);
}

function drawHandles() {
  const kept = new Set();
  for (const of of ["p", "q"]) {
    let isFirst = true;
    answer[of].chains.forEach((chain, c) => chain.forEach((at, v) => {
      const key = `${of} ${c} ${v}`, one = handle(key, summands, of, () => element("circle", {r: 4.5}));
      kept.add(key);
      one.vertex = {of, chain: c, vertex: v};
      one.at = at;
      const isSelected = selected?.of === of && selected.chain === c && selected.vertex === v;
      one.setAttribute("transform", `translate(${summands.pixel(at)})`);
      one.setAttribute("aria-label", `${of.toUpperCase()}, ${answer[of].names[c]}, vertex ${v + 1} of ${chain.length} at ${answer[of].points[c][v]}`);
      one.setAttribute("tabindex", isSelected || (isFirst && selected?.of !== of) ? 0 : -1);
      isFirst = false;
    }));
  }
  for (const [key, drawing] of [["x", sum], ["x of Q", summands]]) {
    const one = handle(key, drawing, "x", () => element("path", {class: "mark", d: "M-8,0H8M0,-8V8"}));
    kept.add(key);
    one.vertex = {of: "x"};
    one.at = answer.at;
    one.setAttribute("transform", `translate(${drawing.pixel(answer.at)})`);
    one.setAttribute("aria-label", `Point x at (${answer.x.join(", ")})`);
    one.setAttribute("tabindex", key === "x" ? 0 : -1);
  }
  for (const [key, one] of handles) {
    if (kept.has(key)) continue;
    one.remove();
    handles.delete(key);
  }
}

const typed = new Set();  // P and Q that were typed and are not used yet, and a certificate that was
const field = (id, text) => { if (document.activeElement !== $(id) && !typed.has(id)) $(id).value = text; };

/** What is chosen, not typed. */
function tellChoices() {
  $("what").value = state.what;
  $("side").value = state.side;
  $("open").checked = state.open;
}

/** All texts of the page. */
function tell() {
  tellChoices();
  const isStale = answer !== valid, {p, q} = answer;
  $("proved").checked = state.proved;
  const same = proofs.sumOf(provable()) ? valid.sum.same : undefined;  // of the proved sum; none before it is shown
  $("proof").textContent = (state.proved && !isProvable() ? "Sums of regions only are proved, not rounded." : proofs.lineOfSum(state))
    + (same === undefined ? "" : same ? " The core computes the same one." : " The core computes another one.");
  $("sum-caption").textContent = captions[state.what] + (same === undefined ? "" : ", proved") + (valid?.exact ? ", rounded" : "");
  $("placed-caption").textContent = state.what === "sum" ? "−Q + x" : "Q + x";
  $("word").textContent = words[state.what];
  $("along").textContent = state.what === "sum" ? "along P" : "along the boundary of the result";
  $("open").disabled = state.what !== "sum";
  $("play").disabled = $("slide").disabled = !valid;
  $("check").disabled = !isProvable();
  field("grid", state.grid);
  const {line = "", isWrong = false, text = ""} = proofs.verdictOf(state);
  $("certified").textContent = line;
  $("certified").classList.toggle("wrong", isWrong);
  $("cancel").disabled = !proofs.isBusy();
  field("certificate", text);
  $("stale").hidden = !isStale || !valid;
  field("p-wkt", p.wkt);
  field("q-wkt", q.wkt);
  field("x0", answer.x[0]);
  field("x1", answer.x[1]);
  field("step", state.step);
  $("selected").textContent = !selected ? "nothing" : selected.of === "x" ? "x"
    : handles.get(`${selected.of} ${selected.chain} ${selected.vertex}`)?.getAttribute("aria-label") ?? "nothing";
  $("add").disabled = $("remove").disabled = !selected || selected.of === "x";
  for (const name of Object.keys(layers)) $("layer-" + name).checked = state.layers.includes(name);
  const notes = [...p.notes, ...q.notes].join("; ");
  $("status").textContent = isStale ? "P or Q is invalid." : `P: ${p.vertices}. Q: ${q.vertices}.` + (notes && ` ${notes}.`);
  if (!valid) return;
  const {sum: set, cycles} = valid, {verdict} = answer;
  $("sum-wkt").value = set.wkt;
  $("counts").textContent = countsLine(valid);
  $("placement").textContent = placementLine(valid, state.what);
  const options = cycles.map((cycle, i) => new Option(`${i + 1} of ${cycles.length}: ${cycle.length} segments`, i));
  if ([...$("cycle").options].map((o) => o.text).join() !== options.map((o) => o.text).join())
    $("cycle").replaceChildren(...options);
  $("cycle").value = state.cycle;
  $("segment").textContent = segmentLine(cycles[state.cycle], state.at);
  $("verdict").textContent = verdictLines(verdict);
  $("verdict").classList.toggle("wrong", Boolean(verdict && !verdict.is_sum));
}

/** Takes what a control says; what the core refuses is as before, but for what was typed. */
function change(changes, after) {
  let before;
  held = null;
  ask(() => {
    before = state;
    state = {...state, ...changes};
    return request();
  }, (given) => {
    if (given.refused) {
      state = before;
      keep();
      tellChoices();
    }
    if (given.refused && !answer) ask(request, (first) => { take(first, fit); take(given); });
    else take(given, after);
  });
}

function select(vertex, focus) {
  selected = vertex;
  drawHandles();
  if (focus) handles.get(vertex.of === "x" ? "x" : `${vertex.of} ${vertex.chain} ${vertex.vertex}`)?.focus();
  tell();
}

/** The handle nearest to a pointer on one: where vertices are close, its target covers others. */
function nearest(drawing, event) {
  const place = drawing.place(event);
  const far = ({at}) => Math.hypot(at[0] - place[0], at[1] - place[1]);
  return [...handles.values()].filter((one) => one.parentNode === drawing.handles)
    .reduce((best, one) => far(one) <= far(best) ? one : best);
}

const steps = (place) => place.map((c) => Math.round(c / answer.step));

for (const drawing of [summands, sum]) {
  const {svg} = drawing;
  svg.addEventListener("pointerdown", (event) => {
    if (!answer || !event.isPrimary || event.button) return;
    const one = event.target.closest(".handle") && nearest(drawing, event), of = event.target.dataset?.of;
    if (!one && !of) return;
    event.preventDefault();
    svg.setPointerCapture(event.pointerId);
    if (one) select(one.vertex, true);
    drag = {drawing, from: drawing.place(event), vertex: one?.vertex ?? {of}, how: one ? "to" : "by",
      p: state.p, q: state.q, x: state.x, pressed: [event.clientX, event.clientY], isClick: true};
  });
  svg.addEventListener("pointermove", (event) => {
    if (drag?.drawing !== drawing || !event.isPrimary) return;
    const place = drawing.place(event), {vertex, how, from, p, q, x, pressed: [left, top]} = drag, dragged = drag;
    drag.isClick &&= Math.hypot(event.clientX - left, event.clientY - top) < 4;
    const at = steps(how === "to" ? place : [place[0] - from[0], place[1] - from[1]]);
    if (drag.isClick || !at.every(Number.isFinite)) return;
    // From where it started: the core may turn a chain on the way, and number its vertices anew.
    ask(() => ({...request({...vertex, how, at}), p, q, x}), (given) => take(given, undefined, dragged), true);
  });
  const drop = () => {
    if (!drag) return;
    const dragged = drag;
    drag = null;
    keep(dragged);
    prove();
  };
  svg.addEventListener("pointerup", drop);
  svg.addEventListener("pointercancel", drop);
  svg.addEventListener("touchmove", (event) => { if (drag) event.preventDefault(); }, {passive: false});  // no scrolling
  // On the figure: Chromium makes an SVG that listens to focus a stop of the Tab key.
  svg.parentElement.addEventListener("focusin", (event) => {
    const vertex = event.target.vertex;
    if (vertex && (vertex.of !== selected?.of || vertex.chain !== selected.chain || vertex.vertex !== selected.vertex)) select(vertex);
  });
  svg.addEventListener("keydown", (event) => key(event, drawing));
}

summands.svg.addEventListener("dblclick", (event) => {
  const place = summands.place(event);
  let best = null;
  for (const of of ["p", "q"])
    answer[of].chains.forEach((chain, c) => chain.forEach((a, v) => {
      if (v === chain.length - 1 && ["line", "point"].includes(answer[of].kinds[c])) return;
      const b = chain[(v + 1) % chain.length], [dx, dy] = [b[0] - a[0], b[1] - a[1]];
      const t = Math.max(0, Math.min(1, ((place[0] - a[0]) * dx + (place[1] - a[1]) * dy) / (dx * dx + dy * dy)));
      const far = Math.hypot(a[0] + t * dx - place[0], a[1] + t * dy - place[1]) * summands.scale;
      if (far < 12 && far < (best?.far ?? Infinity)) best = {far, of, chain: c, vertex: v};
    }));
  if (best) add(best);
});

/** Selects what an edit leaves, as soon as it is drawn; the focus goes with it where it was in the drawings. */
function follow(vertex) {
  selected = vertex;
  if (vertex && document.activeElement?.closest("svg")) setTimeout(() => select(vertex, true));
}

function add({of, chain, vertex}) {
  update({of, chain, vertex, how: "add"}, () => follow({of, chain, vertex: vertex + 1}));
}

function remove({of, chain, vertex}) {
  update({of, chain, vertex, how: "remove"}, () => {
    const left = answer[of].chains[chain]?.length;
    follow(left ? {of, chain, vertex: Math.min(vertex, left - 1)} : null);
  });
}

function key(event, drawing) {
  const vertex = event.target.vertex;
  if (!vertex || !answer || event.ctrlKey || event.metaKey) return;
  const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
  const shape = answer[vertex.of], isVertex = vertex.of !== "x";
  if (arrows[event.key]) {
    const at = arrows[event.key].map((c) => c * (event.shiftKey ? 10 : 1));
    move({...(event.altKey && isVertex ? {of: vertex.of} : vertex), how: "by", at});
  } else if (isVertex && ["PageDown", "PageUp", "Home", "End"].includes(event.key)) {
    const all = shape.chains.flatMap((chain, c) => chain.map((_, v) => ({of: vertex.of, chain: c, vertex: v})));
    const here = all.findIndex((v) => v.chain === vertex.chain && v.vertex === vertex.vertex);
    const to = {PageDown: here + 1, PageUp: here - 1 + all.length, Home: 0, End: all.length - 1}[event.key];
    select(all[to % all.length], true);
  } else if (isVertex && ["Insert", "a", "A"].includes(event.key)) {
    add(vertex);
  } else if (isVertex && ["Delete", "Backspace"].includes(event.key)) {
    remove(vertex);
  } else if (["+", "="].includes(event.key)) {
    drawing.zoom(1.2);
  } else if (event.key === "-") {
    drawing.zoom(1 / 1.2);
  } else if (event.key === "0") {
    fit();
    draw();
  } else {
    return;
  }
  event.preventDefault();
}

for (const [name, [label, colour]] of Object.entries(layers)) {
  const box = Object.assign(document.createElement("input"), {type: "checkbox", id: "layer-" + name});
  const sample = document.createElement("i");
  sample.style.borderColor = `var(${colour})`;
  const line = Object.assign(document.createElement("label"), {className: "check"});
  line.append(box, sample, label);
  $("layers").append(line);
  box.addEventListener("change", () => {
    state.layers = Object.keys(layers).filter((one) => $("layer-" + one).checked);
    keep();
    draw();
  });
}
show($("gallery"), (example) => {
  $("example").textContent = `${example.statement}. ${example.text}`;
  change(stateOf(example, state), () => {
    $("s-wkt").value = "";
    selected = null;
    refit();
  });
});
for (const name of ["what", "grid", "side"]) $(name).addEventListener("change", () => change({[name]: $(name).value.trim()}, fit));
$("open").addEventListener("change", () => change({open: $("open").checked}));
$("step").addEventListener("change", () => change({step: $("step").value}));
$("move-x").addEventListener("click", () => change({x: [$("x0").value, $("x1").value]}));
for (const name of ["p", "q", "s"]) {
  const button = $(name === "s" ? "verify" : "use-" + name), text = $(name + "-wkt");
  text.addEventListener("input", () => typed.add(text.id));
  // Without s nothing is verified: an empty field is a blank.
  button.addEventListener("click", () => change({[name]: text.value || " "}, name === "s" ? undefined : () => {
    typed.delete(text.id);
    fit();
  }));
}
$("proved").addEventListener("change", () => {
  state = {...state, proved: $("proved").checked};
  keep();
  update();
});
$("certificate").addEventListener("input", () => typed.add("certificate"));
$("check").addEventListener("click", () => {
  if (!answer) return;
  if (!$("certificate").value) typed.delete("certificate");
  const other = typed.has("certificate") ? $("certificate").value : undefined;
  ask(() => ({certify: [state.p, state.q]}), (made) => proofs.check(state, made, other, tell));
});
$("cancel").addEventListener("click", () => {
  proofs.cancel();
  tell();
});
$("forget").addEventListener("click", () => {
  $("s-wkt").value = "";
  change({s: ""});
});
$("add").addEventListener("click", () => selected && selected.of !== "x" && add(selected));
$("remove").addEventListener("click", () => selected && selected.of !== "x" && remove(selected));
$("fit").addEventListener("click", () => { fit(); draw(); });
$("cycle").addEventListener("change", () => walk(Number($("cycle").value), 0));
$("next").addEventListener("click", () => walk(state.cycle, state.at + 1));
$("previous").addEventListener("click", () => walk(state.cycle, state.at - 1));

function walk(cycle, at) {
  const length = valid?.cycles[cycle]?.length;
  if (!length) return;
  state = {...state, cycle, at: (at + length) % length,
    layers: state.layers.includes("cycle") ? state.layers : [...state.layers, "cycle"]};
  keep();
  draw();
  tell();
}

/** Goes to the state of an address. */
function goTo(hash, after) {
  change(read(hash), () => {
    $("s-wkt").value = state.s;
    selected = null;
    typed.clear();
    after?.();
  });
}

history.listen((hash) => goTo(hash));
files.listen((texts) => change(texts, refit));

saved.listen(() => valid && {result: valid.sum, svg: sum.svg});

function start() {
  goTo(location.hash, () => {
    refit();
    navigator.serviceWorker?.register("offline.js");
  });
}
addEventListener("hashchange", start);
addEventListener("resize", () => draw());
start();
