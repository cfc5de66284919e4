// firsthit.h - includes all public headers of the library.
#pragma once

#include <firsthit/baseline.h>
#include <firsthit/camera_file.h>
#include <firsthit/compare.h>
#include <firsthit/environment.h>
#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/file_pattern.h>
#include <firsthit/film.h>
#include <firsthit/film_data.h>
#include <firsthit/frame_control.h>
#include <firsthit/framing.h>
#include <firsthit/join.h>
#include <firsthit/material.h>
#include <firsthit/normals.h>
#include <firsthit/npy.h>
#include <firsthit/npz.h>
#include <firsthit/occlusion.h>
#include <firsthit/picture.h>
#include <firsthit/ray.h>
#include <firsthit/ray_caster.h>
#include <firsthit/render.h>
#include <firsthit/scene.h>
#include <firsthit/scene_builder.h>
#include <firsthit/sequence.h>
#include <firsthit/settings.h>
#include <firsthit/sky.h>
#include <firsthit/stats.h>
#include <firsthit/studio.h>
#include <firsthit/sun.h>
#include <firsthit/view.h>
#include <firsthit/world_parts.h>

/// All of the library.
namespace firsthit {
}
