// SPDX-License-Identifier: Apache-2.0
// Hands the numbers of the page to Plotly: surfaces with a choice of field and of displacement scale, and curves.
(function () {
  "use strict";
  const read = (name) => { const e = document.getElementById(name); return e ? JSON.parse(e.textContent) : null; };
  const dark = window.matchMedia && window.matchMedia("(prefers-color-scheme: dark)").matches;
  const ink = dark ? "#e4e8ec" : "#1d2733", rule = dark ? "#3a444e" : "#d5dbe1", grey = dark ? "#7c8793" : "#b9bec6";
  const clear = "rgba(0,0,0,0)";
  const narrow = window.innerWidth < 600;

  function unpack(text, Kind) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    return new Kind(bytes.buffer);
  }

  function number(x) { return Number(x.toPrecision(4)).toString().replace("-", "\u2212"); }

  // Plotly takes texts for a kind of HTML.
  function plain(words) { return String(words).replace(/&/g, "&amp;").replace(/</g, "&lt;"); }

  // Surfaces -----------------------------------------------------------------------------------------------------------

  function prepare(surface) {
    const n = surface.corners, faces = unpack(surface.faces, Uint32Array);
    const i = [], j = [], k = [];
    if (n === 4)
      for (let f = 0; f < faces.length; f += 4)
        for (const [a, b, c] of [[0, 1, 2], [0, 2, 3]]) { i.push(faces[f + a]); j.push(faces[f + b]); k.push(faces[f + c]); }
    const fields = {};
    for (const name in surface.fields) fields[name] = unpack(surface.fields[name], Float32Array);
    return { kind: surface.kind, name: surface.name, i, j, k, fields, points: unpack(surface.points, Float32Array),
             displacement: unpack(surface.displacement, Float32Array),
             lines: surface.lines ? unpack(surface.lines, Uint32Array) : n === 2 ? faces : new Uint32Array(0) };
  }

  // Lengths of mesh lines, undeformed.
  function lengths(surface) {
    const result = new Float32Array(surface.lines.length / 2);
    for (let s = 0; s < result.length; ++s) {
      const p = 3 * surface.lines[2 * s], q = 3 * surface.lines[2 * s + 1], x = surface.points;
      result[s] = Math.hypot(x[p] - x[q], x[p + 1] - x[q + 1], x[p + 2] - x[q + 2]);
    }
    return result;
  }

  function moved(surface, scale) {
    const n = surface.points.length / 3, x = [new Array(n), new Array(n), new Array(n)];
    for (let p = 0; p < n; ++p)
      for (let d = 0; d < 3; ++d) x[d][p] = surface.points[3 * p + d] + scale * surface.displacement[3 * p + d];
    return x;
  }

  function area(surface, x, field, view) {
    const trace = { type: "mesh3d", name: plain(surface.name), x: x[0], y: x[1], z: x[2], i: surface.i, j: surface.j, k: surface.k,
                    flatshading: true, showlegend: true, legendgroup: surface.kind + surface.name,
                    lighting: Object.assign({ facenormalsepsilon: 0, vertexnormalsepsilon: 0 },  // cells may be tiny
                      view.flat ? { ambient: 1, diffuse: 0, specular: 0 }
                                : { ambient: 0.72, diffuse: 0.45, specular: 0.04, roughness: 0.9, fresnel: 0.05 }),
                    lightposition: { x: 4000, y: -6000, z: 9000 } };
    const values = surface.fields[field];
    if (!values)
      return Object.assign(trace, { color: grey, opacity: surface.kind === "body" && view.fields[field].of === "contact" ? (view.flat ? 0.6 : 0.15) : 1, hoverinfo: "name" });
    return Object.assign(trace, { intensity: Array.from(values), coloraxis: "coloraxis", hovertemplate:
      "%{intensity:.4g}<br>(%{x:.4g}, %{y:.4g}, %{z:.4g})<extra>" + plain(surface.name) + "</extra>" });
  }

  // At each point the normal of the surface, of that length.
  function outwards(surface, x, length) {
    const n = new Float32Array(surface.points.length), { i, j, k } = surface;
    for (let f = 0; f < i.length; ++f) {
      const [a, b] = [j, k].map((to) => [0, 1, 2].map((d) => x[d][to[f]] - x[d][i[f]]));
      const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
      const size = Math.hypot(...normal) || 1;
      for (const p of [i[f], j[f], k[f]]) for (let d = 0; d < 3; ++d) n[3 * p + d] += normal[d] / size;
    }
    for (let p = 0; p < n.length; p += 3) {
      const size = Math.hypot(n[p], n[p + 1], n[p + 2]) || 1;
      for (let d = 0; d < 3; ++d) n[p + d] *= length / size;
    }
    return n;
  }

  function mesh_lines(surface, x, choice, view) {
    const l = [[], [], []], alone = surface.i.length === 0, values = alone && surface.fields[choice.field], colours = [];
    const above = outwards(surface, x, view.flat ? 1e-2 * view.size : 3e-3 * view.size);  // else the areas would hide them
    for (let s = 0; s < surface.lines.length; s += 2) {
      if (!alone && surface.lengths[s / 2] < choice.shortest) continue;
      for (const p of [surface.lines[s], surface.lines[s + 1], -1]) {
        for (let d = 0; d < 3; ++d) l[d].push(p < 0 ? null : x[d][p] + above[3 * p + d]);
        colours.push(values ? values[p < 0 ? surface.lines[s] : p] : 0);
      }
    }
    return { type: "scatter3d", mode: "lines", name: plain(surface.name), x: l[0], y: l[1], z: l[2], showlegend: alone && !values,
             legendgroup: surface.kind + surface.name, hoverinfo: "skip",
             line: values ? { color: colours, coloraxis: "coloraxis", width: 9 }
                          : { color: surface.kind === "obstacle" ? grey : "rgba(20,20,30,0.45)", width: surface.kind === "obstacle" ? 6 : 1 } };
  }

  function traces(view, surfaces, choice) {
    const result = [], of_contact = view.fields[choice.field].of === "contact";
    choice.window = [[Infinity, -Infinity], [Infinity, -Infinity], [Infinity, -Infinity]];
    for (const surface of surfaces) {
      const x = moved(surface, choice.scale);
      for (let d = 0; d < 3; ++d)
        for (const at of x[d]) {
          if (at < choice.window[d][0]) choice.window[d][0] = at;
          if (at > choice.window[d][1]) choice.window[d][1] = at;
        }
      if (surface.kind === "contact" && !of_contact) continue;
      if (surface.kind === "obstacle" && of_contact && !view.flat) continue;  // it would cover the contact surface
      if (surface.i.length) result.push(area(surface, x, choice.field, view));
      if (surface.lines.length && !(of_contact && surface.kind === "body" && !view.flat))
        result.push(mesh_lines(surface, x, choice, view));
    }
    return result;
  }

  function layout(view, choice, box) {
    const field = view.fields[choice.field];
    const sides = choice.window.map(([low, high]) => high - low), longest = Math.max(...sides);
    const range = choice.window.map(([low, high]) => [low - 0.02 * longest, high + 0.02 * longest]);
    const axis = (title, d) => ({ title: { text: title }, color: ink, gridcolor: rule, zerolinecolor: rule, showbackground: false,
                                  showspikes: false, exponentformat: "e", nticks: narrow ? 4 : 7, range: range[d] });
    const ratio = sides.map((side) => (side + 0.04 * longest) / (1.04 * longest));
    if (view.flat) {  // without perspective only this makes the picture fill its box
      const fill = Math.min(1.7 / ratio[1], (narrow ? 1.15 : 1.45) * box.clientWidth / box.clientHeight / ratio[0]);
      for (let d = 0; d < 3; ++d) ratio[d] *= fill;
    }
    const distance = view.flat ? 1.5 : narrow ? 1.9 : 1.55, [ex, ey, ez] = view.towards, [ux, uy, uz] = view.up;
    const eye = { x: distance * ex, y: distance * ey, z: distance * ez };
    const scene = { aspectmode: "manual", aspectratio: { x: ratio[0], y: ratio[1], z: ratio[2] },
                    xaxis: axis("x", 0), yaxis: axis("y", 1), zaxis: axis(view.flat ? "" : "z", 2), uirevision: "kept",
                    dragmode: view.flat ? "pan" : "turntable",
                    camera: { eye, up: { x: ux, y: uy, z: uz }, projection: { type: view.flat ? "orthographic" : "perspective" } } };
    if (view.flat) scene.zaxis.visible = false;
    return { margin: { l: 0, r: 0, t: 0, b: 0 }, paper_bgcolor: clear, font: { color: ink, size: 12 }, scene, uirevision: "kept",
             modebar: { bgcolor: clear, color: grey, activecolor: ink },
             legend: { x: 0, y: 1, bgcolor: dark ? "rgba(20,25,31,0.7)" : "rgba(255,255,255,0.7)", itemsizing: "constant" },
             coloraxis: { cmin: field.from, cmax: field.to, colorscale: view.colours,
                          colorbar: { title: { text: narrow ? "" : field.label, side: "right" }, thickness: narrow ? 10 : 16, len: 0.85, tickcolor: ink, exponentformat: "e" } } };
  }

  function show(view) {
    const box = document.getElementById("view"), note = document.getElementById("view-note");
    const select = document.getElementById("view-field"), scale = document.getElementById("view-scale");
    const lines = document.getElementById("view-lines");
    const surfaces = view.surfaces.map(prepare), short = view.size / 120;
    for (const surface of surfaces) surface.lengths = lengths(surface);
    const dense = surfaces.some((surface) => surface.kind === "body" && surface.lengths.some((length) => length < short));
    if (dense) lines.add(new Option("of large cells", short));
    lines.add(new Option("all", 0));
    lines.add(new Option("none", Infinity));
    for (const name in view.fields) select.add(new Option(view.fields[name].label, name));
    scale.value = view.scale;
    function draw() {
      const factor = Number(scale.value);
      const choice = { field: select.value, scale: Number.isFinite(factor) ? factor : 1, shortest: Number(lines.value) };
      const field = view.fields[choice.field];
      let words = "Displacements are drawn " + (choice.scale === 1 ? "at true scale" : choice.scale === 0 ? "as zero: undeformed bodies" : "\u00d7 " + number(choice.scale))
                + ". " + field.label + ": " + number(field.least) + " to " + number(field.most);
      if (field.most > field.to || field.least < field.from)
        words += ", colours " + number(field.from) + " to " + number(field.to) + "; values beyond have the colour of the end";
      if (dense && choice.shortest === short) words += ". Mesh lines shorter than " + number(short) + " are left out";
      note.textContent = words + ".";
      const drawn = traces(view, surfaces, choice);
      return Plotly.react(box, drawn, layout(view, choice, box), { responsive: true, displaylogo: false, displayModeBar: !narrow,
        modeBarButtonsToRemove: ["tableRotation", "resetCameraLastSave3d", "hoverClosest3d"] });
    }
    for (const control of [select, scale, lines]) control.addEventListener("change", draw);
    document.getElementById("view-true").addEventListener("click", () => { scale.value = 1; draw(); });
    document.getElementById("view-visible").addEventListener("click", () => { scale.value = view.scale; draw(); });
    // Of a check in a browser each field in turn, and the mouse.
    if (window.location.hash !== "#check") return draw();
    const each = Object.keys(view.fields).reverse().reduce((before, name) => before.then(() => { select.value = name; return draw(); }), draw());
    return each.then(() => drag(box));
  }

  // Draws with the mouse, as a reader would, and sees whether the camera has followed.
  async function drag(box) {
    const camera = () => JSON.stringify(box._fullLayout.scene._scene.getCamera());
    const canvas = box.querySelector("canvas"), before = camera(), frame = canvas.getBoundingClientRect();
    const at = (kind, x, y, buttons) => canvas.dispatchEvent(new MouseEvent(kind, {
      bubbles: true, cancelable: true, view: window, button: 0, buttons, clientX: frame.left + x, clientY: frame.top + y }));
    const wait = () => new Promise((resolve) => setTimeout(resolve, 100));
    at("mousemove", 150, 150, 0);
    at("mousedown", 150, 150, 1);
    for (let i = 1; i <= 5; ++i) { await wait(); at("mousemove", 150 + 12 * i, 150 + 6 * i, 1); }
    await wait();
    at("mouseup", 210, 180, 0);
    await wait();
    if (camera() === before) throw new Error("the mouse does not turn or move the bodies");
  }

  // Curves -------------------------------------------------------------------------------------------------------------

  function plot(curve, number_of_it) {
    const box = document.getElementById("curve-" + number_of_it);
    const axis = (title) => ({ title: { text: plain(title), standoff: 8, font: { size: 12 } }, color: ink, gridcolor: rule, zerolinecolor: rule,
                               automargin: true, exponentformat: "e", separatethousands: true });
    const x = axis(curve.x), y = axis(curve.y);
    if (curve.log) x.type = "log";
    if (curve.zero) x.rangemode = y.rangemode = "tozero";
    for (const line of curve.lines) if (line.name) line.name = plain(line.name);
    return Plotly.newPlot(box, curve.lines, { margin: { l: 60, r: 15, t: 40, b: 50 }, paper_bgcolor: clear, plot_bgcolor: clear, font: { color: ink, size: 12 },
      title: { text: plain(curve.title), font: { size: 14 }, x: 0.02, xanchor: "left" }, xaxis: x, yaxis: y,
      showlegend: curve.lines.length > 1, legend: { x: 0, y: 1, bgcolor: clear } }, { responsive: true, displaylogo: false, displayModeBar: false });
  }

  // What a check in a browser looks for: "ready", or the error.
  const view = read("view-data"), curves = read("curve-data") || [];
  const errors = [];
  const parts = curves.map((curve, i) => () => plot(curve, i));
  if (view) parts.unshift(() => show(view));
  Promise.all(parts.map((part, i) => Promise.resolve().then(part).catch((error) => {
    errors.push(error);
    if (view && i === 0)
      document.getElementById("view-note").textContent = "This browser cannot draw the bodies in 3D (" + error + "); the pictures below show them.";
  }))).then(() => {
    const page = document.documentElement, count = (what) => document.querySelectorAll(what).length;
    if (page.scrollWidth > page.clientWidth) errors.push("the page is wider than the screen");
    if (view && !count("#view canvas")) errors.push("the 3D view has no canvas");
    if (count(".curve svg.main-svg") < curves.length) errors.push("a curve is not drawn");
    document.body.dataset.drawn = errors.length ? "error: " + errors.join("; ") : "ready";
    if (window.parent !== window) window.parent.postMessage(document.body.dataset.drawn, "*");  // to scripts/report --check-browser
  });
})();
