# embed_texts.cmake - writes a C++ file that holds texts by name.
#   cmake -D ROOT=folder -D NAMES=a|b|... -D OUTPUT=file.cpp -P embed_texts.cmake
# NAMES are relative to ROOT.
string(REPLACE "|" ";" names "${NAMES}")
set(rows "")
foreach(name IN LISTS names)
    file(READ "${ROOT}/${name}" text)
    string(APPEND rows "    {\"${name}\", R\"firsthit(${text})firsthit\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Written by cmake/embed_texts.cmake.
#include \"gl/device/shader_texts.h\"

namespace firsthit::gl {
namespace {

constexpr ShaderText kTexts[] = {
${rows}};

} // namespace

std::span<const ShaderText> shader_texts()
{
    return kTexts;
}

} // namespace firsthit::gl
")
