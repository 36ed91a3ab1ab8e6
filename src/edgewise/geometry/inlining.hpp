// SPDX-License-Identifier: MIT
//
// How the loop of a query is inlined: whole, into one function, which is a tenth faster than calls. A macro,
// because the attributes must differ by sanitizer and a compiler offers no other way to choose them.
//
// Under address and thread sanitizers nothing is inlined by force and everything is looked at: code that they
// do not look at, inlined beside code that they do, reuses places on the stack that are still marked as out
// of scope (g++ 12 reported it in any query of a large body). Under the undefined-behaviour sanitizer alone
// the loop is inlined and not looked at: looked at, it took g++ minutes to compile.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EDGEWISE_LOOKED_AT 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define EDGEWISE_LOOKED_AT 1
#endif
#endif

/// A function that reads nothing but vectors handed to it: the undefined-behaviour sanitizer finds nothing
/// there.
#define EDGEWISE_IN_QUERY_LOOP __attribute__((no_sanitize("undefined")))

/// A function that everything it calls is inlined into; a symbol of its own.
#ifdef EDGEWISE_LOOKED_AT
#define EDGEWISE_QUERY_LOOP __attribute__((noinline))
#undef EDGEWISE_LOOKED_AT
#else
#define EDGEWISE_QUERY_LOOP __attribute__((flatten, noinline, no_sanitize("undefined")))
#endif
