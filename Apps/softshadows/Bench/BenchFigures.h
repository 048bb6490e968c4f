// SPDX-License-Identifier: BSD-3-Clause
// The figures of results.json, any of which may be missing, and how the report writes them.

#ifndef BenchFigures_h
#define BenchFigures_h

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace BenchFigures
{
using Json = nlohmann::ordered_json;
using Path = std::initializer_list<std::string>;
using Number = std::optional<double>;

/** The value under keys, one within another; null where there is none. */
const Json& Find(const Json& from, Path path);

/** The elements of a list; none where there is no list. */
const Json& FindList(const Json& from, Path path);

/** A finite number, or nothing. */
Number FindNumber(const Json& from, Path path);

/** A value as text; "" where there is none. */
std::string FindText(const Json& from, Path path);

/** The different texts that a list's elements have under a key, in their order. */
std::vector<std::string> FindTexts(const Json& list, const std::string& key);

///@{
/**
 * An entry's error over pixels, "penumbra" or "all", and the milliseconds it adds to the frame in a
 * kind of frames, "static" or "dynamic".
 */
Number GetError(const Json& entry, const std::string& pixels);
Number GetAdded(const Json& entry, const std::string& time);
///@}

/** The noise of a case's reference over pixels. */
Number GetNoise(const Json& oneCase, const std::string& pixels);

/** The entry of a case with an id; null where there is none. */
const Json& FindEntry(const Json& oneCase, const std::string& id);

/** What the reader knows an entry by: its label, or its id. */
std::string GetName(const Json& entry);
std::string GetName(const Json& oneCase, const std::string& id);

bool IsSkipped(const Json& entry);

/** A technique of this project, neither another's nor the frame without shadows. */
bool IsTechnique(const Json& entry);
bool IsPeer(const Json& entry);

///@{
/** Numbers as the report writes them; "" for none. */
std::string WriteError(const Number& value);
std::string WriteSigned(const Number& value);
std::string WriteMilliseconds(const Number& value);
std::string WriteRatio(const Number& value);
std::string WritePercent(const Number& value);
std::string WriteCount(const Number& value);
std::string WriteBytes(const Number& value);
/** In few digits: limits, light sizes. */
std::string WriteShort(const Number& value);
///@}

/** What frames show: "camera moves" or "light moves". */
std::string DescribeTime(const std::string& time);

/** What an error is over: "penumbra" or "all receivers". */
std::string DescribePixels(const std::string& pixels);
}

#endif
