#pragma once

#include <cstdint>
#include <string>

namespace eerie::drawing {

/// A whole number as figures show it: 12500 as "12,500".
std::string grouped(std::int64_t number);

}  // namespace eerie::drawing
