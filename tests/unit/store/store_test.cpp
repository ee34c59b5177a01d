// SPDX-License-Identifier: Apache-2.0
// Without these a store could serve an altered picture, lose what another process wrote, or be lost to one bad page.

#include "tests/support/temporary_folder.h"

#include "core/error.h"
#include "core/files.h"
#include "store/objects.h"
#include "store/store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class StoreTest : public testing::Test {
 protected:
  std::filesystem::path folder() const { return temporary_.path() / "store"; }
  Store open() const { return Store(folder(), Database::Mode::write); }
  std::filesystem::path image(const std::string& bytes) const {
    write_file_atomically(temporary_.path() / "image.exr", bytes);
    return temporary_.path() / "image.exr";
  }
  /// An entry "a" with one image; returns the image's place in the store.
  std::filesystem::path fill(const std::string& bytes) const {
    Store store = open();
    const std::string object = store.keep(image(bytes));
    store.put({"a", EntryKind::run, "{\"image_file\":\"" + object + "\"}"});
    return folder() / object;
  }

  TemporaryFolder temporary_;
};

/// Exit code of `work` in a process of its own.
int in_child(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST_F(StoreTest, GivesBackWhatWasPut) {
  const std::filesystem::path object = fill("pixels");
  Store store = open();
  EXPECT_THAT(store.find("a").value_or(""), HasSubstr("objects/"));
  EXPECT_EQ(read_file(object), "pixels");
  EXPECT_FALSE(store.find("b"));
  EXPECT_TRUE(store.take_warnings().empty());
  ASSERT_EQ(store.entries(EntryKind::run).size(), 1u);
  EXPECT_TRUE(store.entries(EntryKind::reference).empty());
}

TEST_F(StoreTest, ImagesOfTheSameBytesAreKeptOnce) {
  Store store = open();
  EXPECT_EQ(store.keep(image("pixels")), store.keep(image("pixels")));
  EXPECT_NE(store.keep(image("pixels")), store.keep(image("others")));
}

TEST_F(StoreTest, AnAlteredImageIsFoundAndCanBeMadeAgain) {
  const std::filesystem::path object = fill("pixels");
  std::filesystem::remove(object);
  std::ofstream(object) << "pixelz";
  {
    Store store = open();
    EXPECT_FALSE(store.find("a"));
    EXPECT_THAT(store.take_warnings(), ElementsAre(HasSubstr("image was altered")));
  }
  EXPECT_EQ(fill("pixels"), object);
  EXPECT_TRUE(open().find("a"));
}

TEST_F(StoreTest, AMissingImageIsFound) {
  std::filesystem::remove(fill("pixels"));
  EXPECT_FALSE(open().find("a"));
}

TEST_F(StoreTest, AnUntouchedImageWithAnotherTimeIsStillGood) {
  const std::filesystem::path object = fill("pixels");
  std::filesystem::last_write_time(object,
                                   std::filesystem::file_time_type::clock::now() - std::chrono::hours(5));
  EXPECT_TRUE(open().find("a"));
}

TEST_F(StoreTest, AnAlteredRowIsFound) {
  fill("pixels");
  {
    Database database(folder() / kStoreFile, Database::Mode::write);
    database.run("UPDATE entries SET json = '{\"rmse\":' WHERE key = 'a'");
  }
  Store store = open();
  EXPECT_FALSE(store.find("a"));
  EXPECT_THAT(store.take_warnings(), ElementsAre(HasSubstr("was altered")));
}

TEST_F(StoreTest, ADamagedPageCostsOnlyItsRows) {
  constexpr int kRows = 400;
  {
    Store store = open();
    for (int i = 0; i < kRows; ++i)
      store.put({std::to_string(i), EntryKind::run, "{\"text\":\"" + std::string(500, 'x') + "\"}"});
  }
  const std::filesystem::path file = folder() / kStoreFile;
  {
    constexpr std::streamoff kPage = 4096;
    std::fstream bytes(file, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(20 * kPage);  // a leaf of 400 rows on some 60 pages
    bytes << std::string(kPage, '\x5a');
  }
  Store store = open();
  const size_t kept = store.entries(EntryKind::run).size();
  EXPECT_GT(kept, kRows * 9 / 10u);
  EXPECT_LT(kept, size_t{kRows});
  EXPECT_THAT(store.take_warnings(), testing::Contains(HasSubstr("was damaged")));
  EXPECT_TRUE(std::filesystem::exists(folder() / "store.sqlite.damaged"));
}

TEST_F(StoreTest, AFileThatIsNoDatabaseIsSetAside) {
  std::filesystem::create_directories(folder());
  std::ofstream(folder() / kStoreFile) << "this is no database, and long enough to be looked at";
  Store store = open();
  EXPECT_THAT(store.take_warnings(), ElementsAre(HasSubstr("0 entries could be read")));
  store.put({"a", EntryKind::run, "{}"});
  EXPECT_TRUE(store.find("a"));
}

TEST_F(StoreTest, TwoProcessesWriteAtOnce) {
  constexpr int kEach = 50;
  const auto write = [&](const std::string& name) {
    Store store = open();
    for (int i = 0; i < kEach; ++i) {
      const std::filesystem::path file = temporary_.path() / (name + ".exr");
      std::ofstream(file) << name << i / 2;
      const std::string object = store.keep(file);
      store.put({name + std::to_string(i), EntryKind::run, "{\"image_file\":\"" + object + "\"}"});
    }
    return 0;
  };
  const pid_t first = fork();
  if (first == 0) _exit(write("first"));
  EXPECT_EQ(in_child([&] { return write("second"); }), 0);
  int status = -1;
  waitpid(first, &status, 0);
  EXPECT_EQ(status, 0);
  Store store = open();
  EXPECT_EQ(store.entries(EntryKind::run).size(), 2u * kEach);
  EXPECT_TRUE(store.take_warnings().empty());
}

TEST_F(StoreTest, AFullDiskIsAClearErrorAndLosesNothing) {
  fill("pixels");
  const auto overfill = [&] {
    constexpr rlim_t kRoom = 300 << 10;  // of any one file: as a disk that is full
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{kRoom, kRoom};
    setrlimit(RLIMIT_FSIZE, &limit);
    Store store = open();
    try {
      for (int i = 0; i < 1000; ++i)
        store.put({"big" + std::to_string(i), EntryKind::run, "\"" + std::string(4000, 'x') + "\""});
    } catch (const Error& error) {
      const bool is_clear = error.kind() == ErrorKind::environment &&
                            std::string(error.what()).find("is the disk full?") != std::string::npos;
      return is_clear ? 42 : 1;
    }
    return 0;
  };
  EXPECT_EQ(in_child(overfill), 42);
  Store store = open();
  EXPECT_TRUE(store.find("a"));
  EXPECT_GT(store.entries(EntryKind::run).size(), 10u);  // those before it was full
  EXPECT_TRUE(store.take_warnings().empty());
}

TEST_F(StoreTest, AKilledWriterLeavesWholeEntries) {
  const pid_t child = fork();
  if (child == 0) {
    Store store = open();
    for (int i = 0;; ++i)
      store.put({std::to_string(i), EntryKind::run, "{\"number\":" + std::to_string(i) + "}"});
  }
  usleep(200000);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  Store store = open();
  EXPECT_GT(store.entries(EntryKind::run).size(), 0u);
  EXPECT_TRUE(store.take_warnings().empty());
}

TEST_F(StoreTest, SaysWhyItCannotBeUsed) {
  const auto message = [](const std::function<void()>& work) {
    try {
      work();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_THAT(message([&] { Store(folder(), Database::Mode::read); }), HasSubstr("has no store.sqlite"));
  open();
  Database(folder() / kStoreFile, Database::Mode::write).run("UPDATE meta SET value = '7'");
  EXPECT_THAT(message([&] { open(); }), HasSubstr("a store of schema 7; this version reads 1"));
}

}  // namespace
}  // namespace umbrameter
