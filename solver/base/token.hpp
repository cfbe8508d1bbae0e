#pragma once

#include <cstddef>
#include <string>
#include <variant>

#include "solver/base/error.hpp"

namespace eerie {

/// Makes the alternative of a variant whose `token` is the given one, from `arguments`. Throws
/// InputError, which names `field`, where no alternative has that token.
template <class Variant, std::size_t I = 0, class... Arguments>
Variant make_by_token(const std::string& field, const std::string& token,
                      const Arguments&... arguments) {
  if constexpr (I == std::variant_size_v<Variant>) {
    throw InputError(field + ": unknown name \"" + token + "\"");
  } else {
    using T = std::variant_alternative_t<I, Variant>;
    if (token == T::token) return T(arguments...);
    return make_by_token<Variant, I + 1>(field, token, arguments...);
  }
}

}  // namespace eerie
