#include "campaign/serve/cache.hpp"

namespace eerie::serve {
namespace {
constexpr std::size_t most = 256;
}

Reply Cache::reply(std::uint64_t generation, const std::string& key,
                   const std::function<Reply()>& make) {
  std::promise<Reply> promise;
  std::shared_future<Reply> future;
  bool mine = false;
  {
    const std::lock_guard lock(mutex_);
    if (generation != generation_ || replies_.size() >= most) replies_.clear();
    generation_ = generation;
    const auto found = replies_.find(key);
    mine = found == replies_.end();
    if (mine)
      replies_[key] = future = promise.get_future().share();
    else
      future = found->second;
  }
  if (!mine) return future.get();
  try {
    promise.set_value(make());
  } catch (...) {
    promise.set_exception(std::current_exception());
    const std::lock_guard lock(mutex_);
    if (generation == generation_) replies_.erase(key);  // a fault may pass
  }
  return future.get();
}

}  // namespace eerie::serve
