#include "craze/io/files/atomic_file.h"

#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "craze/base/text/format.h"
#include "craze/io/files/read_file.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

namespace fs = std::filesystem;

TEST(AtomicFile, ReplacesTheOldFileAndKeepsItsMode) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms::owner_read | fs::perms::owner_write);
  write_file(folder / "a", "new");
  EXPECT_EQ(read_file(folder / "a"), "new");
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, ANewFileNeverHasAnotherName) {
  const TemporaryFolder folder;
  const int nameless = ::open(folder.path().c_str(), O_TMPFILE | O_WRONLY, 0666);
  if (nameless < 0) GTEST_SKIP() << "files without a name cannot be made here";
  ::close(nameless);
  const int watch = ::inotify_init1(IN_NONBLOCK);
  ASSERT_GE(::inotify_add_watch(watch, folder.path().c_str(), IN_CREATE | IN_MOVED_TO), 0);
  write_file(folder / "a", "x");
  alignas(inotify_event) char events[4096];
  const ssize_t size = ::read(watch, events, sizeof events);
  ::close(watch);
  ASSERT_GT(size, 0);
  const auto* const event = reinterpret_cast<const inotify_event*>(events);
  EXPECT_STREQ(event->name, "a");
  EXPECT_EQ(static_cast<std::size_t>(size), sizeof(inotify_event) + event->len);  // the only one
}

TEST(AtomicFile, NewFilesFollowTheUmask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_file(folder / "a", "x");
  ::umask(before);
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder / "a").permissions()), 0640u);
}

TEST(AtomicFile, AFailureLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  // A limit on the size of files stands for a full disk; its signal would end the process.
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 1000;
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string message =
      message_of([&] { write_file(folder / "a", std::string(5000, 'x')); }, ErrorKind::output);
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(message, "cannot write file (" + (folder / "a").string() + "): File too large");
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, GetsItsPlaceWithItsLastPart) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  {
    AtomicFile file(folder / "a", "cannot write", {});
    file.put("ne");
    EXPECT_EQ(read_file(folder / "a"), "old");
    file.put("w");
    file.finish();
    EXPECT_EQ(read_file(folder / "a"), "new");
  }
  { AtomicFile(folder / "a", "cannot write", {}).put("dropped"); }
  { AtomicFile(folder / "b", "cannot write", {}).put("dropped"); }
  EXPECT_EQ(read_file(folder / "a"), "new");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, AKilledWriterLeavesTheOldFileOrTheNewOneAndNothingElse) {
  const std::string old(1000, 'o'), written(20'000'000, 'n');
  for (int trial = 0; trial < 12; ++trial) {
    const TemporaryFolder folder;
    write_file(folder / "a", old);
    const pid_t writer = ::fork();
    if (writer == 0) {
      write_file(folder / "a", written);
      ::_exit(0);
    }
    ::usleep(200 * trial);
    ::kill(writer, SIGKILL);
    ::waitpid(writer, nullptr, 0);
    const std::string got = read_file(folder / "a");
    EXPECT_TRUE(got == old || got == written) << got.size() << " bytes";
    EXPECT_EQ(folder.entries(), 1u);
  }
}

