#include "reasoning/syntax/functional/read.hpp"

#include <utility>

#include "base/text.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/functional/parser.hpp"
#include "reasoning/syntax/functional/tokenizer.hpp"

namespace geminga::functional {

std::expected<Document, ReadError> read(std::string_view bytes, owl::FileId file, owl::Ontology& source,
                                        const FunctionalLimits& limits, std::vector<owl::Annotation>* annotations) {
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
