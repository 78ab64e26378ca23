// Lays a classified ontology out in flat arrays, section by section.
#include "reasoning/compiled/compile.hpp"

#include <array>

#include "reasoning/compiled/compile_sections.hpp"
#include "reasoning/compiled/container.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::compiled {
namespace {

/// Far more than the parts of a section take beside its arrays.
constexpr std::size_t spare_bytes = std::size_t{1} << 20;

/// Whether all of it can be addressed, as far as sizes are known in advance.
bool fits(const CompilerInput& input, const CompileOptions& options) {
  const auto& [source, classification, hashes, order] = input;
  std::size_t bytes = classification.class_count() * 80 + classification.parents.size() * 8;
  for (const owl::NameId id : classification.classes) bytes += source.name(id).size();
  for (const owl::Ontology::Label& label : source.labels()) bytes += source.name(label.text).size() + 8;
  for (const owl::TermId term : order.terms) {
    bytes += source.name_of(term).size() + 21 + source.term(term).arguments.size() * 4;
  }
  for (const auto& axiom : order.axioms) bytes += 15 + axiom.arguments.size() * 8;
  for (const owl::LoadedFile& file : source.files()) {
    bytes += options.folder.size() + file.path.size() + file.ontology_iri.size() + 64;
  }
  bytes += classification.unused.size() * 8;
  bytes += source.unit_statements().size() * owl::max_unit_text_octets;
  return bytes < max_compiled_bytes - spare_bytes;
}

template <typename Root, typename Content>
std::span<const std::uint8_t> pack(flatbuffers::FlatBufferBuilder& builder, const Content& content) {
  builder.Finish(Root::Pack(builder, &content));
  return {builder.GetBufferPointer(), builder.GetSize()};
}

}  // namespace

std::vector<std::byte> compile(const owl::Ontology& source, const taxonomy::Classification& classification,
                               const CompileOptions& options) {
  const owl::ContentHashes hashes(source);
  const owl::CanonicalOrder order = canonical_order(source, hashes);
  const CompilerInput input{source, classification, hashes, order};
  if (!fits(input, options)) return {};
  form::TaxonomyT taxonomy;
  form::LabelsT labels;
  form::AxiomsT axioms;
  taxonomy.digest = digest(source);
  write_sources(input, options, taxonomy);
  write_classes(input, taxonomy);
  if (taxonomy.further.size() > max_list_items) return {};
  write_conversions(input, taxonomy);
  write_units(input, taxonomy);
  write_labels(input, labels);
  write_signatures(labels, taxonomy);
  if (!write_axioms(input, taxonomy, axioms)) return {};
  std::array<flatbuffers::FlatBufferBuilder, section_count> builders;
  const std::array<std::span<const std::uint8_t>, section_count> sections = {
      pack<form::Taxonomy>(builders[0], taxonomy), pack<form::Labels>(builders[1], labels),
      pack<form::Axioms>(builders[2], axioms)};
  std::size_t bytes = container_header_bytes;
  for (const auto& section : sections) bytes += section.size() + section_alignment;
  return bytes <= max_compiled_bytes ? wrap(sections) : std::vector<std::byte>();
}

}  // namespace geminga::compiled
