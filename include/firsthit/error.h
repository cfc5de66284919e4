// error.h - what the library throws, by kind. It never prints and never exits.
#pragma once

#include <stdexcept>
#include <string>

namespace firsthit {

/// The root of all errors. The message names what was asked, the value, what is accepted, the
/// place.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A file cannot be opened, read, parsed or written.
class FileError : public Error {
  public:
    using Error::Error;
};

/// A scene contradicts itself: an index out of range, a coordinate that is no number.
class SceneError : public Error {
  public:
    using Error::Error;
};

/// The caller passed a value outside the documented range.
class ArgumentError : public Error {
  public:
    using Error::Error;
};

/// The machine lacks something that was asked for by name.
class DeviceError : public Error {
  public:
    using Error::Error;
};

/// The caller gave the work up (frame_control.h).
class Cancelled : public Error {
  public:
    using Error::Error;
};

} // namespace firsthit
