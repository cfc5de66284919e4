// program.cpp - compiles and links shaders from the texts that are embedded in the library.
#include "gl/device/program.h"

#include "gl/device/context.h"
#include "gl/device/shader_texts.h"
#include "material/glsl_models.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <fmt/format.h>

#include <algorithm>

namespace firsthit::gl {
namespace {

/// The texts of src/glsl and src/material, and gl/*.glsl, are compiled as C++ and as GLSL. This
/// defines, in GLSL, the words that they use.
constexpr std::string_view kWords =
    "#version 450 core\n"
    "#define FIRSTHIT_PURE\n"
    "#define FIRSTHIT_UNUSED\n"
    "#define FIRSTHIT_PRECISE precise\n"
    "#define real float\n"
    "#define real2 vec2\n"
    "#define real3 vec3\n"
    "#define integer int\n"
    "#define truth bool\n"
    "#define all_lanes(v) (v)\n"
    "#define shift_left_23(a) ((a) << 23)\n"
    "#define shift_right_15(a) ((a) >> 15)\n"
    "#define shift_right_23(a) ((a) >> 23)\n"
    // gl/bindings.glsl, gl/layouts.glsl, gl/pose_layout.glsl
    "#define FIRSTHIT_CONSTANT(type, name, value) const type name = value;\n"
    "#define FIRSTHIT_STRUCT(name) struct name {\n"
    "#define FIRSTHIT_FIELD(type, name, value) type name;\n"
    "#define FIRSTHIT_NESTED(type, name) type name;\n"
    "#define FIRSTHIT_ARRAY(type, name, count) type name[count];\n"
    "#define FIRSTHIT_END(name) };\n";

std::string_view file_of(std::string_view name)
{
    return name.substr(name.rfind('/') + 1); // npos + 1 is 0
}

const ShaderText& find_text(std::string_view name)
{
    static const std::string kModelsText = glsl_models();
    static const ShaderText kModels{"material/models.glsl", kModelsText};
    if (file_of(kModels.name) == name) return kModels;
    for (const ShaderText& text : shader_texts())
        if (text.name == name || file_of(text.name) == name) return text;
    throw ArgumentError(fmt::format("there is no shader text '{}'", name));
}

GLenum type_of(std::string_view name)
{
    const auto ends = [&](std::string_view ending) { return name.ends_with(ending); };
    if (ends(".vert")) return GL_VERTEX_SHADER;
    if (ends(".frag")) return GL_FRAGMENT_SHADER;
    if (ends(".geom")) return GL_GEOMETRY_SHADER;
    if (ends(".comp")) return GL_COMPUTE_SHADER;
    throw ArgumentError(fmt::format(
        "shader text '{}' is no stage: .vert, .frag, .geom and .comp are accepted", name));
}

/// Appends a text and the texts that it includes, except those that the source has already.
void append_text(std::string_view name, ShaderSource& source)
{
    const ShaderText& text = find_text(name);
    if (std::find(source.files.begin(), source.files.end(), text.name) != source.files.end())
        return;
    const std::size_t number = source.files.size();
    source.files.push_back(text.name);
    source.text += fmt::format("#line 1 {}\n", number);
    std::string_view rest = text.text;
    for (int line = 1; !rest.empty(); ++line) {
        const std::string_view row = rest.substr(0, std::min(rest.find('\n'), rest.size()));
        rest.remove_prefix(std::min(row.size() + 1, rest.size()));
        constexpr std::string_view kInclude = "#include \"";
        if (row.starts_with(kInclude)) {
            const std::string_view named = row.substr(kInclude.size());
            append_text(named.substr(0, named.find('"')), source);
            source.text += fmt::format("#line {} {}\n", line + 1, number);
        } else {
            source.text.append(row).append("\n");
        }
    }
}

/// The files by number, for error messages: compilers' logs refer to files by number.
std::string file_list(const ShaderSource& source)
{
    std::string list;
    for (std::size_t k = 0; k < source.files.size(); ++k)
        list += fmt::format("{}{} = {}", k > 0 ? ", " : "", k, source.files[k]);
    return list;
}

std::string trimmed(std::string log)
{
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0' || log.back() == ' '))
        log.pop_back();
    return log;
}

/// Compiles shaders and links them to a program. Deletes the shaders, also on errors.
class Linker {
  public:
    Linker() { program_.create(); }
    ~Linker()
    {
        for (const GLuint shader : shaders_) ShaderKind::remove(shader);
    }
    Linker(const Linker&) = delete;
    Linker& operator=(const Linker&) = delete;

    void add(const ShaderSource& source)
    {
        const GLuint shader = ShaderKind::make(source.type);
        shaders_.push_back(shader);
        const char* const text = source.text.c_str();
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        GLint good = GL_FALSE, length = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
        if (!good) {
            glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
            std::string log(std::size_t(std::max(length, 1)), '\0');
            glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
            throw DeviceError(fmt::format("OpenGL: the shader does not compile ({}; {}):\n{}",
                file_list(source), driver_name(), trimmed(log)));
        }
        glAttachShader(program_.name(), shader);
        names_ += (names_.empty() ? "" : ", ") + std::string(source.files.front());
    }

    Program link()
    {
        glLinkProgram(program_.name());
        GLint good = GL_FALSE, length = 0;
        glGetProgramiv(program_.name(), GL_LINK_STATUS, &good);
        if (!good) {
            glGetProgramiv(program_.name(), GL_INFO_LOG_LENGTH, &length);
            std::string log(std::size_t(std::max(length, 1)), '\0');
            glGetProgramInfoLog(program_.name(), GLsizei(log.size()), nullptr, log.data());
            throw DeviceError(fmt::format("OpenGL: the shaders do not fit together ({}; {}):\n{}",
                names_, driver_name(), trimmed(log)));
        }
        check("linking shaders");
        for (const GLuint shader : shaders_) {
            glDetachShader(program_.name(), shader);
            ShaderKind::remove(shader);
        }
        shaders_.clear();
        return std::move(program_);
    }

  private:
    Program program_;
    std::vector<GLuint> shaders_;
    std::string names_;
};

} // namespace

ShaderSource shader_source(std::string_view name, std::span<const Define> defines)
{
    ShaderSource source;
    source.type = type_of(name);
    source.text = fmt::format("{}#define kNoItem {}u\n", kWords, kNoItem);
    for (const Define& define : defines)
        source.text += "#define " + define.name + " " + define.value + "\n";
    append_text(name, source);
    return source;
}

Program link_program(std::initializer_list<std::string_view> names, std::span<const Define> defines)
{
    Linker linker;
    for (const std::string_view name : names) linker.add(shader_source(name, defines));
    return linker.link();
}

Program link_source(const ShaderSource& source)
{
    Linker linker;
    linker.add(source);
    return linker.link();
}

} // namespace firsthit::gl
