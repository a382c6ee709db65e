#pragma once
/// A step book as files.

#include <burin/base/run_context.h>
#include <burin/book/book.h>
#include <burin/converters/output.h>
#include <burin/converters/write.h>

#include <string>
#include <vector>

namespace burin {

/// Tests names before a long run: a suffix that books are written as, no name twice, none of
/// `sources`, a folder that can be written to. Throws UsageError, OutputError.
void check_book_outputs(const std::vector<std::string>& names,
                        const std::vector<std::string>& sources);

/// Writes a book under each name: .pdf is one file with a page a step and the parts list at the
/// end, .html one page that needs nothing else, .md Markdown with the file NAME-step-01.svg and so
/// on beside it, .json all of it as data. Gives all files, which `commit` gives their names. Throws
/// as `check_book_outputs`, `write_drawing`.
std::vector<Output> write_book(const Book& book, const std::vector<std::string>& names,
                               const WriteOptions& options, const RunContext& context);

}  // namespace burin
