#include <burin/converters/write_difference.h>
#include <burin/drawing/text.h>
#include <burin/drawing/title.h>

#include "html_page.h"
#include "html_parts.h"

#include <ostream>

namespace burin {
namespace {

constexpr const char* kStyle = R"(<style>
aside { width: 34em }
nav { display: flex; margin: 12px 12px 0 }
nav button { flex: 1; padding: 6px; font: inherit; border: 1px solid #999; background: #fff; cursor: pointer }
nav button[aria-pressed=true] { background: #333; color: #fff }
td:nth-child(1), th:nth-child(1) { text-align: left; width: 6.5em; white-space: nowrap; font-weight: 600 }
td:nth-child(2), th:nth-child(2) { text-align: left; width: auto; font-size: 13px }
td:nth-child(3), th:nth-child(3) { color: #444; font-size: 12px }
tr.added td:first-child, tr.new td:first-child { color: #00802b }
tr.removed td:first-child, tr.gone td:first-child { color: #d00000 }
tr.moved td:first-child { color: #0046c8 }
tr.renamed td:first-child { color: #6a1b9a }
tr.look td:first-child { color: #9a5b00 }
tr.same td { color: #888; font-weight: 400 }
.old [data-of=new], .new [data-of=old] { display: none }
@media print { nav { display: none } }
</style>
)";

constexpr const char* kHead = R"(</main>
<aside>
<nav aria-label="Revision"><button data-show="old" aria-pressed="false">Old</button><button data-show="" aria-pressed="true">Both</button><button data-show="new" aria-pressed="false">New</button></nav>
<input type="search" placeholder="Search parts" aria-label="Search parts">
<div><table>
<thead><tr><th>What</th><th>Part</th><th>How</th></tr></thead>
<tbody>
)";

// What layers show is told by how their names begin.
constexpr const char* kScript = R"("use strict";
(() => {
  const main = document.querySelector("main");
  const of = {old: ["removed-", "changed-from-", "moved-from-", "gone-"],
              new: ["added-", "changed-to-", "changed-new-", "moved-to-", "new-", "moved-arrows"]};
  for (const g of main.querySelectorAll("g")) {
    const name = g.getAttribute("inkscape:label") || "";
    for (const side of ["old", "new"])
      if (of[side].some(begin => name.startsWith(begin))) g.dataset.of = side;
  }
  const buttons = [...document.querySelectorAll("nav button")];
  for (const button of buttons) {
    button.addEventListener("click", () => {
      main.classList.remove("old", "new");
      if (button.dataset.show) main.classList.add(button.dataset.show);
      for (const b of buttons) b.setAttribute("aria-pressed", b === button);
    });
  }
})();
)";

void append_difference_row(Buffer& out, const DifferenceRow& row) {
  append(out, fmt::format("<tr class=\"{}\"", html::escaped(row.change)));
  if (row.item > 0) append(out, fmt::format(" data-item=\"{}\" tabindex=\"-1\"", row.item));
  append(out, fmt::format("><td>{}</td><td>{}</td><td>{}</td></tr>\n", html::escaped(row.change),
                          html::escaped(row.name), html::escaped(row.what)));
}

}  // namespace

void write_difference_page(const Drawing& drawing, std::span<const DifferenceRow> rows,
                           const std::string& counts, const WriteOptions& options,
                           std::ostream& out, const RunContext& context) {
  std::string head = html::head(title_of(drawing));
  head.insert(head.find("</head>"), kStyle);
  out << head << "<main>\n" << html::inline_svg(drawing, options.svg, context) << kHead;
  Buffer table;
  for (const bool same : {false, true}) {  // what has changed comes first
    for (const DifferenceRow& row : rows) {
      if ((row.change == "same") == same) append_difference_row(table, row);
    }
  }
  out << fmt::to_string(table) << "</tbody>\n</table></div>\n<p>" << html::escaped(counts)
      << "</p>\n<p>Point at a part or a row; a click keeps it. / searches, Esc lets go.</p>\n"
      << "</aside>\n<script>\n"
      << html::kScript << kScript << html::kTail;
}

}  // namespace burin
