#pragma once

#include <SQLiteCpp/Statement.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "db/error.hpp"

namespace eerie::db {

inline std::optional<std::string> null_if_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// One value to the parameter `index`; an empty optional becomes NULL.
template <class T>
void bind_value(SQLite::Statement& statement, int index, const T& value) {
  if constexpr (requires { value.has_value(); }) {
    if (value.has_value())
      bind_value(statement, index, *value);
    else
      statement.bind(index);
  } else if constexpr (std::integral<T>) {
    statement.bind(index, static_cast<std::int64_t>(value));
  } else if constexpr (std::floating_point<T>) {
    statement.bind(index, static_cast<double>(value));
  } else {
    statement.bind(index, std::string(value));
  }
}

/// Resets the statement and binds the parameters 1, 2, ... in order.
template <class... Values>
void bind_all(SQLite::Statement& statement, const Values&... values) {
  statement.reset();
  statement.clearBindings();
  int index = 0;
  (bind_value(statement, ++index, values), ...);
}

/// Name of an enumerator in its table, and back.
template <class E, std::size_t n>
std::string name(const std::array<std::string_view, n>& names, E value) {
  return std::string(names.at(static_cast<std::size_t>(value)));
}
template <class E, std::size_t n>
E enumerator(const std::array<std::string_view, n>& names, const std::string& text) {
  for (std::size_t i = 0; i < n; ++i)
    if (names[i] == text) return static_cast<E>(i);
  throw Error("the database holds the unknown word \"" + text + "\"");
}

}  // namespace eerie::db
