#include "campaign/catalogue/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <span>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"

namespace eerie::catalogue {
namespace {

constexpr double earth_mass_kg = 5.9722e24;  // IAU 2015 B3 nominal GM over CODATA 2018 G

constexpr Unit masses[] = {{"kg"},
                           {"g", -3},
                           {"m_earth", 0, earth_mass_kg},
                           {"mearth", 0, earth_mass_kg},
                           {"m_oplus", 0, earth_mass_kg}};
constexpr Unit speeds[] = {{"m_per_s"}, {"m_s"},      {"ms"},           {"km_per_s", 3},
                           {"km_s", 3}, {"kms", 3},   {"cm_per_s", -2}, {"cm_s", -2},
                           {"m_s_1"},   {"km_s_1", 3}};
constexpr Unit angles[] = {{"deg"}, {"degree"}, {"degrees"}, {"rad", 0, 180 / pi}};
constexpr Unit lengths[] = {{"m"}, {"km", 3}, {"cm", -2}};
constexpr Unit densities[] = {{"kg_per_m3"},    {"kg_m3"},    {"kg_m_3"},
                              {"g_per_cm3", 3}, {"g_cm3", 3}, {"g_cm_3", 3}};
constexpr Unit none[] = {{""}};

/// Names of a quantity: the first is ours, the others stand in publications (Leinhardt & Stewart
/// 2012; Cambioni et al. 2019; Gabriel et al. 2020; Timpe et al. 2020; Emsenhuber et al. 2024).
/// Lower case, without underscores.
struct Entry {
  CatalogueQuantity quantity;
  const char* name;
  std::span<const Unit> units;
  std::vector<std::string_view> others;
};

const std::vector<Entry>& entries() {
  using enum CatalogueQuantity;
  static const std::vector<Entry> all = {
      {run_id, "run_id", none, {"id", "run", "name", "model", "simulation"}},
      {v_imp,
       "v_imp",
       speeds,
       {"vi", "vcoll", "vimpact", "impactvelocity", "impactspeed", "collisionvelocity"}},
      {v_imp_over_v_esc,
       "v_imp_over_v_esc",
       none,
       {"viovervesc", "vcollovervesc", "vovervesc", "vimpactovervesc"}},
      {theta_imp,
       "theta_imp",
       angles,
       {"theta", "thetacoll", "impactangle", "collisionangle", "angle"}},
      {b, "b", none, {"impactparameter"}},
      {m_target, "m_target", masses, {"mtarg", "mtar", "targetmass"}},
      {m_projectile,
       "m_projectile",
       masses,
       {"mproj", "mp", "mimpactor", "mimp", "projectilemass", "impactormass"}},
      {m_total, "m_total", masses, {"mtot", "totalmass"}},
      {q,
       "q",
       none,
       {"gamma", "massratio", "mprojectileovermtarget", "mprojovermtarg", "mpovermtarg",
        "mimpovermtar"}},
      {r_target, "r_target", lengths, {"rtarg", "rtar", "targetradius"}},
      {rho, "rho", densities, {"rho0", "density", "bulkdensity", "targetdensity"}},
      {phi_d, "phi_d", angles, {"frictionangle", "phi"}},
      {m_lr, "m_lr", masses, {"largestremnantmass", "masslargestremnant"}},
      {m_slr, "m_slr", masses, {"secondlargestremnantmass", "masssecondlargestremnant"}},
      {m_lr_over_m_total, "m_lr_over_m_total", none, {"mlrovermtot"}},
      {m_slr_over_m_total, "m_slr_over_m_total", none, {"mslrovermtot"}},
      {accretion_efficiency, "accretion_efficiency", none, {"xi", "xil"}},
      {outcome_class, "class", none, {"outcome", "outcomeclass", "regime"}},
      {b_over_a, "b_over_a", none, {}},
      {seed, "seed", none, {}},
      {fidelity, "fidelity", none, {}},
  };
  return all;
}

/// "M_targ (kg)" as "m_targ_kg", "$V_{i}/V_{esc}$" as "v_i_over_v_esc", "km/s" in brackets as
/// "km_per_s".
std::string plain(const std::string& header) {
  std::string text;
  bool in_unit = false;
  const std::size_t degree = header.find("\u00b0");
  if (degree != std::string::npos)
    return plain(header.substr(0, degree) + "deg" + header.substr(degree + 2));
  for (const char letter : header) {
    const auto c = static_cast<unsigned char>(letter);
    if (c == '[' || c == '(') in_unit = true;
    if (c == '/')
      text += in_unit ? "_per_" : "_over_";
    else if (std::isalnum(c) != 0)
      text += static_cast<char>(std::tolower(c));
    else if (c != '$' && c != '{' && c != '}' && c != '\\' && c != '^' && !text.empty() &&
             text.back() != '_')
      text += '_';
  }
  while (text.ends_with('_')) text.pop_back();
  return text;
}

std::string without_underscores(const std::string& text) {
  std::string bare;
  for (const char c : text)
    if (c != '_') bare += c;
  return bare;
}

const Entry* entry_named(const std::string& name) {
  const std::string bare = without_underscores(name);
  for (const Entry& entry : entries()) {
    if (bare == without_underscores(entry.name)) return &entry;
    for (const std::string_view other : entry.others)
      if (bare == other) return &entry;
  }
  return nullptr;
}

}  // namespace

std::string column_name(CatalogueQuantity quantity) {
  for (const Entry& entry : entries())
    if (entry.quantity == quantity)
      return entry.units.front().name.empty()
                 ? std::string(entry.name)
                 : fmt::format("{}_{}", entry.name, entry.units.front().name);
  return "";
}

std::optional<CatalogueColumn> column_of(const std::string& header, const std::string& where) {
  const std::string whole = plain(header);
  // The unit is what is left behind a name, the shortest such rest first.
  for (std::size_t end = whole.size(); end != std::string::npos && end > 0;
       end = whole.rfind('_', end - 1)) {
    const Entry* entry = entry_named(whole.substr(0, end));
    if (entry == nullptr) continue;
    const std::string unit = end == whole.size() ? "" : whole.substr(end + 1);
    for (const Unit& known : entry->units)
      if (known.name == unit) return CatalogueColumn{entry->quantity, known};
    if (!unit.empty()) continue;
    std::string units;
    for (const Unit& known : entry->units)
      units += fmt::format("{}{}", units.empty() ? "" : ", ", known.name);
    throw InputError(fmt::format("{}: column {} has no unit; call it {} (known units: {})", where,
                                 header, column_name(entry->quantity), units));
  }
  return std::nullopt;
}

std::optional<double> value_of(const std::string& field, const Unit& unit, int decimals) {
  // No words, no hexadecimal digits: strtod takes both.
  if (field.find_first_not_of("0123456789+-.eE") != std::string::npos) return std::nullopt;
  const char* begin = field.c_str();
  char* end = nullptr;
  std::strtod(begin, &end);
  if (end == begin || *end != '\0') return std::nullopt;
  // Where the field has an exponent the point moves on from there.
  const std::size_t e = field.find_first_of("eE");
  const long exponent = e == std::string::npos
                            ? 0
                            : std::clamp(std::strtol(begin + e + 1, nullptr, 10), -9999L, 9999L);
  const std::string text =
      fmt::format("{}e{}", field.substr(0, e), exponent + unit.decimals + decimals);
  const double value = std::strtod(text.c_str(), nullptr) * unit.factor;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string moved(double value, int decimals) {
  std::string text;  // "d.ddde+XX", the shortest that reads back as the value
  for (int digits = 0; digits <= 17; ++digits) {
    text = fmt::format("{:.{}e}", value, digits);
    if (std::strtod(text.c_str(), nullptr) == value) break;
  }
  const std::size_t e = text.find('e');
  const int exponent = std::atoi(text.c_str() + e + 1) + decimals;
  const bool negative = text[0] == '-';
  std::string digits;
  for (const char c : text.substr(0, e))
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) digits += c;
  const std::string sign = negative ? "-" : "";
  if (exponent < -5 || exponent > 15)
    return fmt::format("{}{}{}{}e{}", sign, digits[0], digits.size() > 1 ? "." : "",
                       digits.substr(1), exponent);
  if (exponent < 0)
    return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0');
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

}  // namespace eerie::catalogue
