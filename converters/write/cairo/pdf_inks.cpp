#include <burin/drawing/near_sheet.h>
#include <burin/drawing/text.h>
#include <burin/drawing/title.h>

#include "pdf_date.h"
#include "pdf_letters.h"
#include "pdf_objects.h"
#include "shapes.h"
#include "writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace burin {
namespace {

/// The opacity of an area as states of the pen have it.
long percent(const Area& area) { return std::lround(100 * area.opacity); }

/// What pages name: inks by their place in a list, states of the pen.
class Inks {
 public:
  explicit Inks(std::span<const Drawing* const> pages) {
    for (const Drawing* page : pages) {
      for (const SpotInk& ink : page->inks) {
        if (std::ranges::find(inks_, ink.name, &SpotInk::name) == inks_.end()) inks_.push_back(ink);
      }
      for (const Area& area : page->areas) percents_.insert(percent(area));
    }
  }

  /// Nothing where the drawing says nothing of it.
  std::optional<std::size_t> place(const std::string& name) const {
    const auto ink = std::ranges::find(inks_, name, &SpotInk::name);
    if (ink == inks_.end()) return std::nullopt;
    return static_cast<std::size_t>(ink - inks_.begin());
  }

  /// That of a line: the one of its colour, first the one that its part is printed in. Greys are
  /// black but for hatching, whose colour was chosen for it. Nothing: the line is in no spot ink.
  std::optional<std::size_t> of_line(const Shape& shape, const std::string& of_part) const {
    const bool hatches = shape.path && shape.path->kind == LineClass::Pattern;
    if (is_grey(shape.color) && !(hatches && !shape.path->color.empty())) return std::nullopt;
    const auto is_that = [&](const SpotInk& ink) { return rgb_of(ink.color) == shape.color; };
    if (const auto own = place(of_part); own && is_that(inks_[*own])) return own;
    const auto ink = std::ranges::find_if(inks_, is_that);
    if (ink == inks_.end()) return std::nullopt;
    return static_cast<std::size_t>(ink - inks_.begin());
  }

  /// `fonts`: what `PdfLetters::write` returns.
  std::string resources(const std::string& fonts) const {
    std::string spaces, states;
    for (std::size_t i = 0; i < inks_.size(); ++i) {
      const Rgb rgb = rgb_of(inks_[i].color).value_or(Rgb{});
      spaces += fmt::format(
          " /I{} [/Separation {} /DeviceRGB << /FunctionType 2 /Domain [0 1] /C0 [1 1 1] /C1 "
          "[{:.4f} {:.4f} {:.4f}] /N 1 >>]",
          i, pdf_name(inks_[i].name), rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
    }
    for (const long percent : percents_) {
      states += fmt::format(" /O{} << /ca {:.2f} >>", percent, static_cast<double>(percent) / 100);
    }
    return fmt::format(
        "<< /ColorSpace <<{} >> /ExtGState << /Over << /OP true /op true /OPM 1 >> /Knock << /OP "
        "false /op false >>{} >> /Font {} >>",
        spaces, states, fonts);
  }

 private:
  std::vector<SpotInk> inks_;
  std::set<long> percents_{100};
};

/// The operators of one page.
class Page {
 public:
  Page(const Drawing& drawing, const Inks& inks, PdfLetters& letters)
      : inks_(inks), letters_(letters) {
    for (const Area& area : drawing.areas) of_parts_.try_emplace(area.part, area.ink);
    append(out_, fmt::format("{0:.6f} 0 0 {0:.6f} 0 0 cm 1 J 1 j\n", kPointsPerMm));
    if (drawing.paper_color == Drawing().paper_color) return;
    use(rgb_of(drawing.paper_color).value_or(Rgb{}));
    append(out_, fmt::format("0 0 {} {} re f\n", drawing.paper_width, drawing.paper_height));
  }

  void add(const Shape& shape) {
    if (shape.area) return add(*shape.area, shape.color);
    use_line(shape);
    if (shape.text) return letters_.show(*shape.text, out_);
    for (const auto& chain : shape.ink.chains) {
      const Vec2 start = chain.empty() ? shape.path->points.front() : chain.front()[0];
      point(start, 'm');
      if (chain.empty()) point(start, 'l');  // a dot, by its round caps
      for (const CubicBezier& c : chain) {
        if (is_straight(c, kStraight)) {
          point(c[3], 'l');
        } else {
          numbers(c[1]);
          numbers(c[2]);
          point(c[3], 'c');
        }
      }
      if (!chain.empty() && (shape.ink.filled || shape.path->closed)) append(out_, "h\n");
    }
    if (shape.ink.filled) return append(out_, "f\n");
    use_dashes(shape.dashes);
    use_width(shape.ink.width);
    append(out_, "S\n");
  }

  std::string take() { return fmt::to_string(out_); }

 private:
  void add(const Area& area, const Rgb& color) {
    set("/Knock gs");
    if (const auto ink = inks_.place(area.ink)) {
      use_ink(*ink, area.tint);
    } else {
      use_process(color);
    }
    for (const std::vector<Vec2>& ring : area.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) point(ring[i], i == 0 ? 'm' : 'l');
      append(out_, "h\n");
    }
    if (area.opacity < 1) {
      return append(out_, fmt::format("/O{} gs f* /O100 gs\n", percent(area)));
    }
    use_dashes({});
    use_width(kTrap);
    append(out_, "B*\n");
  }

