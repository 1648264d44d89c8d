// craze studio: the page that lies beside the command, to this machine alone, until a signal.
#include <httplib.h>

#include <chrono>
#include <thread>

#include "app/command.h"

namespace craze {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds patience{60};

/// A command that is installed in a folder of its own, with a page.
class Studio : public CommandTest {
 protected:
  Studio() : path_(std::getenv("PATH")) {
    fs::create_directories(folder_ / "bin");
    fs::create_directories(folder_ / "tools");
    fs::create_directories(page() / "assets");
    command_ = (folder_ / "bin/craze").string();
    fs::copy_file(CRAZE_COMMAND, command_);
    fs::create_directories(server().parent_path());
    fs::copy_file(CRAZE_STUDIO, server());
    std::ofstream(folder_ / "secret") << "not for anyone";
    std::ofstream(page() / "index.html") << "<title>a page</title>";
    std::ofstream(page() / "assets/engine.wasm") << "code";
    std::ofstream(page() / "assets/main.js") << "run()";
    setenv("PATH", (folder_ / "tools").c_str(), 1);
  }
  ~Studio() override {
    if (process_ > 0) end(SIGKILL);
    setenv("PATH", path_.c_str(), 1);
  }

  fs::path server() const { return folder_ / "libexec/craze/craze-studio"; }
  fs::path page() const { return folder_ / "share/craze/studio"; }

  /// Starts it and waits until it says its port; 0 where it never does.
  int served(const std::vector<std::string>& more = {"--no-browser"}) {
    std::vector<std::string> arguments{"studio", "--port", "0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    process_ = start(arguments);
    const std::string before = "The studio is at http://127.0.0.1:";
    for (const auto stop = Clock::now() + patience; Clock::now() < stop;) {
      const std::string said = read_text(folder_ / "out");
      if (said.rfind(before, 0) == 0 && said.back() == '\n') {
        return std::stoi(said.substr(before.size()));
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return 0;
  }

  CommandResult end(int signal) {
    kill(process_, signal);
    const CommandResult result = finish(process_);
    process_ = 0;
    return result;
  }

  const std::string path_;
  pid_t process_ = 0;
};

TEST_F(Studio, ServesThePageBesideTheCommandAndNothingElse) {
  httplib::Client client("127.0.0.1", served());
  const auto body = [&](const std::string& path) {
    const auto answer = client.Get(path.c_str());
    return answer && answer->status == 200 ? answer->body : "";
  };
  EXPECT_EQ(body("/"), "<title>a page</title>");
  EXPECT_EQ(body("/assets/engine.wasm"), "code");
  EXPECT_EQ(client.Get("/assets/engine.wasm")->get_header_value("Content-Type"),
            "application/wasm");
  EXPECT_EQ(client.Get("/assets/main.js")->get_header_value("Content-Type"), "text/javascript");
  for (const char* path :
       {"/nothing", "/../../../secret", "/%2e%2e/%2e%2e/%2e%2e/secret", "/assets"}) {
    EXPECT_EQ(body(path), "") << path;
  }
}

TEST_F(Studio, IsForThisMachineAlone) {
  const int port = served();
  EXPECT_TRUE(httplib::Client("127.0.0.1", port).Get("/"));
  // Another address of this machine, as every one but the loopback's first is.
  EXPECT_FALSE(httplib::Client("127.0.0.2", port).Get("/"));
}

TEST_F(Studio, EndsBySignalsAsTheOtherVerbsDo) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
    ASSERT_GT(served(), 0);
    const CommandResult result = end(signal);
    EXPECT_EQ(result.code, code);
    EXPECT_EQ(result.err, "craze: stopped\n");
  }
}

TEST_F(Studio, SaysInOneLineThatAPortIsTaken) {
  const std::string port = std::to_string(served());
  const pid_t second = start({"studio", "--no-browser", "--port", port});
  const CommandResult result = finish(second);
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.err.rfind("craze: error: cannot serve the page (127.0.0.1:" + port + "): ", 0),
            0u)
      << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1);
}

TEST_F(Studio, SaysInOneLineThatItHasNoPage) {
  fs::remove(page() / "index.html");
  expect_error({"studio", "--no-browser"}, 1, "no page to show (" + page().string() + ")");
}

TEST_F(Studio, SaysInOneLineThatNothingServesIt) {
  fs::remove(server());
  expect_error({"studio", "--no-browser"}, 1, "cannot serve the page (");
}

// What serving needs would make every start of the command slower.
TEST_F(Studio, IsServedByAProgramOfItsOwn) {
  EXPECT_EQ(read_text(CRAZE_COMMAND).find("libcpp-httplib"), std::string::npos);
  EXPECT_NE(read_text(CRAZE_STUDIO).find("libcpp-httplib"), std::string::npos);
}

TEST_F(Studio, RefusesAPortThatIsNone) {
  expect_error({"studio", "--port", "70000"}, 2, "--port");
}

TEST_F(Studio, OpensTheDesktopsBrowserAtItsAddress) {
  const fs::path browser = folder_ / "tools/xdg-open";
  std::ofstream(browser)
      << "#!/bin/sh\necho \"$1\" > ../opened.new; /bin/mv ../opened.new ../opened\n";
  fs::permissions(browser, fs::perms::owner_all);
  const int port = served({});
  for (const auto stop = Clock::now() + patience;
       !fs::exists(folder_ / "opened") && Clock::now() < stop;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(read_text(folder_ / "opened"), "http://127.0.0.1:" + std::to_string(port) + "/\n");
  EXPECT_EQ(end(SIGINT).err, "craze: stopped\n");
}

TEST_F(Studio, WarnsWhereThereIsNoBrowser) {
  EXPECT_GT(served({}), 0);
  const CommandResult result = end(SIGINT);
  EXPECT_EQ(result.err,
            "craze: warning: no browser was opened (xdg-open): it is not there\ncraze: stopped\n");
}

}  // namespace
}  // namespace craze
