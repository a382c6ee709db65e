#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/converters/output.h>
#include <burin/converters/write_book.h>

#include "cairo_loader.h"
#include "html_parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <utility>

namespace burin {
namespace {

namespace fs = std::filesystem;

std::string title_of(const Book& book) { return book.title.empty() ? "Step book" : book.title; }

std::string heading_of(const Book& book, std::size_t page) {
  const std::string& title = book.pages[page].title;
  return title.empty() ? fmt::format("Step {}", page + 1)
                       : fmt::format("Step {}: {}", page + 1, title);
}

/// What is written aside.
class Files {
 public:
  template <class F>
  void write(const std::string& name, const F& body) {
    // What it holds is for `body` to say; of a row of formats nothing is asked here.
    files_.emplace_back(name, formats().front()).write(body);
  }
  std::vector<Output> take() { return std::move(files_); }

 private:
  std::vector<Output> files_;
};

void write_pages(const Book& book, const std::string& name, const WriteOptions& options,
                 const RunContext& context, Files& files) {
  std::vector<const Drawing*> pages;
  for (const BookPage& page : book.pages) pages.push_back(&page.drawing);
  for (const Drawing& list : book.lists) pages.push_back(&list);
  if (pages.empty()) throw GeometryError("nothing to draw: the book has no steps");
  files.write(name, [&](std::ostream& out) {
    // The file is called what the book is.
    Drawing first = *pages.front();
    first.title = title_of(book);
    pages.front() = &first;
    cairo_library().write_pdf(pages, options, out, context);
  });
}

void write_page(const Book& book, const std::string& name, const WriteOptions& options,
                const RunContext& context, Files& files) {
  files.write(name, [&](std::ostream& out) {
    out << html::head(title_of(book)) << "<main class=\"book\">\n<h1>"
        << html::escaped(title_of(book)) << "</h1>\n";
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
      SvgOptions svg = options.svg;
      svg.id_prefix += fmt::format("step{}-", i + 1);
      out << fmt::format("<section id=\"{}step-{}\" aria-label=\"{}\">\n", options.svg.id_prefix,
                         i + 1, html::escaped(heading_of(book, i)))
          << html::inline_svg(book.pages[i].drawing, svg, context) << "</section>\n";
      context.check();
    }
    out << html::list_and_tail(book.items);
  });
}

/// A name as text of Markdown, also in a table.
std::string plain_name(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|").find(c) != std::string_view::npos) out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

/// A name of a file as an address.
std::string address(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool plain_one =
        is_digit(c) || is_letter(c) || std::string_view("-_.~").find(c) != std::string_view::npos;
    out += plain_one ? std::string(1, c)
                     : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return out;
}

std::string added_text(const NewPart& part) {
  const std::string number = part.item > 0 ? fmt::format(" ({})", part.item) : "";
  return fmt::format("{} x {}{}", part.quantity, plain_name(part.name), number);
}

std::string picture_of(const std::string& name, std::size_t page) {
  return fmt::format("{}-step-{:02}.svg", fs::path(name).stem().string(), page + 1);
}

std::string markdown(const Book& book, const std::string& name) {
  std::string out = "# " + plain_name(title_of(book)) + "\n";
  for (std::size_t i = 0; i < book.pages.size(); ++i) {
    const std::string heading = heading_of(book, i);
    out += "\n## " + plain_name(heading) + "\n\n";
    for (const NewPart& part : book.pages[i].added) out += "- " + added_text(part) + "\n";
    out += fmt::format("\n![{}]({})\n", plain_name(heading), address(picture_of(name, i)));
  }
  if (book.items.empty()) return out;
  out += "\n## Parts list\n\n| No. | Qty | Name |\n| ---: | ---: | --- |\n";
  for (const DrawingItem& item : book.items) {
    out += fmt::format("| {} | {} | {} |\n", item.number, item.quantity(), plain_name(item.name));
  }
  return out;
}

void write_markdown(const Book& book, const std::string& name, const WriteOptions& options,
                    const RunContext& context, Files& files) {
  for (std::size_t i = 0; i < book.pages.size(); ++i) {
    const fs::path path = fs::path(name).parent_path() / picture_of(name, i);
    files.write(path.string(), [&](std::ostream& out) {
      write_svg(book.pages[i].drawing, options.svg, out, context);
    });
  }
  files.write(name, [&](std::ostream& out) { out << markdown(book, name); });
}

/// Names come from files: what is no UTF-8 in them is replaced.
std::string text_of(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

nlohmann::ordered_json added_json(const NewPart& part) {
  nlohmann::ordered_json out;
  out["item"] = part.item;
  out["name"] = part.name;
  out["quantity"] = part.quantity;
  return out;
}

void write_data(const Book& book, const std::string& name, const WriteOptions& options,
                const RunContext& context, Files& files) {
  const auto json = values_in<JsonOptions>(options.formats);
  files.write(name, [&](std::ostream& out) {
    out << "{\"format\": \"burin-steps\", \"version\": 1, \"title\": " << text_of(title_of(book))
        << ",\n\"items\": ";
    auto items = nlohmann::ordered_json::array();
    for (const DrawingItem& item : book.items) {
      nlohmann::ordered_json row;
      row["number"] = item.number;
      row["name"] = item.name;
      row["quantity"] = item.quantity();
      row["parts"] = item.things();
      items.push_back(std::move(row));
    }
    out << text_of(items) << ",\n\"pages\": [";
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
      auto added = nlohmann::ordered_json::array();
      for (const NewPart& part : book.pages[i].added) added.push_back(added_json(part));
      out << (i == 0 ? "\n" : ",\n") << "{\"heading\": " << text_of(heading_of(book, i))
          << ", \"added\": " << text_of(added) << ", \"scale\": " << text_of(book.pages[i].scale)
          << ", \"drawing\": ";
      write_json(book.pages[i].drawing, json, out, context);
      out << "}";
      context.check();
    }
    out << "]}\n";
  });
}

/// What step books are written as.
struct Row {
  /// The suffix without its dot.
  std::string_view name;
  void (*write)(const Book&, const std::string&, const WriteOptions&, const RunContext&, Files&);
};

const std::vector<Row>& rows() {
  static const std::vector<Row> all = {
      {"pdf", write_pages},
      {"html", write_page},
      {"md", write_markdown},
      {"json", write_data},
  };
  return all;
}

/// Null where the suffix names none.
const Row* row_of(const std::string& name) {
  const std::string suffix = lowered(fs::path(name).extension().string());
  for (const Row& row : rows()) {
    if (suffix == "." + std::string(row.name)) return &row;
  }
  return nullptr;
}

}  // namespace

void check_book_outputs(const std::vector<std::string>& names,
                        const std::vector<std::string>& sources) {
  std::vector<std::string> taken = sources;
  for (const std::string& name : names) {
    if (!row_of(name)) {
      throw UsageError(
          fmt::format("{}: step books are written as .pdf, .html, .md or .json", name));
    }
    if (std::ranges::any_of(taken, [&](const auto& other) { return same_file(name, other); })) {
      throw UsageError(
          fmt::format("{}: would take the place of another file; name it otherwise", name));
    }
    taken.push_back(name);
    Output(name, formats().front()).probe();
  }
}

std::vector<Output> write_book(const Book& book, const std::vector<std::string>& names,
                               const WriteOptions& options, const RunContext& context) {
  check_book_outputs(names, {});
  Files files;
  for (const std::string& name : names) row_of(name)->write(book, name, options, context, files);
  context.check();
  return files.take();
}

}  // namespace burin
