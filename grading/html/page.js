"use strict";
// Fills the page from the grade in #data. Whatever a submission may have said goes in as text, never as markup.

const grade = JSON.parse(document.getElementById("data").textContent);

// A word alone would do; the sign is for those who look for a shape, since colours look alike to some.
const signs = { "passed": "✓", "wrong": "✗", "not attempted": "○", "crashed": "!", "timed out": "…", "refused": "–",
  "hidden": "?" };

function make(tag, className, ...children) {
  const element = document.createElement(tag);
  element.className = className;
  element.append(...children);
  return element;
}

const points = (of) => `${+of.score.toFixed(2)} / ${+of.maxScore.toFixed(2)}`;
const slug = (status) => status.replace(" ", "-");
const lostPoints = (check) => !["hidden", "passed"].includes(check.status); // if it had any to give

// ---- Pictures: floats, three a pixel, the bottom row first --------------------------------------------------------

function decode(base64) {
  return new Float32Array(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);
}

// Draws a picture whose colours are paint(first float's index) -> [red, green, blue] in 0..255.
function draw(canvas, { width, height }, paint) {
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      image.data.set([...paint(3 * (y * width + x)), 255], 4 * ((height - 1 - y) * width + x));
  context.putImageData(image, 0, 0);
}

// As the renderer writes pictures: linear, clamped, rounded (the array of an image does both). No number is magenta.
const paintPixels = (floats) => (i) => {
  const color = [floats[i], floats[i + 1], floats[i + 2]];
  return color.every(Number.isFinite) ? color.map((c) => 255 * c) : [255, 0, 255];
};

// Five places of Inferno by Smith and van der Walt, which is as steep for the colour-blind: 0 is black, 1 pale yellow.
const ramp = [[0, 0, 4], [87, 16, 110], [188, 55, 84], [249, 142, 9], [252, 255, 164]];

function rampColor(value) {
  const place = 4 * Math.min(value, 1);
  const below = Math.min(Math.floor(place), 3);
  return ramp[below].map((c, i) => c + (place - below) * (ramp[below + 1][i] - c));
}

function differenceAt({ expected, came }, i) {
  const most = Math.max(...[0, 1, 2].map((c) => Math.abs(came[i + c] - expected[i + c])));
  return Number.isFinite(most) ? most : Infinity;
}

function makeViewer(encoded) {
  const { width, height, worst } = encoded;
  const pictures = { expected: decode(encoded.expected), came: decode(encoded.came) };
  const viewer = document.getElementById("viewer").content.cloneNode(true).firstElementChild;
  const find = (selector) => viewer.querySelector(selector);
  const map = find(".difference canvas");
  const cropSize = { width: Math.min(16, width), height: Math.min(16, height) };
  const corner = { // of the crop, its top left; rows of a canvas count from the top
    x: Math.min(Math.max(worst[0] - cropSize.width / 2, 0), width - cropSize.width),
    y: Math.min(Math.max(height - 1 - worst[1] - cropSize.height / 2, 0), height - cropSize.height) };
  let pixel = worst;

  function drawCrops() {
    const sources = [find(".expected"), find(".came"), map];
    viewer.querySelectorAll(".crops canvas").forEach((canvas, i) => {
      Object.assign(canvas, cropSize);
      canvas.getContext("2d").drawImage(sources[i], Math.floor(corner.x), Math.floor(corner.y), cropSize.width,
        cropSize.height, 0, 0, cropSize.width, cropSize.height);
    });
  }

  function drawDifference() {
    const gain = 2 ** find(".gain").value;
    draw(map, encoded, (i) => rampColor(gain * differenceAt(pictures, i)));
    find("output").textContent = `amplified ${gain} ×`;
    find(".most").textContent = `${+(1 / gain).toPrecision(2)} or more`;
    drawCrops();
  }

  function showPixel(x, y) {
    pixel = [Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 0), height - 1)];
    const first = 3 * (pixel[1] * width + pixel[0]);
    find("caption").textContent = `Pixel (${pixel[0]}, ${pixel[1]}) from the bottom left`;
    viewer.querySelectorAll("tbody tr").forEach((row, line) => {
      for (const c of [0, 1, 2]) {
        const [expected, came] = [pictures.expected[first + c], pictures.came[first + c]];
        row.cells[c + 1].textContent = [+expected.toPrecision(6), +came.toPrecision(6),
          +(came - expected).toPrecision(4)][line];
      }
    });
    viewer.style.setProperty("--x", pixel[0] / width);
    viewer.style.setProperty("--y", (height - 1 - pixel[1]) / height);
  }

  function follow(event) {
    const box = event.currentTarget.getBoundingClientRect();
    showPixel(Math.floor((event.clientX - box.left) / box.width * width),
      height - 1 - Math.floor((event.clientY - box.top) / box.height * height));
  }

  function step(event) {
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
    if (!(event.key in steps))
      return;
    event.preventDefault(); // the page would scroll
    showPixel(pixel[0] + steps[event.key][0], pixel[1] + steps[event.key][1]);
  }

  // As much as makes the greatest difference white; of pictures that are the same, the most there is.
  function suitableGain() {
    let most = 0;
    for (let i = 0; i < 3 * width * height; i += 3)
      most = Math.max(most, differenceAt(pictures, i));
    return Math.min(Math.max(Math.floor(Math.log2(1 / most)), 0), 10);
  }

  for (const [name, value] of Object.entries({ "--size": width, "--ratio": width / height, "--split": "50%",
    "--place-x": corner.x / width, "--place-y": corner.y / height,
    "--place-w": cropSize.width / width, "--place-h": cropSize.height / height }))
    viewer.style.setProperty(name, value);
  draw(find(".expected"), encoded, paintPixels(pictures.expected));
  draw(find(".came"), encoded, paintPixels(pictures.came));
  find(".gain").value = suitableGain();
  find(".gain").addEventListener("input", drawDifference);
  find(".split").addEventListener("input", (event) =>
    viewer.style.setProperty("--split", `${event.target.value}%`));
  for (const stage of viewer.querySelectorAll(".stage"))
    for (const kind of ["pointermove", "pointerdown"])
      stage.addEventListener(kind, follow);
  find(".difference").addEventListener("keydown", step);
  drawDifference();
  showPixel(...worst);
  return viewer;
}

