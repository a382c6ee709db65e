#include <burin/drawing/added_formats.h>

#include "declared.h"
#include "rows.h"

#include <fmt/format.h>

#include <ostream>
#include <string_view>

// What a plug-in writes to; it knows the name alone.
struct burin_output {
  std::ostream* out = nullptr;
  const burin::RunContext* context = nullptr;
  std::size_t bytes = 0;
};

namespace burin::plugin {
namespace {

/// A drawing as flat arrays; the drawing outlives it.
class Flat {
 public:
  explicit Flat(const Drawing& d) {
    for (const DrawingPart& part : d.parts) parts_.push_back(part.name.c_str());
    for (const Layer& layer : d.layers) {
      for (const Path& path : layer.paths) add(layer, path);
      for (const Text& text : layer.texts) {
        texts_.push_back({text.text.c_str(), text.at.x, text.at.y, text.height,
                          static_cast<std::int32_t>(text.anchor)});
        turns_.push_back(text.turn);
      }
    }
    all_ = {d.paper_width,         d.paper_height, d.title.c_str(), d.ink_color.c_str(),
            d.paper_color.c_str(), parts_.size(),  parts_.data(),   paths_.size(),
            paths_.data(),         widths_.size(), points_.data(),  widths_.data(),
            texts_.size(),         texts_.data(),  turns_.data()};
  }
  Flat(const Flat&) = delete;
  Flat& operator=(const Flat&) = delete;
  const burin_drawing& lines() const { return all_; }

 private:
  void add(const Layer& layer, const Path& path) {
    paths_.push_back({layer.name.c_str(), to_string(path.kind), path.source.part,
                      path.visible ? 1 : 0, path.closed ? 1 : 0, widths_.size(),
                      path.points.size()});
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      points_.push_back(path.points[i].x);
      points_.push_back(path.points[i].y);
      widths_.push_back(path.width.empty() ? 0 : path.width[path.width.size() == 1 ? 0 : i]);
    }
  }

  std::vector<const char*> parts_;
  std::vector<burin_path> paths_;
  std::vector<burin_text> texts_;
  std::vector<double> turns_;
  std::vector<double> points_, widths_;
  burin_drawing all_{};
};

/// The same with its colours.
class FlatColors {
 public:
  explicit FlatColors(const Drawing& d) : lines_(d) {
    for (const Layer& layer : d.layers) {
      const std::string& of_layer = layer.color.empty() ? d.ink_color : layer.color;
      for (const Path& path : layer.paths) {
        colors_.push_back((path.color.empty() ? of_layer : path.color).c_str());
      }
    }
    for (const Area& area : d.areas) add(area);
    for (const SpotInk& ink : d.inks) inks_.push_back({ink.name.c_str(), ink.color.c_str()});
    all_ = {&lines_.lines(), colors_.data(),     areas_.size(),  areas_.data(), rings_.size(),
            rings_.data(),   points_.size() / 2, points_.data(), inks_.size(),  inks_.data()};
  }
  FlatColors(const FlatColors&) = delete;
  FlatColors& operator=(const FlatColors&) = delete;
  const burin_color_drawing& all() const { return all_; }

 private:
  void add(const Area& area) {
    areas_.push_back({area.part, area.face, area.tone, area.fill.c_str(), area.opacity,
                      area.ink.c_str(), area.tint, area.role.c_str(), rings_.size(),
                      area.rings.size()});
    for (const std::vector<Vec2>& ring : area.rings) {
      rings_.push_back({points_.size() / 2, ring.size()});
      for (const Vec2& p : ring) points_.insert(points_.end(), {p.x, p.y});
    }
  }

  Flat lines_;
  std::vector<const char*> colors_;
  std::vector<burin_area> areas_;
  std::vector<burin_ring> rings_;
  std::vector<double> points_;
  std::vector<burin_ink> inks_;
  burin_color_drawing all_{};
};

std::int32_t take_bytes(burin_output* output, const void* bytes, std::size_t size) noexcept try {
  if (output->context->cancelled()) return BURIN_CANCELLED;
  output->out->write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  output->bytes += size;
  return output->out->good() ? BURIN_OK : BURIN_FAILED;
} catch (const std::exception&) {
  return BURIN_FAILED;
}

bool is_colored(const burin_factory& f) { return std::string_view(f.id) == BURIN_WRITER_2; }

void write(const Source& source, const Drawing& drawing, const std::vector<OptionValue>& values,
           std::ostream& out, const RunContext& context) {
  const Values given(values);
  burin_output output{&out, &context};
  burin_error error{};
  std::int32_t code = BURIN_OK;
  if (is_colored(*source.factory)) {
    const FlatColors flat(drawing);
    code = source.functions<burin_writer_2>().write(&flat.all(), given.data(), take_bytes, &output,
                                                    &error);
  } else {
    const Flat flat(drawing);
    code = source.functions<burin_writer_1>().write(&flat.lines(), given.data(), take_bytes,
                                                    &output, &error);
  }
  context.check();
  if (!out.good()) return;  // who owns the stream says why
  try {
    check(PluginError::Row::Writer, source, code, error);
    if (output.bytes == 0) fail(PluginError::Row::Writer, source, "writes nothing");
  } catch (const PluginError& e) {
    throw OutputError(e.what());
  }
}

}  // namespace

const char* suffix_of(const burin_factory& f) {
  return is_colored(f) ? static_cast<const burin_writer_2*>(f.functions)->suffix
                       : static_cast<const burin_writer_1*>(f.functions)->suffix;
}

void add_writer(const Source& source) {
  add(AddedFormat{
      .name = suffix_of(*source.factory),
      .meaning = source.factory->meaning,
      .write = [source](const Drawing& d, const std::vector<OptionValue>& values, std::ostream& out,
                        const RunContext& context) { write(source, d, values, out, context); },
      .options = declared(*source.factory)});
}

}  // namespace burin::plugin
