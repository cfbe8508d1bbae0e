#pragma once

#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <string>
#include <vector>

namespace eerie::db {

/// The columns of a table, in its order, without `left_out`.
std::vector<std::string> table_columns(SQLite::Database& sql, const std::string& table,
                                       const std::vector<std::string>& left_out = {});

/// Binds the value of a column, of whatever type it is, to the parameter ":NAME".
void bind_column(SQLite::Statement& statement, const std::string& name,
                 const SQLite::Column& value);

/// Copies the rows of a table that belong to a row of another one, from database to database. Every
/// column of the table goes with them, also those of later schemas.
class RowCopy {
 public:
  struct Rule {
    std::string table;
    std::string key;                         ///< the column that names the other row
    std::vector<std::string> left_out = {};  ///< columns that the target fills in itself
    std::string which = "1";                 ///< condition on rows of the source
    std::string unless = "0";  ///< condition, with ":COLUMN", on which nothing is copied
  };
  RowCopy(SQLite::Database& from, SQLite::Database& to, const Rule& rule);

  /// Copies the rows of `source`, which then belong to `target`. Returns their number.
  std::size_t operator()(std::int64_t source, std::int64_t target);

 private:
  std::string key_;
  std::vector<std::string> columns_;  ///< without the key
  SQLite::Statement select_, insert_;
};

}  // namespace eerie::db
