// SPDX-License-Identifier: BSD-3-Clause
#include "framework/scene/scene_bytes.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace netloft {

namespace {

template <class T, class Plain>
concept Same = std::is_same_v<std::remove_const_t<T>, Plain>;

/// One function names the members of a type, for writing and reading alike. Members that are plain numbers
/// all through are copied as they are.
template <class Archive, Same<SeaBed> T>
void members(Archive& archive, T& bed) {
  archive(bed.is_there, bed.depth, bed.slope_x, bed.slope_y, bed.relief);
}
template <class Archive, Same<Current> T>
void members(Archive& archive, T& current) {
  archive(current.samples, current.factors, current.drifts, current.tow);
}
template <class Archive, Same<LawChoice> T>
void members(Archive& archive, T& law) {
  archive(law.type, law.parameters);
}
template <class Archive, Same<Part> T>
void members(Archive& archive, T& part) {
  archive(part.name, part.type, part.parameters, part.nodes, part.data, part.laws, part.companion,
          part.viscosity_ratio);
}
template <class Archive, Same<Guide> T>
void members(Archive& archive, T& guide) {
  archive(guide.nodes, guide.axes, guide.course.knots);
}
template <class Archive, Same<RigidBody> T>
void members(Archive& archive, T& body) {
  archive(body.name, body.origin, body.rotation, body.held_rotation, body.points, body.rotation_node);
}
template <class Archive, Same<Setting> T>
void members(Archive& archive, T& setting) {
  archive(setting.name, setting.part, setting.datum, setting.unit, setting.node, setting.wanted,
          setting.factor);
}
template <class Archive, Same<WinchStage> T>
void members(Archive& archive, T& stage) {
  archive(stage.follows, stage.from, stage.rows, stage.max_speed, stage.band, stage.dead_band);
}
template <class Archive, Same<Winch> T>
void members(Archive& archive, T& winch) {
  archive(winch.part, winch.parameter, winch.block, winch.length, winch.stages);
}
template <class Archive, Same<Scene> T>
void members(Archive& archive, T& scene) {
  archive(scene.name, scene.water, scene.current, scene.ground, scene.bed, scene.positions, scene.held,
          scene.frames, scene.bodies, scene.carried, scene.guides, scene.labels, scene.parts, scene.settings,
          scene.winches);
}

template <class T>
constexpr bool is_plain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

class Writer {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (write(values), ...);
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void copy(const void* from, std::size_t count) {
    const auto* bytes = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), bytes, bytes + count);
  }
  template <class T>
  void write(const T& value) {
    if constexpr (is_plain<T>)
      copy(&value, sizeof value);
    else
      members(*this, value);
  }
  void write(const std::string& text) {
    write(text.size());
    copy(text.data(), text.size());
  }
  template <class T>
  void write(const std::vector<T>& all) {
    write(all.size());
    if constexpr (is_plain<T>)
      copy(all.data(), all.size() * sizeof(T));
    else
      for (const T& one : all) write(one);
  }
  void write(const std::vector<bool>& all) { write(std::vector<char>(all.begin(), all.end())); }
  template <class Key, class T>
  void write(const std::map<Key, T>& all) {
    write(all.size());
    for (const auto& [key, value] : all) {
      write(key);
      write(value);
    }
  }
  void write(const Value& value) {
    write(value.index());
    std::visit([this](const auto& chosen) { write(chosen); }, value);
  }
  void write(const Surface& surface) {
    write(surface.x());
    write(surface.y());
    write(surface.values());
  }

  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (read(values), ...);
  }
  bool is_at_end() const { return rest_.empty(); }

 private:
  void copy(void* to, std::size_t count) {
    if (count > rest_.size()) throw std::invalid_argument("the bytes of a scene end too soon");
    std::copy_n(rest_.data(), count, static_cast<std::byte*>(to));
    rest_ = rest_.subspan(count);
  }
  std::size_t read_count() {
    std::size_t count = 0;
    read(count);
    // Even what takes no byte of its own is counted by one.
    if (count > rest_.size()) throw std::invalid_argument("the bytes of a scene end too soon");
    return count;
  }
  template <class T>
  void read(T& value) {
    if constexpr (is_plain<T>)
      copy(&value, sizeof value);
    else
      members(*this, value);
  }
  void read(std::string& text) {
    text.resize(read_count());
    copy(text.data(), text.size());
  }
  template <class T>
  void read(std::vector<T>& all) {
    all.resize(read_count());
    if constexpr (is_plain<T>)
      copy(all.data(), all.size() * sizeof(T));
    else
      for (T& one : all) read(one);
  }
  void read(std::vector<bool>& all) {
    std::vector<char> flags;
    read(flags);
    all.assign(flags.begin(), flags.end());
  }
  template <class Key, class T>
  void read(std::map<Key, T>& all) {
    for (std::size_t count = read_count(); count > 0; --count) {
      Key key{};
      read(key);
      read(all[std::move(key)]);
    }
  }
  template <class T>
  void read_as(Value& value) {
    T chosen{};
    read(chosen);
    value = std::move(chosen);
  }
  template <std::size_t... kinds>
  void read_kind(std::size_t kind, Value& value, std::index_sequence<kinds...>) {
    ((kind == kinds ? read_as<std::variant_alternative_t<kinds, Value>>(value) : void()), ...);
  }
  void read(Value& value) {
    std::size_t kind = 0;
    read(kind);
    read_kind(kind, value, std::make_index_sequence<std::variant_size_v<Value>>{});
  }
  void read(Surface& surface) {
    std::vector<double> x, y, values;
    read(x);
    read(y);
    read(values);
    if (!values.empty()) surface = Surface(std::move(x), std::move(y), std::move(values));
  }

  std::span<const std::byte> rest_;
};

}  // namespace

std::vector<std::byte> bytes_of(const Scene& scene) {
  Writer writer;
  members(writer, scene);
  return writer.take();
}

Scene scene_of(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  Scene scene;
  members(reader, scene);
  if (!reader.is_at_end()) throw std::invalid_argument("the bytes of a scene go on behind it");
  return scene;
}

}  // namespace netloft
