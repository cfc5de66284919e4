// exr_stream.h - lets OpenEXR write a file that appears whole or not at all.
#pragma once

#include "io/output_file.h"

#include <firsthit/error.h>

#include <ImfIO.h>

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// An output stream of OpenEXR that writes to an OutputFile.
class ExrStream : public Imf::OStream {
  public:
    explicit ExrStream(OutputFile& file) : Imf::OStream(file.path().c_str()), file_(file) {}
    void write(const char c[], int n) override { file_.write(c, static_cast<std::size_t>(n)); }
    /// OpenEXR also calls this from a destructor, so errors are not thrown here but by the next
    /// write.
    std::uint64_t tellp() override
    {
        try {
            return file_.tell();
        } catch (const FileError&) {
            return 0;
        }
    }
    void seekp(std::uint64_t position) override { file_.seek(position); }

  private:
    OutputFile& file_;
};

} // namespace firsthit
