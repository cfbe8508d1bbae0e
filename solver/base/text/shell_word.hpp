#pragma once

#include <string>

namespace eerie {

/// A word that a shell takes as it stands: quoted ('it'\''s') where it has other letters than
/// those which no shell reads in its own way.
std::string shell_word(const std::string& text);

}  // namespace eerie
