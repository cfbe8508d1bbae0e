#include "campaign/results/run_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "campaign/text/csv_table.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::results {
namespace fs = std::filesystem;

namespace {

/// A line of the table by the names of its columns.
class Line {
 public:
  Line(const text::CsvTable& table, const text::CsvTable::Row& row, const std::string& file)
      : table_(table), row_(row), file_(file) {}

  /// Empty where the table has no such column.
  std::string text(const std::string& column) const {
    const auto at = std::ranges::find(table_.header, column);
    return at == table_.header.end()
               ? ""
               : row_.fields[static_cast<std::size_t>(at - table_.header.begin())];
  }
  std::string needed(const std::string& column) const {
    std::string value = text(column);
    if (value.empty()) refuse(column, "must not be empty");
    return value;
  }
  /// Nothing where the field is empty.
  std::optional<double> number(const std::string& column, double least, double most) const {
    const std::string field = text(column);
    if (field.empty()) return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(field.c_str(), &end);
    if (end != field.c_str() + field.size() || !(value >= least && value <= most))
      refuse(column, fmt::format("must be a number from {:g} to {:g}", least, most));
    return value;
  }
  std::string hash() const {
    std::string value = needed("hash");
    const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    if (value.size() != 64 || !std::ranges::all_of(value, is_digit))
      refuse("hash", "must be the 64 hexadecimal digits of a scene's hash");
    return value;
  }

 private:
  [[noreturn]] void refuse(const std::string& column, const std::string& why) const {
    throw InputError(
        fmt::format("{}, line {}: {} = \"{}\": {}; give the table as `eerie converge` or "
                    "`eerie chart` wrote it",
                    file_, row_.line, column, text(column), why));
  }

  const text::CsvTable& table_;
  const text::CsvTable::Row& row_;
  const std::string& file_;
};

constexpr double any = 1e300;

/// Those with columns, whose names end with `when`.
std::vector<db::Remnant> remnants_of(const Line& line, const std::string& when) {
  std::vector<db::Remnant> remnants;
  for (int rank = 1;; ++rank) {
    const auto column = [&](const char* name) {
      return fmt::format(fmt::runtime(name), rank) + when;
    };
    const auto mass = line.number(column("m_{}_over_m_total"), 0, 1);
    if (!mass) return remnants;
    db::Remnant remnant{.rank = rank, .mass_over_total = *mass};
    remnant.b_over_a = line.number(column("b_over_a_{}"), 0, 1);
    remnant.c_over_a = line.number(column("c_over_a_{}"), 0, 1);
    remnant.spin_period_h = line.number(column("period_{}_h"), 0, any);
    remnants.push_back(remnant);
  }
}

RunRecord record_of(const Line& line) {
  RunRecord record;
  db::Result& x = record.result;
  x.outcome_class = line.needed("class");
  x.settled = line.number("settled", 0, 1).value_or(0) == 1;
  x.ended_at_s = line.number("ended_at_s", 0, any);
  x.end_reason = line.text("end_reason");
  x.m_lr_over_m_total = line.number("m_lr_over_m_total", 0, 1).value_or(0);
  x.m_slr_over_m_total = line.number("m_slr_over_m_total", 0, 1).value_or(0);
  x.n_eer = static_cast<int>(line.number("n_eer", 0, 1e6).value_or(0));
  x.dL_over_L = line.number("dL_over_L", 0, any);
  x.particle_steps = line.number("particle_steps", 0, any).value_or(0);
  x.solver_version = line.text("solver_version");
  record.core_seconds = line.number("core_s", 0, any);
  record.remnants = remnants_of(line, "");
  record.at_published = remnants_of(line, "_at_published");
  record.published_at_s = line.number("published_at_s", 0, any);
  if (!record.remnants.empty()) {
    x.b_over_a = record.remnants[0].b_over_a;
    x.c_over_a = record.remnants[0].c_over_a;
    x.period_h = record.remnants[0].spin_period_h;
  }
  return record;
}

}  // namespace

RunRecords read_run_records(const std::vector<fs::path>& tables) {
  RunRecords records;
  for (const fs::path& path : tables) {
    const std::string file = path.string();
    const text::CsvTable table = text::parse_csv(read_file(path), file);
    for (const text::CsvTable::Row& row : table.rows) {
      const Line line(table, row, file);
      records.insert_or_assign(line.hash(), record_of(line));
    }
  }
  return records;
}

}  // namespace eerie::results