  /// Greys are printed over what is there; white and colours are not.
  void use_line(const Shape& shape) {
    const Rgb& color = shape.color;
    const auto own = shape.path ? of_parts_.find(shape.path->source.part) : of_parts_.end();
    if (const auto ink = inks_.of_line(shape, own == of_parts_.end() ? "" : own->second)) {
      set("/Knock gs");
      return use_ink(*ink, 1);
    }
    set(is_grey(color) && color[0] < 255 ? "/Over gs" : "/Knock gs");
    use_process(color);
  }

  /// Greys are tints of black.
  void use_process(const Rgb& color) {
    if (!is_grey(color)) return use(color);
    use(fmt::format("0 0 0 {0:.4g} k 0 0 0 {0:.4g} K", 1 - color[0] / 255.0));
  }
  void use_ink(std::size_t ink, double tint) {
    use(fmt::format("/I{0} cs {1:.4g} scn /I{0} CS {1:.4g} SCN", ink, tint));
  }
  void use(const Rgb& color) {
    use(fmt::format("{0:.4f} {1:.4f} {2:.4f} rg {0:.4f} {1:.4f} {2:.4f} RG", color[0] / 255.0,
                    color[1] / 255.0, color[2] / 255.0));
  }
  void use(const std::string& color) {
    if (color == color_) return;
    append(out_, (color_ = color) + "\n");
  }
  void set(const std::string& state) {
    if (state == state_) return;
    append(out_, (state_ = state) + "\n");
  }
  void use_width(double width) {
    if (width == width_) return;
    append_fixed(out_, width_ = width, kPdfDecimals);
    append(out_, " w\n");
  }
  void use_dashes(const std::vector<double>& dashes) {
    if (dashes == dashes_) return;
    dashes_ = dashes;
    append(out_, "[");
    for (const double length : dashes) {
      append_fixed(out_, length, kPdfDecimals);
      append(out_, " ");
    }
    append(out_, "] 0 d\n");
  }

  void numbers(Vec2 p) {
    append_fixed(out_, p.x, kPdfDecimals);
    append(out_, " ");
    append_fixed(out_, p.y, kPdfDecimals);
    append(out_, " ");
  }
  void point(Vec2 p, char how) {
    numbers(p);
    out_.push_back(how);
    out_.push_back('\n');
  }

  const Inks& inks_;
  PdfLetters& letters_;
  /// What parts are printed in; empty: no spot ink.
  std::map<std::int32_t, std::string> of_parts_;
  Buffer out_;
  std::string color_, state_;
  double width_ = -1;
  std::vector<double> dashes_;
};

std::string painted_inks(const Drawing& drawing, const Inks& inks, PdfLetters& letters,
                         const WriteOptions& options, const RunContext& context) {
  const NearSheet sheet(drawing);
  std::vector<Shape> shapes = shapes_of(sheet.layers(), drawing, options.svg.dashes);
  Page page(drawing, inks, letters);
  for (std::size_t begin = 0; begin < shapes.size(); begin += kAtOnce) {
    const auto some = std::span(shapes).subspan(begin, std::min(kAtOnce, shapes.size() - begin));
    fit_ink(some, options.svg.fit_tolerance, TextsAs::Letters, context);
    for (Shape& shape : some) {
      page.add(shape);
      shape.ink.chains = {};
    }
    context.check();
  }
  return page.take();
}

std::string info_of(const Drawing& drawing) {
  const auto date = asked_date("D:%Y%m%d%H%M%SZ");
  return fmt::format("<< /Title {} /Subject {} /Creator {}{} >>", pdf_text(title_of(drawing)),
                     pdf_text(subject_of(drawing)), pdf_text(creator()),
                     date.empty() ? "" : fmt::format(" /CreationDate ({})", date));
}

}  // namespace

void write_pdf_with_inks(std::span<const Drawing* const> pages, const WriteOptions& options,
                         std::ostream& out, const RunContext& context) {
  const Inks inks(pages);
  PdfObjects file(out);
  const std::size_t catalog = file.reserve(), tree = file.reserve(), info = file.reserve(),
                    resources = file.reserve();
  file.write(catalog, fmt::format("<< /Type /Catalog /Pages {} 0 R >>", tree));
  file.write(info, info_of(*pages.front()));
  PdfLetters letters;
  std::string kids;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const std::size_t page = file.reserve(), content = file.reserve();
    kids += fmt::format("{} 0 R ", page);
    file.write(page, fmt::format("<< /Type /Page /Parent {} 0 R /MediaBox [0 0 {:.4f} {:.4f}] "
                                 "/Resources {} 0 R /Contents {} 0 R >>",
                                 tree, pages[i]->paper_width * kPointsPerMm,
                                 pages[i]->paper_height * kPointsPerMm, resources, content));
    file.write_stream(content, painted_inks(*pages[i], inks, letters, options, context));
    if (options.progress) {
      options.progress(static_cast<double>(i + 1) / static_cast<double>(pages.size()));
    }
  }
  file.write(resources, inks.resources(letters.write(file)));
  file.write(tree, fmt::format("<< /Type /Pages /Kids [{}] /Count {} >>", kids, pages.size()));
  file.finish(catalog, info);
}

}  // namespace burin
