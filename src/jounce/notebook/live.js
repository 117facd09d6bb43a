// Sliders for the numbers of a rig, and its curves beside those it had at first. Everything is text, nothing is markup.

const SVG = "http://www.w3.org/2000/svg";
const W = 420, H = 190, LEFT = 52, RIGHT = 8, TOP = 20, BOTTOM = 32;

function made(tag, attributes = {}, text = "") {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
  node.textContent = text;
  return node;
}

const written = (value) => String(Number(value.toPrecision(4))).replace("-", "−");

function ends(curves) {
  let low = Infinity, high = -Infinity;
  for (const curve of curves) for (const y of curve.y) if (y !== null) { low = Math.min(low, y); high = Math.max(high, y); }
  if (!(high > low)) { const middle = Number.isFinite(low) ? low : 0; low = middle - 1; high = middle + 1; }
  return [low, high];
}

function path(curve, x, y) {
  let text = "", pen = "M";
  curve.x.forEach((value, k) => {
    if (curve.y[k] === null) { pen = "M"; return; }
    text += `${pen}${x(value).toFixed(1)},${y(curve.y[k]).toFixed(1)}`;
    pen = "L";
  });
  return text;
}

function plot(before, now) {
  const [low, high] = ends([before, now]);
  const first = now.x[0], last = now.x[now.x.length - 1];
  const x = (value) => LEFT + ((value - first) / (last - first || 1)) * (W - LEFT - RIGHT);
  const y = (value) => H - BOTTOM - ((value - low) / (high - low)) * (H - TOP - BOTTOM);
  const svg = made("svg", { viewBox: `0 0 ${W} ${H}`, role: "img" });
  svg.append(made("title", {}, `${now.name} against ${now.across}`));
  svg.append(made("text", { x: LEFT, y: 13, "font-weight": "bold" }, `${now.name} [${now.unit || "–"}]`));
  svg.append(made("rect", { class: "frame", x: LEFT, y: TOP, width: W - LEFT - RIGHT, height: H - TOP - BOTTOM }));
  for (const value of [low, high]) svg.append(made("text", { x: LEFT - 5, y: y(value) + 4, "text-anchor": "end" }, written(value)));
  svg.append(made("text", { x: LEFT, y: H - BOTTOM + 14 }, written(first)));
  svg.append(made("text", { x: W - RIGHT, y: H - BOTTOM + 14, "text-anchor": "end" }, written(last)));
  svg.append(made("text", { x: (LEFT + W - RIGHT) / 2, y: H - 4, "text-anchor": "middle" }, now.across));
  svg.append(made("path", { class: "before", d: path(before, x, y) }));
  svg.append(made("path", { class: "now", d: path(now, x, y) }));
  return svg;
}

/** Calls back when the kernel answers. In a page that was exported there is none: the still picture remains. */
function whenAwake(model, awake) {
  model.on("msg:custom", (message) => { if (message.alive) awake(); });
  try { model.send({ ask: "alive" }); } catch { /* no kernel */ }
}

function render({ model, el }) {
  const sliders = [];
  const root = document.createElement("div"), plots = document.createElement("div"), problem = document.createElement("div");
  root.className = "jounce-live"; plots.className = "plots"; problem.className = "problem"; problem.setAttribute("role", "status");
  for (const one of model.get("sliders")) {
    const line = document.createElement("label"), name = document.createElement("span");
    const slider = document.createElement("input"), value = document.createElement("output"), back = document.createElement("button");
    name.textContent = one.path;
    back.textContent = "reset"; back.type = "button";
    Object.assign(slider, { type: "range", min: one.low, max: one.high, step: "any", disabled: true });
    back.disabled = true;
    sliders.push(slider, back);
    const show = () => {
      const now = model.get("values")[one.path];
      slider.value = now;
      value.textContent = `${written(now * one.factor)} ${one.unit}`;
    };
    const set = (number) => { model.set("values", { ...model.get("values"), [one.path]: number }); model.save_changes(); };
    slider.addEventListener("input", () => set(Number(slider.value)));
    back.addEventListener("click", () => set(one.value));
    model.on("change:values", show);
    show();
    line.append(name, slider, value, back);
    root.append(line);
  }
  const draw = () => {
    const before = model.get("before");
    plots.replaceChildren(...model.get("curves").map((curve, k) => plot(before[k], curve)));
    problem.textContent = model.get("problem");
  };
  model.on("change:curves", draw);
  model.on("change:problem", draw);
  draw();
  const note = document.createElement("small");
  note.textContent = "The sliders wait for the kernel: they move where the notebook runs.";
  whenAwake(model, () => {
    note.textContent = "grey: as it was";
    for (const one of sliders) one.disabled = false;
    const style = document.createElement("style"); // the picture for pages without a kernel
    style.textContent = `.jounce-still[data-live="${model.get("still")}"] { display: none; }`;
    document.head.append(style);
  });
  root.append(problem, plots, note);
  el.append(root);
}

export default { render };
