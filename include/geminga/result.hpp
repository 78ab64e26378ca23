// The result of a call that can fail: a value or an error, as std::expected of C++23 for programs in C++20.
#ifndef GEMINGA_RESULT_HPP
#define GEMINGA_RESULT_HPP

#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>
#include <version>
#ifdef __cpp_lib_expected
#include <expected>
#endif

namespace geminga {

/// Turns into any result with this kind of error: `return Failure(error);`
template <typename Error>
struct Failure {
  explicit Failure(Error failed) : error(std::move(failed)) {}
  Error error;
};

/// The exception of value() where there is no value.
class NoValue : public std::logic_error {
 public:
  NoValue() : std::logic_error("a geminga::Result has an error where its value was asked for") {}
};

/// A value or an error, with the names and meanings of std::expected. In C++23 it converts from and to one. `*` and
/// `->` require a value, error() an error.
template <typename Value, typename Error>
class [[nodiscard]] Result {
  static constexpr bool is_void = std::is_void_v<Value>;
  using Held = std::conditional_t<is_void, std::monostate, Value>;

 public:
  using value_type = Value;
  using error_type = Error;

  Result()
    requires std::is_default_constructible_v<Held>
      : held_(std::in_place_index<0>) {}
  template <typename Given = Held>
    requires(!is_void && !std::is_same_v<std::remove_cvref_t<Given>, Result> && std::is_convertible_v<Given &&, Held>)
  Result(Given&& value) : held_(std::in_place_index<0>, std::forward<Given>(value)) {}
  template <typename Given>
    requires std::is_convertible_v<Given, Error>
  Result(Failure<Given> failure) : held_(std::in_place_index<1>, std::move(failure.error)) {}

  [[nodiscard]] bool has_value() const noexcept { return held_.index() == 0; }
  explicit operator bool() const noexcept { return has_value(); }

  [[nodiscard]] Held& operator*() & noexcept
    requires(!is_void)
  {
    return *std::get_if<0>(&held_);
  }
  [[nodiscard]] const Held& operator*() const& noexcept
    requires(!is_void)
  {
    return *std::get_if<0>(&held_);
  }
  [[nodiscard]] Held&& operator*() && noexcept
    requires(!is_void)
  {
    return std::move(*std::get_if<0>(&held_));
  }
  void operator*() const& noexcept
    requires is_void
  {}
  [[nodiscard]] Held* operator->() noexcept
    requires(!is_void)
  {
    return std::get_if<0>(&held_);
  }
  [[nodiscard]] const Held* operator->() const noexcept
    requires(!is_void)
  {
    return std::get_if<0>(&held_);
  }

  /// The value; throws NoValue where there is none.
  decltype(auto) value() & { return checked().operator*(); }
  decltype(auto) value() const& { return checked().operator*(); }
  decltype(auto) value() && { return std::move(checked()).operator*(); }

  template <typename Other>
    requires(!is_void)
  [[nodiscard]] Held value_or(Other&& other) const& {
    return has_value() ? **this : static_cast<Held>(std::forward<Other>(other));
  }
  template <typename Other>
    requires(!is_void)
  [[nodiscard]] Held value_or(Other&& other) && {
    return has_value() ? std::move(**this) : static_cast<Held>(std::forward<Other>(other));
  }

  [[nodiscard]] Error& error() & noexcept { return *std::get_if<1>(&held_); }
  [[nodiscard]] const Error& error() const& noexcept { return *std::get_if<1>(&held_); }
  [[nodiscard]] Error&& error() && noexcept { return std::move(*std::get_if<1>(&held_)); }

  friend bool operator==(const Result&, const Result&) = default;

#ifdef __cpp_lib_expected
  template <typename Given>
    requires std::is_convertible_v<Given, Error>
  Result(std::unexpected<Given> failure) : held_(std::in_place_index<1>, std::move(failure).error()) {}
  Result(std::expected<Value, Error> other)
      : held_(other ? std::variant<Held, Error>(std::in_place_index<0>, held_of(other))
                    : std::variant<Held, Error>(std::in_place_index<1>, std::move(other.error()))) {}
  operator std::expected<Value, Error>() const& { return Result(*this).as_expected(); }
  operator std::expected<Value, Error>() && { return std::move(*this).as_expected(); }
#endif

 private:
  Result& checked() & {
    if (!has_value()) throw NoValue();
    return *this;
  }
  const Result& checked() const& {
    if (!has_value()) throw NoValue();
    return *this;
  }
  Result&& checked() && {
    if (!has_value()) throw NoValue();
    return std::move(*this);
  }

#ifdef __cpp_lib_expected
  static Held held_of(std::expected<Value, Error>& other) {
    if constexpr (is_void) {
      return {};
    } else {
      return std::move(*other);
    }
  }
  std::expected<Value, Error> as_expected() && {
    if (!has_value()) return std::unexpected(std::move(*this).error());
    if constexpr (is_void) {
      return {};
    } else {
      return std::move(**this);
    }
  }
#endif

  std::variant<Held, Error> held_;
};

}  // namespace geminga

#endif
