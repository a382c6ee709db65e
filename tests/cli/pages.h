#pragma once
/// Pages in a browser without a window.

#include <burin_test/command.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace burin::test {

inline bool has_chromium() { return std::system("command -v chromium > /dev/null 2>&1") == 0; }

/// Opens a page with a probe at its end, which leaves a <pre> alone in the body, and gives its
/// text.
inline std::string said_by_page(const Folder& folder, std::string page, const std::string& probe) {
  page.replace(page.find("</body>"), 7, probe + "</body>");
  folder.write("p.html", page);
  const std::string command =
      "chromium --headless=new --no-sandbox --disable-gpu --user-data-dir=" + (folder / "profile") +
      " --dump-dom file://" + (folder / "p.html") + " > " + (folder / "dom") + " 2> " +
      (folder / "said");
  EXPECT_EQ(std::system(command.c_str()), 0) << slurp(folder / "said");
  const std::string dom = slurp(folder / "dom");
  const std::size_t at = dom.find("<pre>");
  if (at == std::string::npos) return "no <pre>: " + dom;
  return dom.substr(at + 5, dom.find("</pre>") - at - 5);
}

}  // namespace burin::test
