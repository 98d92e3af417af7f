// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Compiles the kernels' maths headers for the host, one lane wide, as namespace tyn_kernel: for calls that promise the device's
// own numbers, and so that tests, sanitizers and coverage see the very code that the device runs. Only what those headers use
// of OpenCL C is here.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "kernels/shared.h" // here, so that its records stay outside the namespace

// As on the devices that matter.
#define TYN_FMA 1

namespace tyn_kernel {

using uint = uint32_t;

// Components as OpenCL names them; operators as OpenCL has them, component by component.
struct float2 {
  float x, y;
};
struct float3 {
  float x, y, z;
};
struct float4 {
  float x, y, z, w;
};
struct uint2 {
  uint x, y;
};
struct uint4 {
  uint x, y, z, w;
};

inline float2 operator+(float2 a, float2 b) { return {a.x + b.x, a.y + b.y}; }
inline float2 operator-(float2 a, float2 b) { return {a.x - b.x, a.y - b.y}; }
inline float2 operator*(float2 a, float s) { return {a.x * s, a.y * s}; }
inline float3 operator+(float3 a, float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline float3 operator-(float3 a, float3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline float3 operator-(float3 a) { return {-a.x, -a.y, -a.z}; }
inline float3 operator*(float3 a, float3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline float3 operator*(float3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline float3 operator*(float s, float3 a) { return a * s; }
inline float3 operator/(float3 a, float s) { return {a.x / s, a.y / s, a.z / s}; }
inline float4 operator+(float4 a, float4 b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
inline float4 operator-(float4 a, float4 b) { return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}; }
inline float4 operator*(float4 a, float s) { return {a.x * s, a.y * s, a.z * s, a.w * s}; }

// The overloads for float, which the C names would not choose.
using std::cbrt;
using std::copysign;
using std::cos;
using std::fabs;
using std::floor;
using std::fma;
using std::fmax;
using std::fmin;
using std::ilogb;
using std::isfinite;
using std::isnan;
using std::ldexp;
using std::pow;
using std::sin;
using std::sqrt;

inline float min(float a, float b) { return b < a ? b : a; }
inline float max(float a, float b) { return a < b ? b : a; }
inline uint min(uint a, uint b) { return b < a ? b : a; }
inline uint max(uint a, uint b) { return a < b ? b : a; }
inline float clamp(float x, float low, float high) { return fmin(fmax(x, low), high); }
// For scalars OpenCL's select asks whether the mask is 0.
inline float select(float no, float yes, int mask) { return mask ? yes : no; }
inline uint mul_hi(uint a, uint b) { return static_cast<uint>(uint64_t(a) * b >> 32); }
inline uint clz(uint x) {
  uint zeros = 32;
  for (; x; x >>= 1)
    --zeros;
  return zeros;
}

template <class To, class From>
To reinterpret_bits(From from) {
  static_assert(sizeof(To) == sizeof(From), "bits have one length");
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}
template <class From>
float as_float(From x) {
  return reinterpret_bits<float>(x);
}
template <class From>
int as_int(From x) {
  return reinterpret_bits<int>(x);
}
template <class From>
uint as_uint(From x) {
  return reinterpret_bits<uint>(x);
}
template <class From>
float convert_float(From x) {
  return static_cast<float>(x);
}
template <class From>
int convert_int(From x) {
  return static_cast<int>(x);
}
template <class From>
uint convert_uint(From x) {
  return static_cast<uint>(x);
}

// What math.clh makes of vector literals on a device.
inline float3 tyn_vec3(float x, float y, float z) { return {x, y, z}; }
inline uint2 tyn_uint2(uint x, uint y) { return {x, y}; }
inline uint4 tyn_uint4(uint x, uint y, uint z, uint w) { return {x, y, z, w}; }
inline float3 tyn_load3(const float *v) { return {v[0], v[1], v[2]}; }
inline float3 tyn_load3_global(const float *v) { return {v[0], v[1], v[2]}; }

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" // no file uses every function of the headers
#define TYN_LANES 1
#define global
#define constant const
#define local
#define kernel
#include "kernels/interface.clh"
#include "kernels/lane_math.clh"
#include "kernels/lanes.clh"
#include "kernels/math.clh"
#include "kernels/phase.clh"
#include "kernels/random.clh"
#undef global
#undef constant
#undef local
#undef kernel
#pragma GCC diagnostic pop

} // namespace tyn_kernel
