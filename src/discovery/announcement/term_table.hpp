// The tables of namespaces and terms of one datagram while it is written: each IRI costs its octets once.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_TERM_TABLE_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_TERM_TABLE_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::announcement {

/// An IRI split behind its last `#` or `/`; without either the namespace is empty.
struct SplitIri {
  std::string_view name_space;
  std::string_view local;
};
[[nodiscard]] SplitIri split_iri(std::string_view iri);

/// The octets of a field with a one-octet or two-octet tag and a length before its content.
[[nodiscard]] std::size_t framed_bytes(std::size_t tag_bytes, std::size_t content_bytes);

/// Numbers IRIs in the order of their first use. Look-ups are linear: a datagram holds some dozens of terms.
class TermTable {
 public:
  struct Term {
    std::uint32_t name_space = 0;  ///< counted from 1; 0: the empty one
    std::string local;
  };

  /// The number of a term, counted from 1; adds a new one. The empty IRI is 0.
  std::uint32_t number(std::string_view iri);
  /// The octets of the tables in a datagram.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// A mark to go back to when an entry does not fit.
  struct Mark {
    std::size_t name_spaces = 0;
    std::size_t terms = 0;
    std::size_t bytes = 0;
  };
  [[nodiscard]] Mark mark() const { return {name_spaces_.size(), terms_.size(), bytes_}; }
  void go_back(const Mark& mark);

  [[nodiscard]] const std::vector<std::string>& name_spaces() const { return name_spaces_; }
  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }

 private:
  std::uint32_t name_space_number(std::string_view name_space);

  std::vector<std::string> name_spaces_;
  std::vector<Term> terms_;
  std::size_t bytes_ = 0;
};

}  // namespace geminga::announcement

#endif
