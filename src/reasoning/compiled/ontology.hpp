// A classified ontology as the daemon sees it: names, subsumption and axioms, read from its compiled form.
#ifndef GEMINGA_REASONING_COMPILED_ONTOLOGY_HPP
#define GEMINGA_REASONING_COMPILED_ONTOLOGY_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/compiled/compiled_error.hpp"
#include "reasoning/compiled/units_view.hpp"
#include "reasoning/taxonomy/class_number.hpp"
#include "reasoning/taxonomy/conversion.hpp"
#include "reasoning/taxonomy/interval.hpp"
#include "reasoning/taxonomy/reach.hpp"

namespace geminga::owl {
struct LeftOut;
struct LoadedFile;
}  // namespace geminga::owl
namespace geminga::taxonomy {
struct ClassifiedView;
}
namespace geminga::modules {
class ModuleIndex;
}

namespace geminga::compiled {

/// Why a name could not be resolved. `text` is one line that says what to do, for a user.
struct NameError {
  enum class Kind { malformed, unknown, ambiguous } kind = Kind::unknown;
  std::string text;
};

/// An immutable classified ontology over a compiled form. Movable, not copyable; safe to read from many threads.
/// Every string_view and span points into the compiled form and lives as long as the ontology.
///
/// The form has sections. What matching needs is verified when the file is mapped; labels and axioms when they are
/// first asked for, so that a start does not wait for them. If one of these sections is damaged there are no labels or
/// no axioms, and check_labels() and check_axioms() say why.
class Ontology {
 public:
  /// Maps a compiled file after checking its version, and the checksum and every number of its taxonomy. Linear in that
  /// section; nothing is parsed. Paths in the form are relative to its folder; files() gives them as seen from here.
  [[nodiscard]] static std::expected<Ontology, CompiledError> map(const std::string& path);
  /// The same for octets in memory. Paths of files stay as they are.
  [[nodiscard]] static std::expected<Ontology, CompiledError> from_bytes(std::vector<std::byte> bytes);

  Ontology(Ontology&&) noexcept;
  Ontology& operator=(Ontology&&) noexcept;
  ~Ontology();

  /// Whether labels and axioms are as they were written. They are verified by the first call. Linear in them.
  [[nodiscard]] std::expected<void, CompiledError> check_labels() const;
  [[nodiscard]] std::expected<void, CompiledError> check_axioms() const;
  /// Checks both.
  [[nodiscard]] std::expected<void, CompiledError> check_whole() const;

