#pragma once

#include <SQLiteCpp/Statement.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "db/store/error.hpp"

namespace eerie::db {

inline std::optional<std::string> null_if_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// Binds a value to the parameter `index`. An empty optional becomes NULL.
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

/// Resets the statement and binds its parameters 1, 2, ... in order.
template <class... Values>
void bind_all(SQLite::Statement& statement, const Values&... values) {
  statement.reset();
  statement.clearBindings();
  int index = 0;
  (bind_value(statement, ++index, values), ...);
}

/// The conditions of a filter on the point of a job: one per field that is set, each with its own
/// named parameter.
template <class Filter>
std::string point_conditions(const Filter& f) {
  std::string text;
  if (f.q) text += " AND q = :q";
  if (f.phi_d_deg) text += " AND phi_d_deg = :phi_d";
  if (f.v_imp_cm_per_s) text += " AND v_imp_cm_per_s BETWEEN :v_lo AND :v_hi";
  if (f.theta_imp_deg) text += " AND theta_imp_deg BETWEEN :theta_lo AND :theta_hi";
  return text;
}
template <class Filter>
void bind_point(SQLite::Statement& statement, const Filter& f) {
  if (f.q) statement.bind(":q", *f.q);
  if (f.phi_d_deg) statement.bind(":phi_d", *f.phi_d_deg);
  if (f.v_imp_cm_per_s) {
    statement.bind(":v_lo", f.v_imp_cm_per_s->lo);
    statement.bind(":v_hi", f.v_imp_cm_per_s->hi);
  }
  if (f.theta_imp_deg) {
    statement.bind(":theta_lo", f.theta_imp_deg->lo);
    statement.bind(":theta_hi", f.theta_imp_deg->hi);
  }
}

/// The name of an enumerator by its table, and the enumerator of a name.
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