TEST(AtomicFile, MissingFoldersAndFoldersAreNamedWithTheReason) {
  const TemporaryFolder folder;
  const auto message = [&](const fs::path& path) {
    return message_of([&] { write_file(path, "x"); }, ErrorKind::output);
  };
  EXPECT_NE(message(folder / "gone/a").find("No such file or directory"), std::string::npos);
  EXPECT_NE(message(folder.path()).find("Is a directory"), std::string::npos);
  EXPECT_NE(message("").find("No such file or directory"), std::string::npos);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(AtomicFile, AFullDeviceIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  const std::string message = message_of([] { write_file("/dev/full", "x"); }, ErrorKind::output);
  EXPECT_NE(message.find("No space left on device"), std::string::npos);
  EXPECT_TRUE(fs::exists("/dev/full"));
}

// Where clusters keep what is only for now.
TEST(AtomicFile, FilesInTheMemoryOfTheMachineAreFiles) {
  const fs::path folder = fs::path("/dev/shm") / fmt::format("craze-test-{}", ::getpid());
  std::error_code none;
  if (!fs::create_directory(folder, none)) GTEST_SKIP();
  write_file(folder / "a", "new");
  EXPECT_EQ(read_file(folder / "a"), "new");
  fs::remove_all(folder);
}

TEST(AtomicFile, ALentNameKeepsTheFileBehindIt) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  const int fd = ::open((folder / "a").c_str(), O_WRONLY | O_TRUNC);
  ASSERT_GE(fd, 0);
  struct stat before {
  }, after{};
  ASSERT_EQ(::fstat(fd, &before), 0);
  write_file(fmt::format("/dev/fd/{}", fd), "new");
  EXPECT_EQ(::stat((folder / "a").c_str(), &after), 0);
  ::close(fd);
  EXPECT_EQ(before.st_ino, after.st_ino);
  EXPECT_EQ(read_file(folder / "a"), "new");
}

TEST(AtomicFile, LinksKeepPointingToTheFile) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  fs::create_symlink("a", folder / "link");
  fs::create_symlink("not yet there", folder / "dangling");
  fs::create_symlink("loop", folder / "loop");
  write_file(folder / "link", "new");
  write_file(folder / "dangling", "made");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "a"), "new");
  EXPECT_EQ(read_file(folder / "not yet there"), "made");
  message_of([&] { write_file(folder / "loop", "x"); }, ErrorKind::output);
}

TEST(AtomicFile, PipesAreWrittenDirectly) {
  const TemporaryFolder folder;
  const std::string name = (folder / "pipe").string();
  ASSERT_EQ(::mkfifo(name.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = read_file(name); });
  write_file(name, std::string(300'000, 'x'));
  reader.join();
  EXPECT_EQ(got, std::string(300'000, 'x'));
  EXPECT_TRUE(fs::is_fifo(name));
}

TEST(AtomicFile, AClosedPipeIsAnErrorAndNotASignal) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const std::string message =
      message_of([&] { write_file(fmt::format("/dev/fd/{}", ends[1]), "x"); }, ErrorKind::output);
  ::close(ends[1]);
  EXPECT_NE(message.find("Broken pipe"), std::string::npos) << message;
}

TEST(ReadFile, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  const auto message = [&](const fs::path& path) { return message_of([&] { read_file(path); }); };
  EXPECT_NE(message(folder / "gone.obj").find("gone.obj): No such file"), std::string::npos);
  EXPECT_NE(message(folder.path()).find("Is a directory"), std::string::npos);
}

TEST(Pipes, ThatNobodyHoldsAreLeftWhenCancelled) {
  const TemporaryFolder folder;
  const std::string name = (folder / "pipe").string();
  ASSERT_EQ(::mkfifo(name.c_str(), 0600), 0);
  int looks = 0;
  Context context;
  context.cancelled = [&] { return ++looks > 2; };
  EXPECT_THROW(read_file(name, "cannot read", context), Cancelled);
  looks = 0;
  EXPECT_THROW(write_file(name, "x", "cannot write", context), Cancelled);
}

TEST(Pipes, ThatNobodyDrainsAreLeftWhenCancelled) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  int looks = 0;
  Context context;
  context.cancelled = [&] { return ++looks > 4; };
  EXPECT_THROW(write_file(fmt::format("/dev/fd/{}", ends[1]), std::string(1'000'000, 'x'),
                          "cannot write", context),
               Cancelled);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(AtomicFile, ACancelledWriteLeavesWhatWasThere) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_THROW(write_file(folder / "a", "new", "cannot write", context), Cancelled);
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace craze
