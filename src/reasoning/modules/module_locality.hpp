// Bottom locality: the axioms that say nothing about a signature, and the names that they wait for.
//
// An axiom is local with respect to a signature S if it holds as soon as every name outside S is empty (Cuenca Grau,
// Horrocks, Kazakov, Sattler: Modular Reuse of Ontologies, 2008). Testing every axiom again after each growth of S
// would be slow. Instead a test names what the axiom waits for: a set of names of which at least one must enter S
// before the axiom can cease to be local.
#ifndef GEMINGA_REASONING_MODULES_MODULE_LOCALITY_HPP
#define GEMINGA_REASONING_MODULES_MODULE_LOCALITY_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/taxonomy/classified_view.hpp"

namespace geminga::modules {

/// The terms with a fixed meaning, or ClassifiedView::none if no axiom uses them.
struct BuiltIn {
  std::uint32_t thing = taxonomy::ClassifiedView::none;
  std::uint32_t nothing = taxonomy::ClassifiedView::none;
  std::uint32_t top_object_property = taxonomy::ClassifiedView::none;
  std::uint32_t top_data_property = taxonomy::ClassifiedView::none;
  std::uint32_t bottom_object_property = taxonomy::ClassifiedView::none;
  std::uint32_t bottom_data_property = taxonomy::ClassifiedView::none;
};
inline constexpr std::size_t built_in_count = 6;

/// True if terms of this kind make up a module's signature.
[[nodiscard]] constexpr bool is_entity(owl::TermKind kind) {
  return kind <= owl::TermKind::anonymous_individual && kind != owl::TermKind::datatype;
}

/// The answer of a locality test.
enum class Locality : std::uint8_t {
  not_local,  ///< the axiom says something about the signature
  waiting,    ///< the axiom is local until one of its names enters the signature
  always,     ///< the axiom is local for every signature
};

/// The limit of terms of one axiom that are looked at, each as often as it occurs. Beyond it the axiom counts as not
/// local, which is always sound. Terms may share their parts, so that a few lines of a file can mean 2^60 of them.
inline constexpr std::uint32_t max_terms_looked_at = 10'000;

/// Tests axioms against a signature that the caller keeps. Recursion is bounded by the nesting of terms.
class LocalityTest {
 public:
  /// Requires an entry of `is_in_signature` and `uses` for each term. Of several sets of names to wait for, one with
  /// few uses is chosen. All arguments must outlive the test.
  LocalityTest(const taxonomy::ClassifiedView& view, const BuiltIn& built_in, const std::vector<bool>& is_in_signature,
               std::span<const std::uint32_t> uses)
      : view_(view), built_in_(built_in), is_in_signature_(is_in_signature), uses_(uses) {}

  [[nodiscard]] Locality test(std::uint32_t axiom);
  /// The names that the last tested axiom waits for. Valid until the next test.
  [[nodiscard]] std::span<const std::uint32_t> names() const { return names_; }

 private:
  using Numbers = taxonomy::ClassifiedView::Numbers;

  template <typename Test>
  Locality any(Numbers terms, Test&& test);
  template <typename Test>
  Locality all(Numbers terms, Test&& test);
  template <typename Test>
  Locality two(Numbers terms, Test&& test);
  template <typename First, typename Second>
  Locality both(First&& first, Second&& second);
  Locality keep_better(std::size_t start, std::size_t middle);
  [[nodiscard]] std::uint64_t cost(std::size_t first, std::size_t last) const;
  Locality wait_for(std::uint32_t entity);

  // Each test asks whether something holds whatever the names outside the signature mean; not_local says that it does.
  Locality not_empty_role(std::uint32_t term);
  Locality not_empty(std::uint32_t term);
  Locality not_everything(std::uint32_t term);
  Locality not_empty_successor(Numbers arguments);
  Locality of_class_axiom(owl::AxiomKind kind, Numbers arguments);

  const taxonomy::ClassifiedView& view_;
  const BuiltIn& built_in_;
  const std::vector<bool>& is_in_signature_;
  std::span<const std::uint32_t> uses_;
  std::uint32_t looked_at_ = 0;
  std::vector<std::uint32_t> names_;  ///< a stack: each test leaves its names on top
};

}  // namespace geminga::modules

#endif
