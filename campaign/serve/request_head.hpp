#pragma once

#include <cstddef>
#include <string_view>

#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// Reads the head of a request while it arrives, and refuses whatever two readers could understand
/// in two ways: lines that end otherwise than in CR LF, control characters, blanks in an address,
/// unknown methods, folded fields. Each byte is looked at once.
class RequestHead {
 public:
  static constexpr std::size_t most_bytes = 1 << 15, longest_line = 8190;
  enum class State { incomplete, complete, refused };

  /// `bytes` are all that came of this request: those of the last call and what followed.
  State look(std::string_view bytes);
  /// Why it is refused: 400, 414 (address too long) or 431 (fields too large).
  const Reply& refusal() const { return refusal_; }

 private:
  State refused(int status, const char* why);
  State line(std::string_view text);

  std::size_t seen_ = 0, line_ = 0;  ///< bytes looked at; where the present line begins
  Reply refusal_ = {};
};

}  // namespace eerie::serve
