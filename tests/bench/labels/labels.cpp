// burin_labels DRAWING.json...: a row a file with the counts of LabelFaults, then a line for each.
#include <burin/converters/read_drawing.h>

#include <burin_test/label_faults.h>

#include <exception>

int main(int argc, char** argv) try {
  for (int i = 1; i < argc; ++i) {
    burin::RunContext context;
    const burin::Drawing drawing = burin::read_drawing(argv[i], context);
    const burin::test::LabelFaults f = burin::test::label_faults(drawing);
    fmt::print("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", argv[i], f.texts, f.leaders, f.overlaps,
               f.circles, f.off_sheet, f.under_leaders, f.under_lines, f.crossings, f.over_lines);
    for (const std::string& line : f.told) fmt::print("#\t{}\n", line);
  }
} catch (const std::exception& e) {
  fmt::print(stderr, "burin_labels: {}\n", e.what());
  return 1;
}
