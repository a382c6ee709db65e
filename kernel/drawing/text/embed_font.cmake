# Writes the bytes of a font as a C++ source.
file(READ ${FONT} hex HEX)
string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
file(WRITE ${OUT} "#include <burin/drawing/font.h>\n\nnamespace burin {\n\nnamespace {\n\nconstexpr unsigned char kBytes[] = {\n${bytes}};\n\n}  // namespace\n\nstd::span<const unsigned char> font_file() { return kBytes; }\n\n}  // namespace burin\n")
