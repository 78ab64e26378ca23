// Files packed by gzip: how they are recognised, and their names without .gz.
#ifndef GEMINGA_REASONING_SYNTAX_INFLATE_HPP
#define GEMINGA_REASONING_SYNTAX_INFLATE_HPP

#include <expected>
#include <string>
#include <string_view>

#include "reasoning/syntax/files.hpp"

namespace geminga::syntax {

/// Whether a file begins as gzip writes it (RFC 1952, section 2.3.1). No syntax of ontologies begins so.
[[nodiscard]] bool is_gzip(std::string_view content);

/// "pizza.owl" of "pizza.owl.gz"; any other name as it is.
[[nodiscard]] std::string_view name_without_gz(std::string_view path);

/// Unpacks a gzip file into memory that grows with it. A file that would grow beyond the limits takes no more than
/// these before it is refused. An error names the octet of the packed file. The packed octets are released as they are
/// used.
[[nodiscard]] std::expected<FileBytes, LoadError> inflate(const std::string& path, FileBytes& packed,
                                                          const FileLimits& limits);

}  // namespace geminga::syntax

#endif
