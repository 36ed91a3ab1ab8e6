// SPDX-License-Identifier: MIT
//
// How the loop of a query is inlined: completely, into one function, which is a tenth faster than calls. A
// macro, because the attributes must differ by sanitizer and a compiler offers no other way to choose them.
//
// Under address and thread sanitizers nothing is inlined by force and all code is instrumented: code without
// instrumentation, inlined next to instrumented code, reuses stack places that are still marked as out of
// scope (g++ 12 reported it in any query of a large body). Under the undefined-behaviour sanitizer alone the
// loop is not instrumented: with instrumentation g++ took minutes to compile it. clang++ inlines it then; g++
// inlines no instrumented function into it, so what the loop calls is instrumented and called.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EDGEWISE_LOOKED_AT 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define EDGEWISE_LOOKED_AT 1
#endif
#endif

/// A function that only reads vectors passed to it: the undefined-behaviour sanitizer can find nothing
/// there.
#define EDGEWISE_IN_QUERY_LOOP __attribute__((no_sanitize("undefined")))

/// A function with everything that it calls inlined; one in a query loop has a symbol of its own.
#ifdef EDGEWISE_LOOKED_AT
#define EDGEWISE_FLATTENED
#define EDGEWISE_QUERY_LOOP __attribute__((noinline))
#undef EDGEWISE_LOOKED_AT
#else
#define EDGEWISE_FLATTENED __attribute__((flatten))
#define EDGEWISE_QUERY_LOOP __attribute__((flatten, noinline, no_sanitize("undefined")))
#endif
