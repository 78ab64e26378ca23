// The place of an axiom, and why it is not used.
#include "reasoning/reasoner/unused.hpp"

#include "reasoning/owl/loaded_file.hpp"

namespace geminga::reasoner {

std::string describe_unused(const owl::Ontology& source, std::uint32_t axiom, std::string_view construct) {
  const owl::Axiom unused = source.axiom(axiom);
  const std::string& path = source.files()[static_cast<std::size_t>(unused.file)].path;
  std::string text = "an axiom cannot be used because of " + std::string(construct);
  if (unused.line != 0) text += ": " + path + ':' + std::to_string(unused.line);
  return text;
}

}  // namespace geminga::reasoner
