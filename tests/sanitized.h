#pragma once

// TAUT_SANITIZED is defined where the address or the thread sanitizer is built in, which have a heap and
// operators of their own, and take more addresses than any machine has. g++ says so by other words than
// clang.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAUT_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TAUT_SANITIZED 1
#endif
#endif
