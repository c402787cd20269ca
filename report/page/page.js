"use strict";

// Sliders: how much of the first picture lies over the second.
for (const split of document.querySelectorAll(".split")) {
  const show = () => split.parentElement.style.setProperty("--split", `${split.value}%`);
  split.addEventListener("input", show);
  show();
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
