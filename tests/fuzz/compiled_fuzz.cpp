// Any octets as a compiled ontology, and as what stands behind a right header: refused, or answered without a fault.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/compiled/container.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/modules/module.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace {

using namespace geminga;

constexpr std::uint32_t asked = 12;

void ask(std::vector<std::byte> bytes) {
  const auto ontology = compiled::Ontology::from_bytes(std::move(bytes));
  if (!ontology) {
    GEMINGA_ASSERT(!ontology.error().text.empty());
    GEMINGA_ASSERT(base::is_valid_utf8(ontology.error().text));
    return;
  }
  (void)ontology->files();
  (void)ontology->left_out();
  (void)ontology->gaps();
  for (const auto& whole : {ontology->check_labels(), ontology->check_axioms()}) {
    GEMINGA_ASSERT(whole || (!whole.error().text.empty() && base::is_valid_utf8(whole.error().text)));
  }
  const taxonomy::ClassifiedView& axioms = ontology->axioms();
  GEMINGA_ASSERT(ontology->check_axioms() || axioms.axiom_count() == 0);
  const std::uint32_t count = std::min(ontology->class_count(), asked);
  for (std::uint32_t sub = 0; sub < count; ++sub) {
    const taxonomy::ClassNumber number{sub};
    (void)ontology->find(ontology->short_name(number));
    (void)ontology->find(std::string(ontology->label(number)) + "x");
    for (const std::uint32_t axiom : modules::extract_module(ontology->module_index(), {{number}})) {
      for (const std::uint32_t term : axioms.arguments_of_axiom(axiom)) (void)axioms.name_of_term(term);
    }
    (void)ontology->find_iri(ontology->iri(number));
    (void)ontology->label(number);
    (void)ontology->parents(number);
    (void)ontology->children(number);
    (void)ontology->subsumers(number);
    for (std::uint32_t super = 0; super < count; ++super) {
      (void)ontology->is_subsumed(number, taxonomy::ClassNumber{super});
      (void)ontology->distance(number, taxonomy::ClassNumber{super});
    }
  }
}

/// Magic, version, sizes and checksums that fit what stands behind them.
void give_right_header(std::vector<std::byte>& file) {
  const std::array<std::span<const std::uint8_t>, compiled::section_count> nothing{};
  const std::vector<std::byte> empty = compiled::wrap(nothing);
  std::uint64_t rest = file.size() - compiled::container_header_bytes;
  std::array<std::uint64_t, compiled::section_count> sizes{};
  for (std::size_t at = 0; at < compiled::section_count; ++at) {
    std::memcpy(&sizes[at], file.data() + 16 + at * 16, sizeof sizes[at]);
    sizes[at] = std::min(sizes[at], rest) / compiled::section_alignment * compiled::section_alignment;
    if (at + 1 == compiled::section_count) sizes[at] = rest / compiled::section_alignment * compiled::section_alignment;
    rest -= sizes[at];
  }
  file.resize(file.size() - rest);
  std::ranges::copy(std::span(empty).first(compiled::container_header_bytes), file.begin());
  for (std::size_t at = 0; at < compiled::section_count; ++at) {
    std::memcpy(file.data() + 16 + at * 16, &sizes[at], sizeof sizes[at]);
  }
  compiled::seal(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  const std::span all(octets, size);
  const auto bytes = std::as_bytes(all);
  ask({bytes.begin(), bytes.end()});
  if (size < compiled::container_header_bytes) return 0;
  // Checksums that fit, which no mutation finds, over sections as long as the header says where it can be so.
  std::vector<std::byte> sealed(bytes.begin(), bytes.end());
  give_right_header(sealed);
  ask(std::move(sealed));
  return 0;
}
