// SPDX-License-Identifier: BSD-3-Clause
// What the command prints, and whether it has arrived.

#ifndef StandardOutput_h
#define StandardOutput_h

#include <nlohmann/json.hpp>

#include <string>

namespace StandardOutput
{
/**
 * First of all: where the command was started without one of its standard streams, the first file that
 * it opened would take that place.
 */
void Reserve();

/** JSON as text; names of files need not be UTF-8. */
std::string GetText(const nlohmann::ordered_json& json);

/** Print JSON. */
void Print(const nlohmann::ordered_json& json);

/** Last of all: why something of what was printed was lost (a full disk), or "". */
std::string Finish();
}

#endif
