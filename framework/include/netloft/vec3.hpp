// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>

namespace netloft {

/// A vector in the world frame (x, y, z up), of doubles or dual numbers.
template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  const T& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
  Vec3& operator-=(const Vec3& b) { return *this = *this - b; }

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
};

/// Whether a type is a Vec3. The operator * is not defined for two vectors: use dot or cross.
template <class S>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<Vec3<T>> = true;

template <class T, class S>
requires(!is_vector<S>) Vec3<T>
operator*(const S& s, const Vec3<T>& a) { return {s * a.x, s * a.y, s * a.z}; }
template <class T, class S>
requires(!is_vector<S>) Vec3<T>
operator*(const Vec3<T>& a, const S& s) { return {a.x * s, a.y * s, a.z * s}; }
template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T norm(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Positions, velocities … of the nodes of one element.
template <class T, int Nodes>
using Points = std::array<Vec3<T>, Nodes>;

}  // namespace netloft
