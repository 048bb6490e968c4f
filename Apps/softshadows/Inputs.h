// SPDX-License-Identifier: BSD-3-Clause
// The files that a command reads: whether they can be, before anything has a look at them.

#ifndef Inputs_h
#define Inputs_h

#include <string>

namespace Inputs
{
/**
 * Failure, which names the file, unless it is a regular file that can be opened and is not empty. Pipes
 * and devices may have no end, and a reader wants to go back.
 */
void Check(const std::string& path);

/** The text of a file of at most this many bytes; Failure if it cannot be had. */
std::string ReadText(const std::string& path, unsigned long long most);
}

#endif
