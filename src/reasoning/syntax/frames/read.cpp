#include "reasoning/syntax/frames/read.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/frames/parser.hpp"

namespace geminga::frames {
namespace {

/// The first line with something that a reader of texts must not see.
std::optional<ReadError> check_text(std::string_view bytes) {
  const bool has_nul = bytes.find('\0') != std::string_view::npos;
  if (!has_nul && base::is_valid_utf8(bytes)) return std::nullopt;
  std::uint32_t line = 1;
  while (true) {
    const std::string_view text = bytes.substr(0, bytes.find('\n'));
    if (text.find('\0') != std::string_view::npos) return ReadError{{}, line, "a NUL byte"};
    if (!base::is_valid_utf8(text)) return ReadError{{}, line, "bytes that are no UTF-8: save the file as UTF-8"};
    if (text.size() == bytes.size()) return std::nullopt;
    bytes.remove_prefix(text.size() + 1);
    ++line;
  }
}

}  // namespace

void look_ahead(std::string_view bytes, Declared& declared, const FrameLimits& limits) {
  bytes = base::without_mark(bytes);
  if (bytes.size() > limits.file_bytes || check_text(bytes)) return;
  owl::Ontology unused;
  const owl::FileId file = unused.add_file("");
  const Declared none;
  Parser(bytes, file, unused, none, limits).look_ahead(declared);
}

std::expected<Document, ReadError> read(std::string_view bytes, owl::FileId file, owl::Ontology& source,
                                        const Declared& declared, const FrameLimits& limits,
                                        std::vector<owl::Annotation>* annotations) {
  const auto refuse = [&](ReadError error) {
    error.file = base::printable(source.files()[static_cast<std::size_t>(file)].path, 4096);
    return std::unexpected(std::move(error));
  };
  if (bytes.size() > limits.file_bytes)
    return refuse({{}, 0, "larger than " + std::to_string(limits.file_bytes) + " bytes: split it"});
  bytes = base::without_mark(bytes);
  if (auto error = check_text(bytes)) return refuse(std::move(*error));
  auto document = Parser(bytes, file, source, declared, limits, annotations).run();
  if (!document) return refuse(std::move(document.error()));
  return std::move(*document);
}

}  // namespace geminga::frames
