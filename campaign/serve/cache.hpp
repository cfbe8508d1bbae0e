#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <string>

#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// Replies that hold until the database changes. However many ask for one at a time, it is made
/// once.
class Cache {
 public:
  /// The reply of this key, made by `make` where the generation has none. What `make` throws goes
  /// to all who wait for it.
  Reply reply(std::uint64_t generation, const std::string& key, const std::function<Reply()>& make);

 private:
  std::mutex mutex_;
  std::uint64_t generation_ = 0;
  std::map<std::string, std::shared_future<Reply>> replies_;
};

}  // namespace eerie::serve
