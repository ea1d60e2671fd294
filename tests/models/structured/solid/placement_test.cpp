// SPDX-License-Identifier: Apache-2.0
// Where particles of structured solids begin.
#include <gtest/gtest.h>

#include <cmath>

#include "models/structured/solid/column_state.h"
#include "models/structured/solid/placement.h"

namespace frana::structured::test {
namespace {

double total(const ParticleSet& particles, Field field) {
    double sum = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) sum += particles[field][p];
    return sum;
}

TEST(Placement, SplitsColumnsIntoPhases) {
    ParticleSet columns;
    ParticleRow r = ParticleSet::initial_row();
    get(r, Field::volume) = 10;
    get(r, Field::area) = 2;
    columns.push_back(r);
    SolidMaterial material;
    material.solid_fraction = 0.6;
    material.confined_fraction = 0.75;
    material.cohesion = 1e4;
    material.friction = 0.5;
    const auto everywhere = [&](Point) { return material; };
    const ParticleSet split = split_phases(columns, everywhere);
    EXPECT_DOUBLE_EQ(split[Field::volume][0], 6);
    EXPECT_DOUBLE_EQ(split[Field::confined][0], 3);
    const ParticleSet whole = assign_material(split, solid_fields(true, true), everywhere);
    EXPECT_EQ(whole[Field::cohesion_ratio][0], 1);
    EXPECT_EQ(whole[Field::friction][0], 0.5);
    EXPECT_EQ(whole[Field::confined][0], split[Field::confined][0]);

    material.cohesion = 0;  // nothing that could hold the fluid
    EXPECT_EQ(split_phases(columns, everywhere)[Field::confined][0], 0);
    EXPECT_EQ(assign_material(split, solid_fields(true, true), everywhere)[Field::cohesion_ratio][0], 0);
}

TEST(Placement, SharesOutColumnsThatAreTooThin) {
    ParticleSet columns(k_basic_fields);
    const double depths[] = {2, 1, 1e-17, 5e-5};
    for (const double depth : depths) {
        ParticleRow r = ParticleSet::initial_row();
        get(r, Field::area) = 4;
        get(r, Field::volume) = 4 * depth;
        columns.push_back(r);
    }
    const auto everywhere = [](Point) {
        SolidMaterial m;
        m.solid_fraction = 0.6;
        m.cohesion = 1000;
        return m;
    };
    const ParticleSet thick = split_phases(columns, everywhere, 1e-4), all = split_phases(columns, everywhere);
    ASSERT_EQ(all.size(), 4U);
    ASSERT_EQ(thick.size(), 2U);
    for (const Field field : {Field::volume, Field::confined}) {
        EXPECT_NEAR(total(thick, field), total(all, field), 1e-15 * total(all, field));
        EXPECT_NEAR(thick[field][0] / thick[field][1], 2, 1e-14);
    }
    EXPECT_EQ(split_phases(columns, everywhere, 3).size(), 4U);  // there are no others
}

}  // namespace
}  // namespace frana::structured::test
