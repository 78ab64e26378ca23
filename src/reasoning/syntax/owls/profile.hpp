// The types of inputs and outputs in OWL-S descriptions of services.
//
// OWL-S 1.1 (W3C Member Submission, 22 November 2004), sections 4 and 5: a profile names its parameters, and the type
// of a parameter is the IRI of a class, as a literal.
#ifndef GEMINGA_REASONING_SYNTAX_OWLS_PROFILE_HPP
#define GEMINGA_REASONING_SYNTAX_OWLS_PROFILE_HPP

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/limits.hpp"

namespace geminga::owls {

/// The most parameters of one side of a profile.
inline constexpr std::size_t max_parameters = 64;
/// The most profiles of one file.
inline constexpr std::size_t max_profiles = 10'000;

/// A service, or a request in the form of one. A parameter is the IRI of its type without white space; empty where the
/// file does not say it.
struct Profile {
  std::string iri;  ///< empty for a blank node
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
};

/// One file.
struct Document {
  std::vector<Profile> profiles;     ///< in the order of the file; empty where it is no description of a service
  std::vector<std::string> imports;  ///< IRIs of ontologies
  std::optional<syntax::LoadError> broken_off;  ///< where reading ended before the end of the file
};

/// Reads a file as rdf::read_tolerantly() does. Words of OWL-S are known by their local names and by the names of its
/// ontologies, wherever these are published and in whatever version. A file without a profile but with a process is
/// read as if that were its profile. More parameters or profiles than the limits are an error.
[[nodiscard]] std::expected<Document, syntax::LoadError> read_profiles(const std::string& path,
                                                                       const syntax::FileLimits& limits = {});

}  // namespace geminga::owls

#endif
