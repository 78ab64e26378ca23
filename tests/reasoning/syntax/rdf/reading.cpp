// Everything goes through real files, because load() knows nothing else.
#include "reasoning/syntax/rdf/reading.hpp"

#include <filesystem>

#include "reasoning/syntax/rdf/scratch.hpp"

namespace geminga::rdf {

std::expected<Loaded, syntax::LoadError> load_text(const std::string& name, std::string_view content,
                                                   const syntax::FileLimits& limits) {
  const Scratch scratch;
  auto loaded = load(std::vector{scratch.write(name, content)}, limits);
  if (!loaded) loaded.error().file = std::filesystem::path(loaded.error().file).filename().string();
  return loaded;
}

std::string refusal(const std::string& name, std::string_view content, const syntax::FileLimits& limits) {
  const auto loaded = load_text(name, content, limits);
  return loaded ? "accepted" : to_string(loaded.error());
}

std::string xml(std::string_view content, std::string_view doctype) {
  return "<?xml version=\"1.0\"?>\n" + std::string(doctype) +
         "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
         "xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\" xmlns:e=\"http://e/\">\n" +
         std::string(content) + "</rdf:RDF>\n";
}

std::string times(std::size_t count, std::string_view text) {
  std::string all;
  all.reserve(count * text.size());
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

}  // namespace geminga::rdf
