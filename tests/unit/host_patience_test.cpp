#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include "host/patience.h"

namespace taut {
namespace {

// What was written to a file so far.
std::string text_of(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c = 0; (c = std::fgetc(file)) != EOF;) text += static_cast<char>(c);
  return text;
}

std::string said_within(std::chrono::milliseconds time, bool quiet, bool heard) {
  std::FILE* file = std::tmpfile();
  {
    Patience patience(file, quiet, "building the scene");
    if (heard) patience.heard();
    std::this_thread::sleep_for(time);
  }
  std::string text = text_of(file);
  std::fclose(file);
  return text;
}

using namespace std::chrono_literals;

TEST(Patience, SpeaksAfterTwoSecondsOfSilence) {
  EXPECT_EQ(said_within(2500ms, false, false), "taut: still building the scene; nothing new for 2 s\n");
}

TEST(Patience, SaysNothingOfWhatIsQuickOrQuietOrHeardOf) {
  EXPECT_EQ(said_within(20ms, false, false), "");
  std::string quiet, heard;
  std::thread other([&] { quiet = said_within(2300ms, true, false); });
  heard = said_within(2300ms, false, true);
  other.join();
  EXPECT_EQ(quiet, "");
  EXPECT_EQ(heard, "") << "ten seconds from then on";
}

}  // namespace
}  // namespace taut
