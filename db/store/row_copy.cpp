#include "db/store/row_copy.hpp"

#include <SQLiteCpp/Database.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>

namespace eerie::db {
namespace {

std::vector<std::string> other_columns(SQLite::Database& sql, const RowCopy::Rule& rule) {
  std::vector<std::string> left_out = rule.left_out;
  left_out.push_back(rule.key);
  return table_columns(sql, rule.table, left_out);
}

}  // namespace

std::vector<std::string> table_columns(SQLite::Database& sql, const std::string& table,
                                       const std::vector<std::string>& left_out) {
  SQLite::Statement select(sql, "SELECT name FROM pragma_table_info(?) ORDER BY cid");
  select.bind(1, table);
  std::vector<std::string> names;
  while (select.executeStep())
    if (std::string name = select.getColumn(0).getString();
        std::ranges::find(left_out, name) == left_out.end())
      names.push_back(std::move(name));
  return names;
}

void bind_column(SQLite::Statement& statement, const std::string& name,
                 const SQLite::Column& value) {
  const std::string parameter = ":" + name;
  switch (value.getType()) {
    case SQLITE_INTEGER:
      return statement.bind(parameter, value.getInt64());
    case SQLITE_FLOAT:
      return statement.bind(parameter, value.getDouble());
    case SQLITE_NULL:
      return statement.bind(parameter);
    default:
      return statement.bind(parameter, value.getString());
  }
}

RowCopy::RowCopy(SQLite::Database& from, SQLite::Database& to, const Rule& rule)
    : key_(rule.key),
      columns_(other_columns(from, rule)),
      select_(from, fmt::format("SELECT {} FROM {} WHERE {} = ? AND {}", fmt::join(columns_, ", "),
                                rule.table, rule.key, rule.which)),
      insert_(to, fmt::format("INSERT INTO {0} ({1}, {2}) SELECT :{1}, :{3} WHERE NOT ({4})",
                              rule.table, rule.key, fmt::join(columns_, ", "),
                              fmt::join(columns_, ", :"), rule.unless)) {}

std::size_t RowCopy::operator()(std::int64_t source, std::int64_t target) {
  std::size_t copied = 0;
  select_.reset();
  select_.bind(1, source);
  while (select_.executeStep()) {
    insert_.reset();
    insert_.bind(":" + key_, target);
    for (std::size_t k = 0; k < columns_.size(); ++k)
      bind_column(insert_, columns_[k], select_.getColumn(static_cast<int>(k)));
    copied += static_cast<std::size_t>(insert_.exec());
  }
  return copied;
}

}  // namespace eerie::db
