// SPDX-License-Identifier: MIT
// Files that are opened or dropped.

/** The text of a file; WKB in bytes as hexadecimal digits. */
async function textOf(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes[0] <= 1) return [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  return new TextDecoder().decode(bytes);
}

/** Calls take({p, q}) with the texts of files: what is dropped on a field is for that, else the first for P, the second for Q. */
export function listen(take) {
  for (const name of ["p", "q"]) {
    const input = document.getElementById(name + "-file");
    input.addEventListener("change", async () => {
      if (!input.files.length) return;
      take({[name]: await textOf(input.files[0])});
      input.value = "";  // the same file again is a change, too
    });
  }
  addEventListener("dragover", (event) => {
    if (event.dataTransfer.types.includes("Files")) event.preventDefault();
  });
  addEventListener("drop", async (event) => {
    const [one, other] = event.dataTransfer.files;
    if (!one) return;
    event.preventDefault();
    const isForQ = event.target.closest?.("[data-file]")?.dataset.file === "q";
    take(isForQ ? {q: await textOf(one)} : {p: await textOf(one), ...(other && {q: await textOf(other)})});
  });
}
