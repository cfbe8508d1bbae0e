#pragma once

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace eerie::test {

/// The alternatives of a std::variant as a list for typed tests, so that a new entry of the
/// variant is tested without another line.
template <class Variant>
struct TypesOf;
template <class... T>
struct TypesOf<std::variant<T...>> {
  using type = testing::Types<T...>;
};
template <class Variant>
using AlternativesOf = typename TypesOf<Variant>::type;

/// Names typed tests by the token of the type under test.
struct NameByToken {
  template <class T>
  static std::string GetName(int) {
    std::string name = T::token;
    for (char& c : name)
      if (c == '-') c = '_';
    return name;
  }
};

}  // namespace eerie::test