  /// A digest of the axioms and names: equal on every host that loaded the same ontologies, whatever their order or
  /// format.
  [[nodiscard]] std::uint64_t digest() const;
  [[nodiscard]] std::uint32_t class_count() const;
  [[nodiscard]] std::vector<owl::LoadedFile> files() const;
  /// One line for a user if a file that this was compiled from has changed since: "soma.owl has changed since this was
  /// compiled: compile it again". Files that are gone do not count. Reads the files, so that a copy or a checkout of
  /// the same content is no change.
  [[nodiscard]] std::optional<std::string> stale_source() const;
  [[nodiscard]] std::vector<owl::LeftOut> left_out() const;
  /// Why something may be missing although its axioms were used, one line each. If this and left_out() are empty, the
  /// taxonomy is complete.
  [[nodiscard]] std::vector<std::string> gaps() const;
  /// The number of different axioms, without declarations.
  [[nodiscard]] std::size_t axiom_count() const;
  /// Pairs of a prefix without its colon and an IRI, ascending.
  [[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> prefixes() const;
  /// False if some individual cannot exist; then every class is below every other.
  [[nodiscard]] bool is_consistent() const;

  /// Resolves `prefix:Name`, `<IRI>`, a bare IRI, or an unambiguous label, and if it is none of these a local name,
  /// which is what follows the last `#` or `/` of an IRI and must be unambiguous, too. The labels are read only if the
  /// name is no IRI; to look for a local name is linear in the classes.
  [[nodiscard]] std::expected<taxonomy::ClassNumber, NameError> find(std::string_view name) const;
  [[nodiscard]] std::optional<taxonomy::ClassNumber> find_iri(std::string_view iri) const;

  [[nodiscard]] std::string_view iri(taxonomy::ClassNumber number) const;
  /// The label, or an empty view. Reads the labels.
  [[nodiscard]] std::string_view label(taxonomy::ClassNumber number) const;
  /// `prefix:Name` if a prefix of the ontology fits, else `<IRI>`.
  [[nodiscard]] std::string short_name(taxonomy::ClassNumber number) const;
  /// The same for any IRI, whether it is that of a class or not.
  [[nodiscard]] std::string short_name(std::string_view iri) const;

  /// False if the class is subsumed by owl:Nothing.
  [[nodiscard]] bool is_satisfiable(taxonomy::ClassNumber number) const;
  /// Whether every instance of `sub` is one of `super`. Reflexive. O(1) to O(log n).
  [[nodiscard]] bool is_subsumed(taxonomy::ClassNumber sub, taxonomy::ClassNumber super) const {
    const std::uint32_t rank = reach_[static_cast<std::size_t>(sub)].first;
    const taxonomy::Reach& above = reach_[static_cast<std::size_t>(super)];
    // One comparison: ranks below the first wrap around to large numbers.
    const bool is_in_own = rank - above.first <= (above.extent & ~taxonomy::Reach::flag);
    const bool is_certain = is_in_own || ((rank | above.extent) & taxonomy::Reach::flag) == 0;
    return is_certain ? is_in_own : is_in_further(rank, above);
  }
  [[nodiscard]] bool is_equivalent(taxonomy::ClassNumber a, taxonomy::ClassNumber b) const {
    return is_subsumed(a, b) && is_subsumed(b, a);
  }
  /// The number of edges of the shortest path up from `sub` to `super`: 0 for equivalent classes, nothing if `sub` is
  /// not subsumed.
  [[nodiscard]] std::optional<std::uint32_t> distance(taxonomy::ClassNumber sub, taxonomy::ClassNumber super) const;
  /// Every named class that subsumes this one, including itself, its equivalents and owl:Thing, ascending by number.
  [[nodiscard]] std::vector<taxonomy::ClassNumber> subsumers(taxonomy::ClassNumber number) const;
  /// The direct superclasses and subclasses in the reduced taxonomy: one representative of each node, ascending.
  /// Unsatisfiable classes have none, and are children of none.
  [[nodiscard]] std::vector<taxonomy::ClassNumber> parents(taxonomy::ClassNumber number) const;
  [[nodiscard]] std::vector<taxonomy::ClassNumber> children(taxonomy::ClassNumber number) const;

  /// Which representation is declared to be turned into which (reasoning/owl/conversion.hpp).
  [[nodiscard]] std::span<const taxonomy::Conversion> conversions() const;
  /// The units that are declared (reasoning/owl/unit.hpp), and what was left out of them, by reason.
  [[nodiscard]] UnitsView units() const;
  [[nodiscard]] std::vector<owl::LeftOut> units_left_out() const;
  /// Two for each class, of its local name and of its label (similar.hpp). Empty if the form has none.
  [[nodiscard]] std::span<const std::uint64_t> signatures() const;
  /// The taxonomy as numbers, without terms and axioms.
  [[nodiscard]] const taxonomy::ClassifiedView& view() const;
  /// The taxonomy with terms and axioms, for reasoning over them. Without them if check_axioms() fails.
  [[nodiscard]] const taxonomy::ClassifiedView& axioms() const;
  /// Leads from names to axioms(). Cheap: it is part of the compiled form.
  [[nodiscard]] modules::ModuleIndex module_index() const;

 private:
  struct Mapped;
  explicit Ontology(std::unique_ptr<const Mapped> mapped);
  /// With their places as files() has them.
  [[nodiscard]] std::vector<owl::LeftOut> placed(std::vector<owl::LeftOut> left_out) const;
  /// Whether a rank lies in the further intervals. An unsatisfiable class lies below everything.
  [[nodiscard]] bool is_in_further(std::uint32_t rank, const taxonomy::Reach& above) const {
    return (rank & taxonomy::Reach::flag) != 0 ||
           taxonomy::contains_rank({further_ + above.further_begin, further_ + above.further_end}, rank);
  }

  std::unique_ptr<const Mapped> mapped_;
  const taxonomy::Reach* reach_ = nullptr;  ///< of each class, in what mapped_ holds
  const taxonomy::Interval* further_ = nullptr;
};

}  // namespace geminga::compiled

#endif
