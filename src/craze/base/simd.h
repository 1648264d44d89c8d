// Four numbers handled as one: the units in which the hot loops read and write.
#pragma once

namespace craze {

/// A 3-vector and one more number, 32-byte aligned. `v` takes arithmetic operators lane by lane;
/// the compiler lowers it to whatever the machine has, always with the same rounding.
struct alignas(32) Vec4d {
  using Lanes = double __attribute__((vector_size(32)));
  Lanes v = {0, 0, 0, 0};

  double operator[](int i) const { return v[i]; }
  double& operator[](int i) { return reinterpret_cast<double*>(this)[i]; }
};

/// Four floats handled as one, 16-byte aligned.
struct alignas(16) Vec4f {
  using Lanes = float __attribute__((vector_size(16)));
  Lanes v = {0, 0, 0, 0};

  float operator[](int i) const { return v[i]; }
  float& operator[](int i) { return reinterpret_cast<float*>(this)[i]; }
};

/// Eight floats handled as one, 32-byte aligned.
struct alignas(32) Vec8f {
  using Lanes = float __attribute__((vector_size(32)));
  Lanes v = {0, 0, 0, 0, 0, 0, 0, 0};

  float operator[](int i) const { return v[i]; }
  float& operator[](int i) { return reinterpret_cast<float*>(this)[i]; }
};

// Compiles a function twice and picks the wider one at start-up. Without contraction
// (-ffp-contract=off) both compute the same bits: a build with CRAZE_NARROW, where there is only
// the narrow one, shows it.
#if !defined(CRAZE_NARROW) && defined(__x86_64__) && defined(__GNUC__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
#define CRAZE_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define CRAZE_WIDE
#endif

}  // namespace craze
