#include "campaign/serve/dashboard.hpp"

#include <fmt/format.h>

#include "campaign/serve/access.hpp"
#include "campaign/serve/actions.hpp"
#include "campaign/serve/events.hpp"
#include "campaign/serve/guarded_server.hpp"
#include "campaign/serve/site.hpp"
#include "db/store/connection.hpp"
#include "db/store/error.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
namespace {

constexpr auto loopback = "127.0.0.1";
constexpr auto sign_of_life = std::chrono::seconds(10);

Caller caller_of(const httplib::Request& request) {
  Caller c;
  for (auto [at, end] = request.headers.equal_range("Host"); at != end; ++at)
    c.hosts.push_back(at->second);
  c.origin = request.get_header_value("Origin");
  c.fetch_site = request.get_header_value("Sec-Fetch-Site");
  c.content_type = request.get_header_value("Content-Type");
  c.token = request.get_header_value("X-Eerie-Token");
  return c;
}

void send(httplib::Response& response, const Reply& reply) {
  response.status = reply.status;
  response.set_header("Cache-Control", reply.etag.empty() ? "no-store" : "no-cache");
  if (!reply.etag.empty()) response.set_header("ETag", reply.etag);
  if (reply.retry_s > 0) response.set_header("Retry-After", std::to_string(reply.retry_s));
  if (!reply.file_name.empty())
    response.set_header("Content-Disposition",
                        fmt::format("attachment; filename=\"{}\"", reply.file_name));
  response.set_content(reply.body, reply.type);
}

void stream(httplib::Response& response, Events& events) {
  auto listener = events.listen();
  if (!listener)
    return send(response, busy("too many pages listen already: ask for /api/news now and then"));
  response.set_header("Cache-Control", "no-store");
  response.set_chunked_content_provider("text/event-stream",
                                        [listener](std::size_t, httplib::DataSink& sink) {
                                          const auto news = listener->next(sign_of_life);
                                          if (!news) return sink.done(), true;
                                          return sink.write(news->data(), news->size());
                                        });
}

}  // namespace

class Dashboard::Running {
 public:
  explicit Running(const DashboardOptions& o)
      : database_(o.database),
        rules_{o.read_only ? "" : new_token(), o.address == loopback ? "" : o.address},
        events_(o.database),
        site_(o.database, o.read_only, events_) {
    route();
    port_ = server_.bind(o.address.empty() ? loopback : o.address, o.port);
    server_.begin();
  }
  ~Running() {
    events_.end();
    server_.end();
  }

  std::string address() const {
    const std::string host = rules_.listens_on.empty() ? loopback : rules_.listens_on;
    return fmt::format("http://{}:{}/{}",
                       host.find(':') == std::string::npos ? host : "[" + host + "]", port_,
                       rules_.token.empty() ? "" : "#token=" + rules_.token);
  }
  int port() const { return port_; }
  const std::string& token() const { return rules_.token; }

 private:
  /// All that reads is answered before any body is: no method but POST has one here.
  void route() {
    server_.set_pre_routing_handler([this](const auto& request, auto& response) {
      return read(request, response) ? httplib::Server::HandlerResponse::Handled
                                     : httplib::Server::HandlerResponse::Unhandled;
    });
    server_.Post("/api/requests", [this](const auto& request, auto& response) {
      try {
        require_known(request.params, "");
        events_.require_shown();
        send(response, act(database_, request.body));
      } catch (const InputError& error) {
        send(response, refusal(400, error.what()));
      } catch (const std::exception& error) {
        send(response, refusal(503, error.what()));
      }
    });
    server_.set_exception_handler([](const auto&, auto& response, const std::exception_ptr&) {
      send(response, refusal(500, "the server could not answer"));
    });
  }

  /// False: it is an action that may be carried out.
  bool read(const httplib::Request& request, httplib::Response& response) {
    const Caller caller = caller_of(request);
    const bool action = request.method == "POST" && request.path == "/api/requests";
    const bool reads = request.method == "GET" || request.method == "HEAD";
    if (const auto refused =
            action ? refused_to_change(rules_, caller) : refused_to_read(rules_, caller)) {
      send(response, *refused);
    } else if (!action && !reads) {
      send(response, refusal(405, "there is GET, and POST of /api/requests"));
    } else if (action) {
      return false;
    } else if (request.path == "/api/events") {
      if (request.params.empty())
        stream(response, events_);
      else
        send(response, refusal(400, fmt::format("parameter {}: this address takes none",
                                                request.params.begin()->first)));
    } else {
      answer(request, response);
    }
    return true;
  }

  void answer(const httplib::Request& request, httplib::Response& response) {
    const Reply reply = site_.answer(request.path, request.params);
    if (!reply.etag.empty() && request.get_header_value("If-None-Match") == reply.etag) {
      response.status = 304;
      response.set_header("ETag", reply.etag);
    } else {
      send(response, reply);
    }
  }

  std::filesystem::path database_;
  AccessRules rules_;
  Events events_;
  Site site_;
  GuardedServer server_;
  int port_ = 0;
};

Dashboard::Dashboard(const DashboardOptions& options) {
  const db::Connection readable(options.database, db::Access::read);  // or says why not
  running_ = std::make_unique<Running>(options);
}
Dashboard::~Dashboard() = default;
std::string Dashboard::address() const { return running_->address(); }
int Dashboard::port() const { return running_->port(); }
const std::string& Dashboard::token() const { return running_->token(); }

}  // namespace eerie::serve
