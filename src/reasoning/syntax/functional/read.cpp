#include "reasoning/syntax/functional/read.hpp"

#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/functional/parser.hpp"
#include "reasoning/syntax/functional/tokenizer.hpp"

namespace geminga::functional {
namespace {

std::string_view without_blanks(std::string_view text) {
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    if (!text.starts_with('#')) return text;
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end);
  }
}

}  // namespace

bool is_functional(std::string_view bytes) {
  const std::string_view text = without_blanks(base::without_mark(bytes));
  for (const std::string_view word : {"Prefix", "Ontology"}) {
    if (text.starts_with(word) && without_blanks(text.substr(word.size())).starts_with('(')) return true;
  }
  return false;
}

std::expected<Document, ReadError> read(std::string_view bytes, owl::FileId file, owl::Ontology& source,
                                        const Limits& limits, std::vector<owl::Annotation>* annotations) {
  const auto refuse = [&](Problem problem) {
    const std::string& path = source.files()[static_cast<std::size_t>(file)].path;
    return std::unexpected(ReadError{base::printable(path, 4096), problem.line, std::move(problem.text)});
  };
  if (bytes.size() > limits.file_bytes)
    return refuse({0, "larger than " + std::to_string(limits.file_bytes) + " bytes: split it"});
  bytes = base::without_mark(bytes);
  if (auto problem = check_text(bytes)) return refuse(std::move(*problem));
  auto document = Parser(bytes, file, source, limits, annotations).run();
  if (!document) return refuse(std::move(document.error()));
  return std::move(*document);
}

}  // namespace geminga::functional
