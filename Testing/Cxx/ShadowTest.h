// SPDX-License-Identifier: BSD-3-Clause
// What every test is made of: its registration, checks, and the messages of VTK and OpenGL.
//
//   SHADOW_TEST(Law, UnoccludedIsOne, Each) { ... technique ... }
//
// is the ctest `Law.UnoccludedIsOne.TECHNIQUE` of each technique, and with `Once` the ctest
// `Law.UnoccludedIsOne`. CMakeLists.txt reads the macro from the sources: nothing is to be repeated.
//
// A message that a test does not take with ShadowTest::TakeMessages() fails it.

#ifndef ShadowTest_h
#define ShadowTest_h

#include <string>
#include <vector>

namespace ShadowTest
{
using Function = void (*)(const std::string& technique);

struct Registration
{
  Registration(const char* name, Function function);
};

struct Message
{
  enum Kind
  {
    Error,
    Warning,
    GL
  };
  Kind Source;
  std::string Text;
};

/** Failures go on: one run shows all that is wrong. Each gives what it was told. */
bool Check(bool holds, const std::string& what);
/** Prints the figure too. NaN is not at most anything. */
bool CheckAtMost(double value, double bound, const std::string& what);
bool CheckAtLeast(double value, double bound, const std::string& what);
bool CheckEqual(double value, double expected, const std::string& what);

/** What VTK and OpenGL said since the last call. */
std::vector<Message> TakeMessages();
void AddMessage(Message::Kind source, const std::string& text);
/** There is just one message since the last call, of this kind, and it contains these words. */
bool CheckOneMessage(
  Message::Kind source, const std::vector<std::string>& words, const std::string& what);
bool CheckNoMessage(const std::string& what);

///@{ For the harness's own tests: failures from here on; they are forgotten, and how many they were.
void ExpectFailures();
int TakeFailures();
///@}
}

#define SHADOW_TEST(group, name, scope)                                                           \
  static void group##name(const std::string& technique);                                          \
  static const ShadowTest::Registration group##name##Registration(#group "." #name, group##name); \
  static void group##name([[maybe_unused]] const std::string& technique)

#endif
