#pragma once
/// What pages consist of beside the drawing and its list.

namespace burin::html {

inline constexpr const char* kHead =
    R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
)";

inline constexpr const char* kStyle =
    R"(:root { --mark: #c2410c; --fill: rgba(234, 88, 12, .22) }
* { box-sizing: border-box }
body { margin: 0; font: 15px/1.4 system-ui, sans-serif; color: #111; background: #f4f4f2 }
body { display: flex; height: 100vh }
main { flex: 1; min-width: 0; padding: 12px; display: flex }
main svg { width: 100%; height: 100%; background: #fff; box-shadow: 0 1px 4px rgba(0, 0, 0, .25) }
aside { width: 26em; max-width: 45vw; display: flex; flex-direction: column; background: #fff }
aside { border-left: 1px solid #ccc }
input { margin: 12px; padding: 6px 8px; font: inherit; border: 1px solid #999; border-radius: 3px }
div { overflow: auto; flex: 1 }
table { border-collapse: collapse; width: 100% }
th { position: sticky; top: 0; background: #fff; text-align: left; font-weight: 600 }
th, td { padding: 4px 12px; border-bottom: 1px solid #e2e2e2; vertical-align: top }
td { overflow-wrap: anywhere }
td:nth-child(1), td:nth-child(2), th:nth-child(1), th:nth-child(2) { text-align: right; width: 3.5em }
td:nth-child(4), th:nth-child(4) { color: #666; font-size: 12px }
td i { display: inline-block; width: .8em; height: .8em; margin-right: .4em; border: 1px solid #666 }
tr[data-item] { cursor: pointer }
tr.marked, tr:focus { background: #fdeee4; outline: none }
tr.chosen td:first-child { box-shadow: inset 4px 0 var(--mark) }
tr[hidden] { display: none }
p { margin: 8px 12px; color: #555; font-size: 12px }
svg [data-item] { cursor: pointer }
svg .area.marked { fill: var(--fill) }
svg g.part { pointer-events: none }
.plain g.part { pointer-events: visiblePainted }
.plain g.part.marked:not([fill]) { stroke: var(--mark) }
.plain g.part.marked[fill] { fill: var(--mark) }
main.book { display: block; overflow: auto; scroll-behavior: smooth }
main.book h1 { font-size: 22px; margin: 4px 8px 12px }
main.book svg { height: auto; margin-bottom: 12px }
svg .callout path, svg .callout text, svg .row text { pointer-events: all }
svg .callout.marked path { stroke: var(--mark) }
svg .callout.marked text, svg .row.marked text { fill: var(--mark) }
@media (max-width: 800px) { body { flex-direction: column } aside { width: auto; max-width: none; height: 45vh } }
@media print {
  body { display: block; height: auto; background: none }
  main { padding: 0 } main svg { box-shadow: none; height: auto }
  main.book { overflow: visible } main.book section { break-after: page }
  aside { width: auto; max-width: none; border: 0; display: block } div { overflow: visible }
  input, p { display: none } th { position: static }
  tr.marked, tr:focus { background: none } tr.chosen td:first-child { box-shadow: none }
  tr[hidden] { display: table-row } tr { break-inside: avoid }
  svg .area.marked { fill: none } svg .callout.marked path { stroke: inherit }
}
)";

inline constexpr const char* kListHead =
    R"(</main>
<aside>
<input type="search" placeholder="Search parts" aria-label="Search parts">
<div><table>
<thead><tr><th>No.</th><th>Qty</th><th>Name</th><th>Source</th></tr></thead>
<tbody>
)";

inline constexpr const char* kListTail =
    R"(</tbody>
</table></div>
<p>Point at a part or a row; a click keeps it. Arrow keys go through the rows, Enter keeps one, / searches, Esc lets go.</p>
</aside>
<script>
)";

inline constexpr const char* kScript =
    R"("use strict";
(() => {
  const svg = document.querySelector("main"), search = document.querySelector("input");
  const rows = [...document.querySelectorAll("tbody tr")];
  const of = new Map();
  for (const e of document.querySelectorAll("[data-item]")) {
    if (!of.has(e.dataset.item)) of.set(e.dataset.item, []);
    of.get(e.dataset.item).push(e);
  }
  if (!svg.querySelector(".area")) svg.classList.add("plain");
  let chosen = null, shown = null;
  const row = item => rows.find(r => r.dataset.item === item);
  const mark = item => {
    if (item === shown) return;
    for (const e of of.get(shown) || []) e.classList.remove("marked");
    for (const e of of.get(item) || []) e.classList.add("marked");
    shown = item;
  };
  const choose = (item, goes) => {
    if (chosen !== null && row(chosen)) row(chosen).classList.remove("chosen");
    chosen = item;
    if (item !== null && row(item)) row(item).classList.add("chosen");
    mark(item);
    if (!goes || item === null || !svg.classList.contains("book")) return;
    const first = (of.get(item) || []).find(e => svg.contains(e));
    if (first) first.closest("section").scrollIntoView({block: "start"});
  };
  const item = event => {
    const e = event.target.closest && event.target.closest("[data-item]");
    return e ? e.dataset.item : null;
  };
  document.addEventListener("pointerover", e => {
    const over = item(e);
    mark(over === null ? chosen : over);
    if (over !== null && svg.contains(e.target) && row(over)) row(over).scrollIntoView({block: "nearest"});
  });
  document.addEventListener("pointerleave", () => mark(chosen));
  document.addEventListener("click", e => {
    if (e.target === search) return;
    const at = item(e);
    if (at === null && !svg.contains(e.target)) return;
    choose(at === chosen ? null : at, !svg.contains(e.target));
    if (chosen !== null && row(chosen)) row(chosen).scrollIntoView({block: "nearest"});
  });
  search.addEventListener("input", () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(w => w);
    for (const r of rows) {
      const text = r.textContent.toLowerCase();
      r.hidden = !words.every(w => text.includes(w));
    }
  });
  document.addEventListener("keydown", e => {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    const seen = rows.filter(r => !r.hidden), at = seen.indexOf(document.activeElement);
    if (e.key === "ArrowDown" || e.key === "ArrowUp") {
      const to = at < 0 ? (e.key === "ArrowDown" ? 0 : seen.length - 1) : at + (e.key === "ArrowDown" ? 1 : -1);
      if (seen[to]) { seen[to].focus(); mark(seen[to].dataset.item); }
    } else if (e.key === "Enter" && (at >= 0 || document.activeElement === search)) {
      const r = at >= 0 ? seen[at] : seen[0];
      if (r) choose(r.dataset.item === chosen ? null : r.dataset.item, true);
    } else if (e.key === "Escape") {
      search.value = "";
      search.dispatchEvent(new Event("input"));
      document.activeElement.blur();
      choose(null);
    } else if (e.key === "/" && document.activeElement !== search) {
      search.focus();
    } else {
      return;
    }
    e.preventDefault();
  });
})();
)";

// Asks a file beside the page, as scripts are all that a page without a server may load, whether
// it was drawn anew; what the reader had chosen, and where, is kept. When the file is gone nobody
// draws any more.
inline constexpr const char* kLive =
    R"(</script>
<script>
"use strict";
(() => {
  const name = location.pathname.split("/").pop() + ".live.js", main = document.querySelector("main");
  const search = document.querySelector("input"), kept = "burin " + location.pathname;
  let first = null, missed = 0;
  window.burin_drawn = stamp => {
    if (first === null) first = stamp;
    if (stamp === first) return;
    const row = document.querySelector("tr.chosen");
    try {
      sessionStorage.setItem(kept, JSON.stringify(
        {item: row && row.dataset.item, search: search.value, top: main.scrollTop}));
    } catch (e) { }
    location.reload();
  };
  const look = () => {
    const s = document.createElement("script");
    s.src = name + "?" + Date.now();
    s.onload = () => { missed = 0; s.remove(); setTimeout(look, 100); };
    s.onerror = () => { s.remove(); if (++missed < 3) setTimeout(look, 1000); };
    document.head.append(s);
  };
  try {
    const was = JSON.parse(sessionStorage.getItem(kept) || "null");
    sessionStorage.removeItem(kept);
    if (was) {
      search.value = was.search;
      search.dispatchEvent(new Event("input"));
      const row = [...document.querySelectorAll("tr[data-item]")].find(r => r.dataset.item === was.item);
      if (row) row.click();
      main.scrollTop = was.top;
    }
  } catch (e) { }
  look();
})();
)";

inline constexpr const char* kTail = "</script>\n</body>\n</html>\n";

}  // namespace burin::html