// ---- Checks and features ------------------------------------------------------------------------------------------

function makeBody(check) {
  const body = make("div", "body");
  if (check.message)
    body.append(make("p", "message", check.message));
  if (check.cause)
    body.append(make("p", "cause", make("b", "", "Usual cause"), ` ${check.cause}`));
  if (check.pictures)
    body.append(makeViewer(check.pictures));
  return body;
}

// above: the check before it. What was said of that one already, such as a compiler's message, stays closed.
function makeCheck(check, above) {
  const dot = check.name.indexOf(".") + 1; // the feature's name is above already: pale
  const line = [
    make("span", "sign", signs[check.status]),
    make("span", "name", make("span", "feature-name", check.name.slice(0, dot)), check.name.slice(dot)),
    make("span", "status", check.status),
    make("span", "points", check.status === "hidden" ? "" : points(check))];
  const body = makeBody(check);
  const opens = body.childElementCount > 0;
  const row = make(opens ? "details" : "div", `check ${slug(check.status)}`,
    make(opens ? "summary" : "div", "line", ...line), ...(opens ? [body] : []));
  row.open = lostPoints(check) && check.message !== above?.message;
  row.dataset.lost = lostPoints(check);
  return row;
}

function makeBar(of) {
  const bar = make("i", "bar");
  bar.style.setProperty("--share", of.maxScore > 0 ? of.score / of.maxScore : 0);
  return bar;
}

// What was drawn costs nothing: it is below the checks, closed, open where the solution draws something else.
function makeDrawn(feature) {
  const list = (title, lines) => make("div", "", make("h3", "", title),
    make("ul", "", ...lines.map((line) => make("li", "", line))));
  const drawn = make("details", "drawn", make("summary", "", "Drawn while a ray is followed (no points)"),
    make("div", "lists", list("Yours", feature.drawn), list("The solution's", feature.solutionDraws)));
  drawn.open = feature.drawn.join() !== feature.solutionDraws.join();
  return drawn;
}

function makeFeature(feature) {
  const heading = make("h2", "", feature.name, " ", make("span", "points", points(feature)));
  const section = make("section", "", heading,
    ...feature.checks.map((check, i, all) => makeCheck(check, all[i - 1])));
  if (feature.drawn)
    section.append(makeDrawn(feature));
  section.id = feature.name;
  section.dataset.lost = feature.checks.some(lostPoints);
  return section;
}

function makeLink(feature) {
  const link = make("a", "", make("span", "", feature.name), make("span", "points", points(feature)), makeBar(feature));
  link.href = `#${feature.name}`;
  return link;
}

function fillPage() {
  const checks = grade.features.flatMap((feature) => feature.checks);
  const lost = checks.filter(lostPoints).length;
  document.title = `${grade.submission}: ${points(grade)}`;
  document.querySelector("h1").textContent = grade.submission;
  document.querySelector(".total b").textContent = +grade.score.toFixed(2);
  document.querySelector(".total span").textContent = `of ${+grade.maxScore.toFixed(2)} points`;
  if (grade.notSandboxed)
    document.querySelector(".total").append(` (graded without a sandbox: ${grade.notSandboxed})`);
  document.querySelector("nav").append(...grade.features.map(makeLink));
  document.querySelector("main").append(...grade.features.map(makeFeature));
  const [all, some] = document.querySelectorAll(".filter b");
  all.textContent = checks.length;
  some.textContent = lost;
  document.querySelector(".filter").addEventListener("change", (event) => {
    document.body.classList.toggle("lost-only", event.target.value === "lost");
    document.querySelector(".nothing").hidden = event.target.value !== "lost" || lost > 0;
  });
}

fillPage();
