#include "tree.h"

#include <burin/converters/irit_tree.h>

#include "items.h"
#include "lexer.h"
#include "text.h"

#include <fmt/format.h>

namespace burin {
namespace irit {
namespace {

/// Deeper lists than this are no scenes; the reader's stack holds many more.
constexpr int kDeepestList = 200;

class TreeReader {
 public:
  explicit TreeReader(const Source& source) : in_(source) {}
  IritObject read();

 private:
  IritObject object(const Token& keyword, int depth);
  void content(IritObject& object, const Token& open, int depth);

  Lexer in_;
};

void TreeReader::content(IritObject& object, const Token& open, int depth) {
  in_.source().context().check();
  Token keyword = in_.next();
  if (keyword.kind != Token::Kind::Word) {
    // Between objects, brackets may stand in a comment.
    if (keyword.kind == Token::Kind::Close) return;
    if (keyword.kind == Token::Kind::End) in_.expected(keyword, "a block");
    in_.fail(open, "this block begins with no word; the file is damaged");
  }
  if (raised(keyword.text) != "OBJECT") {
    object.items.push_back(read_item(in_, keyword));
    return;
  }
  if (depth >= kDeepestList) {
    in_.fail(keyword,
             fmt::format("lists lie more than {} deep; the file is damaged", kDeepestList));
  }
  object.objects.push_back(this->object(keyword, depth + 1));
}

IritObject TreeReader::object(const Token& keyword, int depth) {
  IritObject object;
  object.line = in_.line_of(keyword.where);
  object.attributes = read_attributes(in_, true);  // the name may be missing
  const Token name = in_.peek();
  if (name.kind == Token::Kind::Word || name.kind == Token::Kind::Quoted) {
    in_.next();
    if (raised(name.text) != "NONE") object.name = plain(name.text);
  }
  for (;;) {
    const Token token = in_.next_bracket();
    if (token.kind == Token::Kind::Close) return object;
    if (token.kind == Token::Kind::End) {
      in_.fail(keyword, "this object never closes: a ] is missing, or the file is truncated");
    }
    content(object, token, depth);
  }
}

IritObject TreeReader::read() {
  IritObject root;
  for (;;) {
    const Token token = in_.next_bracket();
    if (token.kind == Token::Kind::End) return root;
    if (token.kind == Token::Kind::Close) {
      in_.fail(token, "this ] closes nothing; the brackets do not balance");
    }
    content(root, token, 0);
  }
}

}  // namespace

IritObject parse_tree(const Source& source) { return TreeReader(source).read(); }

}  // namespace irit

const std::string* IritObject::attribute(const std::string& wanted) const {
  for (const IritAttribute& a : attributes) {
    if (lowered(a.name) == lowered(wanted)) return &a.value;
  }
  return nullptr;
}

IritObject read_irit_tree(const std::filesystem::path& path, const RunContext& context) {
  return irit::parse_tree(Source(path, context));
}

}  // namespace burin
