// SPDX-License-Identifier: BSD-3-Clause
// The tables of the report, as its template wants them.

#ifndef BenchTables_h
#define BenchTables_h

#include "BenchFigures.h"

#include <string>

namespace BenchTables
{
using BenchFigures::Json;

/** A sentence that tells the user what to take for a case; "" where nothing is known. */
std::string Recommend(const Json& oneCase);

///@{
/** Rows of a case's tables; [] for none. */
Json GetUnderError(const Json& oneCase);
Json GetUnderTime(const Json& oneCase);
Json GetEntries(const Json& oneCase, double framesWanted);
Json GetEqualError(const Json& oneCase);
Json GetEqualTime(const Json& oneCase);
Json GetPublished(const Json& oneCase);
///@}

/** How the cost grows: the axes, and a row for each entry. */
Json GetExponents(const Json& scaling);
}

#endif
