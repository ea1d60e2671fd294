// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "core/thread_pool.h"

namespace frana {

/// The fields a particle may have. k_field_table describes them; a scene allocates only those its terms declare.
enum class Field : unsigned char {
    x,
    y,  // position
    u,
    v,  // velocity
    volume,
    area,  // depth is volume / area
    c_xx,
    c_xy,
    c_yx,
    c_yy,         // affine velocity (APIC): rows are components, columns directions
    compression,  // rate used by the artificial viscosity, of the last step
    s_xx,
    s_xy,
    s_yy,  // in-plane viscous stress over density
    q_xx,
    q_xy,
    q_yy,            // squared extents: the shape into which the flow has deformed the particle
    flown,           // fraction that has left the bed at the edge that the particle passes
    pore_pressure,   // at the bed, over the total normal stress
    solid_fraction,  // with dilatancy
    // Further fields of structured solids; `volume` is of the solids alone, depth is (volume + confined) / area.
    confined,        // volume of the confined fluid
    confined_start,  // when the particle was placed
    pores,           // volume of the pores between the solids when the particle was placed
    t_xx,
    t_yy,
    t_zz,
    t_xy,  // stress, tension positive, without the geostatic part
    e_xx,
    e_yy,
    e_xy,            // strain since the start
    damage,          // accumulated cracking strain
    cohesion_ratio,  // present cohesion over initial
    cohesion,        // initial
    friction,        // tangent of the internal friction angle
    bed_friction,    // tangent of the friction angle at the bed
    grain_density,
    grain_diameter,
    push_x,
    push_y,       // acceleration by the grid in the present step
    flatness,     // 1 / (1 + |grad b|^2) of the bed
    submergence,  // fraction of the pores filled by free fluid
    released,     // confined fluid released in the present step
    hydrostatic,  // part of pore_pressure that is hydrostatic
    count
};
inline constexpr std::size_t k_fields = static_cast<std::size_t>(Field::count);

struct FieldInfo {
    std::string_view name, unit;
    double initial;
};
inline constexpr std::array<FieldInfo, k_fields> k_field_table{{
    {"x", "m", 0},
    {"y", "m", 0},
    {"u", "m/s", 0},
    {"v", "m/s", 0},
    {"volume", "m3", 0},
    {"area", "m2", 0},
    {"c_xx", "1/s", 0},
    {"c_xy", "1/s", 0},
    {"c_yx", "1/s", 0},
    {"c_yy", "1/s", 0},
    {"compression", "1/s", 0},
    {"s_xx", "m2/s2", 0},
    {"s_xy", "m2/s2", 0},
    {"s_yy", "m2/s2", 0},
    {"q_xx", "m2", 0},
    {"q_xy", "m2", 0},
    {"q_yy", "m2", 0},
    {"flown", "-", 0},
    {"pore_pressure", "-", 0},
    {"solids", "-", 0},
    {"confined", "m3", 0},
    {"confined_start", "m3", 0},
    {"pores", "m3", 0},
    {"t_xx", "Pa", 0},
    {"t_yy", "Pa", 0},
    {"t_zz", "Pa", 0},
    {"t_xy", "Pa", 0},
    {"e_xx", "-", 0},
    {"e_yy", "-", 0},
    {"e_xy", "-", 0},
    {"damage", "-", 0},
    {"cohesion_ratio", "-", 1},
    {"cohesion", "Pa", 0},
    {"friction", "-", 0},
    {"bed_friction", "-", 0},
    {"grain_density", "kg/m3", 0},
    {"grain_diameter", "m", 0},
    {"push_x", "m/s2", 0},
    {"push_y", "m/s2", 0},
    {"flatness", "-", 1},
    {"submergence", "-", 0},
    {"released", "m3", 0},
    {"hydrostatic", "-", 0},
}};

/// A set of fields, as bits.
class FieldMask {
  public:
    constexpr FieldMask() = default;
    constexpr FieldMask(std::initializer_list<Field> fields) {
        for (Field f : fields) bits_ |= bit(f);
    }
    [[nodiscard]] constexpr bool has(Field f) const noexcept { return (bits_ & bit(f)) != 0; }
    constexpr FieldMask operator|(FieldMask other) const noexcept {
        other.bits_ |= bits_;
        return other;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return static_cast<std::size_t>(std::popcount(bits_)); }

