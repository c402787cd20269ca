"use strict";

// Sliders: how much of the first picture lies over the second.
for (const split of document.querySelectorAll(".split")) {
  const show = () => split.parentElement.style.setProperty("--split", `${split.value}%`);
  split.addEventListener("input", show);
  show();
}

// Plots: the value nearest to the pointer stands above it, unless it is far away.
const readout = document.querySelector(".readout");
const middleOf = (point) => {
  const box = point.getBoundingClientRect();
  return [box.x + box.width / 2, box.y + box.height / 2];
};
for (const plot of document.querySelectorAll(".plot svg")) {
  const points = [...plot.querySelectorAll(".value")];
  const show = (pointer) => {
    let nearest = 32; // pixels
    readout.hidden = true;
    for (const point of points) {
      const [x, y] = middleOf(point), distance = Math.hypot(x - pointer.clientX, y - pointer.clientY);
      if (distance >= nearest)
        continue;
      nearest = distance;
      readout.hidden = false;
      readout.textContent = point.dataset.value;
      readout.style.translate = `clamp(0px, ${x}px - 50%, 100vw - 100%) calc(${y}px - 100% - 0.5rem)`;
    }
  };
  plot.addEventListener("pointermove", show);
  plot.addEventListener("pointerdown", show);
  plot.addEventListener("pointerleave", () => readout.hidden = true);
}

// A picture fills the window when it is clicked, and goes when it or anything else is.
const dialog = document.querySelector(".enlarged");
for (const button of document.querySelectorAll(".zoom"))
  button.addEventListener("click", () => {
    const picture = button.querySelector("img");
    Object.assign(dialog.firstElementChild, { src: picture.src, alt: picture.alt });
    dialog.showModal();
  });
dialog.addEventListener("click", () => dialog.close());
