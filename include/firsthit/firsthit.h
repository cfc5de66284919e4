// firsthit.h - all of the library.
#pragma once

#include <firsthit/baseline.h>
#include <firsthit/compare.h>
#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/film.h>
#include <firsthit/frame_control.h>
#include <firsthit/material.h>
#include <firsthit/normals.h>
#include <firsthit/npy.h>
#include <firsthit/occlusion.h>
#include <firsthit/render.h>
#include <firsthit/scene.h>
#include <firsthit/settings.h>
#include <firsthit/stats.h>
#include <firsthit/view.h>

/// All of the library.
namespace firsthit {
}
