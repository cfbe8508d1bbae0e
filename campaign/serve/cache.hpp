#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <string>

#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// Replies that are valid until the database changes. A reply is made once, even if many ask for it
/// at the same time.
class Cache {
 public:
  /// The reply of this key. `make` makes it where this generation has none. Exceptions of `make`
  /// reach all who wait for the reply.
  Reply reply(std::uint64_t generation, const std::string& key, const std::function<Reply()>& make);

 private:
  std::mutex mutex_;
  std::uint64_t generation_ = 0;
  std::map<std::string, std::shared_future<Reply>> replies_;
};

}  // namespace eerie::serve
