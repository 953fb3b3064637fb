// SPDX-License-Identifier: MIT
// The result as a text or a picture, to copy and to download, and a link to the page as it is.
const styles = ["fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap"];

/** The drawing as an SVG file of its own: without handles, with the styles of the page. */
function picture(svg) {
  const copy = svg.cloneNode(true), [originals, copies] = [svg, copy].map((one) => one.querySelectorAll("*"));
  originals.forEach((original, i) => {
    const style = getComputedStyle(original);
    if (original.localName !== "g") for (const name of styles) copies[i].setAttribute(name, style.getPropertyValue(name));
  });
  copy.lastElementChild.remove();  // the handles
  for (const one of copy.querySelectorAll("*")) ["class", "data-layer", "data-of"].forEach((name) => one.removeAttribute(name));
  const {clientWidth: width, clientHeight: height} = svg;
  const ground = document.createElementNS(svg.namespaceURI, "rect");
  for (const [name, value] of Object.entries({width, height, fill: getComputedStyle(document.body).backgroundColor})) ground.setAttribute(name, value);
  copy.prepend(ground);
  for (const {name} of [...copy.attributes]) copy.removeAttribute(name);
  for (const [name, value] of Object.entries({width, height, viewBox: `0 0 ${width} ${height}`})) copy.setAttribute(name, value);
  return new XMLSerializer().serializeToString(copy);
}

/** The same as PNG, with two dots for each of the screen's. */
async function png(svg) {
  const image = new Image();
  image.src = "data:image/svg+xml," + encodeURIComponent(picture(svg));
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), {width: 2 * image.width, height: 2 * image.height});
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}

const kinds = {wkt: "text/plain", geojson: "application/geo+json", svg: "image/svg+xml"};

/** A result in a format: a text for all but PNG. */
const content = (format, sum, svg) => format === "png" ? png(svg) : format === "svg" ? picture(svg) : sum[format];

async function copy(format, sum, svg) {
  if (format === "png") await navigator.clipboard.write([new ClipboardItem({"image/png": png(svg)})]);
  else await navigator.clipboard.writeText(content(format, sum, svg));
}

async function download(format, sum, svg) {
  const made = await content(format, sum, svg);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(format === "png" ? made : new Blob([made], {type: kinds[format]}));
  link.download = "sum." + format;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Does what a browser may refuse, and says what came of it. */
async function telling(place, done, act) {
  try {
    await act();
    place.textContent = done;
  } catch (error) {
    place.textContent = `The browser refuses: ${error.message}`;
  }
}

/** now() returns {result, svg}, or nothing as long as there is none. */
export function listen(now) {
  const $ = (id) => document.getElementById(id);
  $("share").addEventListener("click", () => telling($("shared"), "The link is copied: it holds P, Q and all else.",
    () => navigator.clipboard.writeText(location.href)));
  for (const [name, act, done] of [["copy", copy, "Copied."], ["download", download, "Saved."]])
    $(name).addEventListener("click", () => {
      const there = now();
      if (there) telling($("saved"), done, () => act($("format").value, there.result, there.svg));
    });
}
