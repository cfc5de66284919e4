// machine.cpp - what a measurement was made on.
#include "bench/report/machine.h"

#include "bench/report/build_info.h"

#include <firsthit/error.h>
#include <firsthit/render.h>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <thread>

namespace firsthit::cli::bench {

namespace {

/// "model name : X" of the first core.
std::string cpu_name()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t at = line.find_first_not_of(": \t", line.find(':'));
        if (at != std::string::npos) return line.substr(at);
    }
    return "unknown";
}

std::string system_name()
{
    utsname name{};
    if (uname(&name) != 0) return "unknown";
    return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

std::string opengl_name()
{
    World world;
    pose(load_scene("builtin:torus"), 0, world);
    View view;
    view.camera = framing_camera(world);
    view.width = view.height = 8;
    Settings settings;
    settings.engine = Engine::gpu;
    settings.shadows = Shadows::none;
    Renderer renderer(1);
    Film film;
    try {
        renderer.render(world, view, settings, film);
        return renderer.engine().device;
    } catch (const DeviceError& error) {
        return error.what();
    }
}

} // namespace

Machine describe_machine()
{
    Machine machine;
    machine.cpu = cpu_name();
    machine.cores = std::thread::hardware_concurrency();
    machine.memory_bytes = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                           static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    machine.system = system_name();
    machine.instruction_set = instruction_set();
    machine.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    machine.firsthit = version();
    machine.commit = kCommit;
    machine.compiler = kCompiler;
    machine.build_type = kBuildType;
    machine.embree = kEmbreeVersion;
    machine.opengl = opengl_name();
    return machine;
}

Json machine_json(const Machine& machine)
{
    return {
        {"cpu", machine.cpu},
        {"cores", machine.cores},
        {"memory_bytes", machine.memory_bytes},
        {"system", machine.system},
        {"instruction_set", machine.instruction_set},
        {"date", machine.date},
        {"firsthit", machine.firsthit},
        {"commit", machine.commit},
        {"compiler", machine.compiler},
        {"build_type", machine.build_type},
        {"embree", machine.embree},
        {"opengl", machine.opengl},
    };
}

Table machine_table(const Machine& machine)
{
    return {
        .title = "Machine and program",
        .head = {"", "value"},
        .rows =
            {
                {{"processor"}, {machine.cpu}},
                {{"cores"}, {fmt::format("{}", machine.cores)}},
                {{"memory"},
                    {fmt::format("{:.1f} GB", static_cast<double>(machine.memory_bytes) / 1e9)}},
                {{"system"}, {machine.system}},
                {{"instruction set"}, {machine.instruction_set}},
                {{"OpenGL"}, {machine.opengl}},
                {{"Firsthit"}, {machine.firsthit + ", commit " + machine.commit}},
                {{"compiler"}, {machine.compiler + ", " + machine.build_type}},
                {{"Embree"}, {machine.embree}},
                {{"date"}, {machine.date}},
            },
        .note = {},
    };
}

} // namespace firsthit::cli::bench
