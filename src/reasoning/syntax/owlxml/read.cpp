#include "reasoning/syntax/owlxml/read.hpp"

#include <utility>

#include "base/text.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/owlxml/builder.hpp"
#include "reasoning/syntax/owlxml/events.hpp"

namespace geminga::owlxml {

std::expected<Document, ReadError> read(std::string_view bytes, owl::FileId file, owl::Ontology& source,
                                        const XmlLimits& limits, std::vector<owl::Annotation>* annotations,
                                        unsigned threads) {
  const auto refuse = [&](std::uint32_t line, std::string text) {
    const std::string& path = source.files()[static_cast<std::size_t>(file)].path;
    return std::unexpected(ReadError{base::printable(path, 4096), line, std::move(text)});
  };
  if (bytes.size() > limits.file_bytes)
    return refuse(0, "larger than " + std::to_string(limits.file_bytes) + " bytes: split it");
  Builder builder(bytes, file, source, limits, annotations);
  const bool is_apart = threads > 1 && bytes.size() >= limits.apart_bytes;
  if (auto problem = is_apart ? walk_apart(bytes, limits, builder) : walk(bytes, limits, builder))
    return refuse(problem->line, std::move(problem->text));
  if (const auto& problem = source.problem()) return refuse(0, *problem);
  return builder.take_document();
}

}  // namespace geminga::owlxml
