// A reader of the parameters of one statement: takes each by its key, once, and says what is wrong with them.
#ifndef GEMINGA_DISCOVERY_GCNP_KEY_READER_HPP
#define GEMINGA_DISCOVERY_GCNP_KEY_READER_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/statement.hpp"
#include "geminga/error.hpp"
#include "geminga/match.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::gcnp {

/// Each function takes a key if it is there, and returns nothing if it is not. error() keeps the first error; later
/// ones do not matter. Borrows the statement for its life.
class KeyReader {
 public:
  explicit KeyReader(const Statement& statement);

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  /// Keeps the error unless there is one already.
  void fail(ErrorCode code, std::string text);
  /// 400 unless `is_there`: "KEY is missing: HINT".
  void require(bool is_there, std::string_view key, std::string_view hint);

  std::optional<std::string> text(std::string_view key, std::size_t max_bytes);
  std::optional<std::uint32_t> number(std::string_view key);
  std::optional<std::int32_t> priority();
  std::optional<std::uint16_t> port();
  /// A numeric IP address that can be sent to, or an empty text; else 422.
  std::optional<std::string> address();
  std::optional<ChannelMode> mode();
  std::optional<Degree> degree(std::string_view key);
  /// The largest cost of `convert=yes|no|COST`.
  std::optional<std::uint32_t> conversion();
  /// `reach=routed|any`.
  std::optional<RequiredReach> reach();
  std::optional<std::vector<ProviderFilter>> providers(std::string_view key);
  /// Words with commas; none for the empty value.
  std::optional<std::vector<std::string>> protocols();
  std::optional<ServiceKey> service_key(std::string_view key);
  /// `key=yes` is true, `key=no` false.
  std::optional<bool> answer(std::string_view key);
  /// `key` or `key=1` is true, `key=0` and no key false.
  bool flag(std::string_view key);
  /// At most one of `id`, `text`, and `concept` with or without `representation`.
  std::optional<IdentityChange> identity_change();
  std::optional<NamedIdentity> identity();
  /// Takes the parameters whose keys begin with this prefix: a statement of their own, without the prefix.
  Statement behind(std::string_view prefix);
  /// Takes every key that is left as an attribute (attribute_name()). Call it after all others.
  Attributes attributes();
  /// The same for a publication: `converts=FROM>TO` is an attribute, too, although it is a slip of `convert`.
  Attributes offered_attributes();
  /// Whether every key has been taken.
  [[nodiscard]] bool is_empty() const { return std::ranges::find(taken_, false) == taken_.end(); }
  /// 400 if a key is left, with the key of this statement that it is a slip of.
  void finish();

 private:
  /// The parameter with this key, marked as taken.
  const Parameter* take(std::string_view key);
  /// The value of a key that must have one.
  std::optional<std::string_view> value(std::string_view key);
  void fail_value(std::string_view key, std::string_view expected);
  /// The attribute that a remaining key states, or nothing and an error.
  std::optional<std::string> attribute(std::string_view key);
  bool may_convert_ = false;  ///< `converts` is an attribute

  const Statement& statement_;
  std::vector<bool> taken_;
  std::vector<std::string_view> asked_;  ///< every key that was looked for, there or not
  std::optional<Error> error_;
};

}  // namespace geminga::gcnp

#endif
