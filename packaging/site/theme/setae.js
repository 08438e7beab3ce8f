// SPDX-License-Identifier: GPL-3.0-or-later
// What scrolls can be scrolled by keyboard, and the buttons beside a block of code are no landmark.
function reach() {
  for (const box of document.querySelectorAll("pre > code, .md-typeset__scrollwrap, .formula")) {
    if (box.scrollWidth > box.clientWidth) box.setAttribute("tabindex", "0");
    else box.removeAttribute("tabindex");
  }
  for (const buttons of document.querySelectorAll(".md-code__nav")) buttons.setAttribute("role", "none");
}
addEventListener("load", reach);
addEventListener("resize", reach);
new MutationObserver(reach).observe(document.body, { childList: true, subtree: true });
