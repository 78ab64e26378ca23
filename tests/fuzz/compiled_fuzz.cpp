// Any octets as a compiled ontology, and as what stands behind a right header: refused, or answered without a fault.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "el/container.hpp"
#include "el/ontology.hpp"

namespace {

using namespace geminga;

constexpr std::uint32_t asked = 12;

void ask(std::vector<std::byte> bytes) {
  const auto ontology = el::Ontology::from_bytes(std::move(bytes));
  if (!ontology) {
    GEMINGA_ASSERT(!ontology.error().text.empty());
    GEMINGA_ASSERT(base::is_valid_utf8(ontology.error().text));
    return;
  }
  (void)ontology->files();
  (void)ontology->left_out();
  const std::uint32_t count = std::min(ontology->class_count(), asked);
  for (std::uint32_t sub = 0; sub < count; ++sub) {
    const el::ClassNumber number{sub};
    (void)ontology->find(ontology->short_name(number));
    (void)ontology->find_iri(ontology->iri(number));
    (void)ontology->label(number);
    (void)ontology->parents(number);
    (void)ontology->children(number);
    (void)ontology->subsumers(number);
    for (std::uint32_t super = 0; super < count; ++super) {
      (void)ontology->is_subsumed(number, el::ClassNumber{super});
      (void)ontology->distance(number, el::ClassNumber{super});
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  const std::span all(octets, size);
  const auto bytes = std::as_bytes(all);
  ask({bytes.begin(), bytes.end()});
  // A checksum that fits, which no mutation finds.
  if (size > el::container_header_bytes) ask(el::wrap(all.subspan(el::container_header_bytes)));
  return 0;
}
