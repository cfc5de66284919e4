// baseline.h - what the benchmarks against Embree share: a scene of the command line, and medians.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace firsthit {

inline double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// "SCENE" or "SCENE@SECONDS".
struct SceneArgument {
    std::string scene;
    double time_s = 0;
    std::string name; // to print: without folders

    explicit SceneArgument(const std::string& argument)
        : scene(argument.substr(0, argument.find('@'))),
          name(argument.substr(argument.find_last_of('/') + 1))
    {
        if (scene.size() < argument.size()) time_s = std::atof(argument.c_str() + scene.size() + 1);
    }
};

} // namespace firsthit
