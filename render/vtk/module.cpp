// SPDX-License-Identifier: Apache-2.0
#include "core/module.h"

#include "render/vtk/functions.h"
#include "render/vtk/points.h"
#include "render/vtk/terrain_scene.h"
#include "render/vtk/triangles.h"

FRANA_MODULE(frana::render::VtkFunctions, {.draw_triangles = frana::render::draw_triangles,
                                           .terrain_scene = frana::render::terrain_scene,
                                           .write_points = frana::render::write_points})