  private:
    static constexpr std::uint64_t bit(Field f) { return std::uint64_t{1} << static_cast<unsigned>(f); }
    static_assert(k_fields <= 64);
    std::uint64_t bits_ = 0;
};

inline constexpr FieldMask k_basic_fields{Field::x, Field::y, Field::u, Field::v, Field::volume, Field::area};
inline constexpr FieldMask k_affine_fields{Field::c_xx, Field::c_xy, Field::c_yx, Field::c_yy};
inline constexpr FieldMask k_stress_fields{Field::s_xx, Field::s_xy, Field::s_yy};
inline constexpr FieldMask k_shape_fields{Field::q_xx, Field::q_xy, Field::q_yy};

/// One particle with all fields: for seeding, splitting and merging, never for inner loops.
using ParticleRow = std::array<double, k_fields>;

/// Particles as one array per field, all in local metres. Fields outside the mask have no storage.
class ParticleSet {
  public:
    explicit ParticleSet(FieldMask mask = k_basic_fields) : mask_(mask) {}

    [[nodiscard]] FieldMask mask() const noexcept { return mask_; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] std::size_t bytes_per_particle() const noexcept { return mask_.size() * sizeof(double); }

    /// Returns the array of a field; null if the set does not have the field.
    [[nodiscard]] double* operator[](Field f) noexcept {
        return mask_.has(f) ? arrays_[static_cast<std::size_t>(f)].data() : nullptr;
    }
    [[nodiscard]] const double* operator[](Field f) const noexcept {
        return mask_.has(f) ? arrays_[static_cast<std::size_t>(f)].data() : nullptr;
    }

    /// Changes the number; new particles get the initial values of the table.
    void resize(std::size_t size) {
        for (std::size_t f = 0; f < k_fields; ++f) {
            if (mask_.has(static_cast<Field>(f))) arrays_[f].resize(size, k_field_table[f].initial);
        }
        size_ = size;
    }
    [[nodiscard]] ParticleRow row(std::size_t i) const {
        ParticleRow r;
        for (std::size_t f = 0; f < k_fields; ++f) {
            r[f] = mask_.has(static_cast<Field>(f)) ? arrays_[f][i] : k_field_table[f].initial;
        }
        return r;
    }
    void set_row(std::size_t i, const ParticleRow& r) {
        for (std::size_t f = 0; f < k_fields; ++f) {
            if (mask_.has(static_cast<Field>(f))) arrays_[f][i] = r[f];
        }
    }
    void push_back(const ParticleRow& r) {
        resize(size_ + 1);
        set_row(size_ - 1, r);
    }
    /// Rebuilds all particles, `size` of them, field by field in `tasks` parallel parts: fill(field, from, to, part)
    /// writes its part of `to`, the field's new array, from the old one. One spare array serves all fields and the next
    /// call.
    template <class Fill>
    void rebuild(std::size_t size, std::size_t tasks, const Fill& fill, ThreadPool& pool) {
        for (std::size_t f = 0; f < k_fields; ++f) {
            if (!mask_.has(static_cast<Field>(f))) continue;
            spare_.resize(size);
            const double* const from = arrays_[f].data();
            double* const to = spare_.data();
            pool.for_each(tasks, [&](std::size_t part) { fill(static_cast<Field>(f), from, to, part); });
            arrays_[f].swap(spare_);
        }
        size_ = size;
    }
    /// Both sides must have the same fields.
    template <class Archive>
    void serialise(Archive& archive) {
        archive(size_);
        for (std::size_t f = 0; f < k_fields; ++f) {
            bool has = mask_.has(static_cast<Field>(f));
            archive(has);
            if constexpr (Archive::k_reads) archive.require(has == mask_.has(static_cast<Field>(f)));
            if (!has) continue;
            archive(arrays_[f]);
            if constexpr (Archive::k_reads) archive.require(arrays_[f].size() == size_);
        }
    }
    /// Returns a row with every field at its initial value.
    static ParticleRow initial_row() {
        ParticleRow r;
        for (std::size_t f = 0; f < k_fields; ++f) r[f] = k_field_table[f].initial;
        return r;
    }

  private:
    FieldMask mask_;
    std::size_t size_ = 0;
    std::array<std::vector<double>, k_fields> arrays_;
    std::vector<double> spare_;
};

/// Shorthand for ParticleRow access.
inline double& get(ParticleRow& r, Field f) {
    return r[static_cast<std::size_t>(f)];
}
inline double get(const ParticleRow& r, Field f) {
    return r[static_cast<std::size_t>(f)];
}

}  // namespace frana
