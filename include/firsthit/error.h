// error.h - the exceptions of the library. The library never prints and never exits.
#pragma once

#include <stdexcept>
#include <string>

namespace firsthit {

/// The base of all errors. The message names what was asked for, the value, what is accepted, and
/// the place.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A file cannot be opened, read, parsed or written.
class FileError : public Error {
  public:
    using Error::Error;
};

/// A scene is invalid: for example, an index is out of range or a coordinate is NaN.
class SceneError : public Error {
  public:
    using Error::Error;
};

/// The caller passed a value outside the documented range.
class ArgumentError : public Error {
  public:
    using Error::Error;
};

/// Something that was explicitly asked for is not available, or fails: OpenGL, Embree, GPU memory.
class DeviceError : public Error {
  public:
    using Error::Error;
};

/// The caller cancelled the work (frame_control.h).
class Cancelled : public Error {
  public:
    using Error::Error;
};

} // namespace firsthit
