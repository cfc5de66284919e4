// try_in_child.h - work that may crash, first tried in a process of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace firsthit {

/// Runs work in a forked child, with limits on processor time and memory that grow with the size of a file, and
/// throws its result away. Where the child cannot be made the work is not tried.
///
/// name   of the file, for messages
/// bytes  of the file
/// work   must not throw; whatever it prints is dropped; returns false where memory was not enough
/// throws FileError: the child crashed or went beyond a limit
void try_in_child(const std::string& name, std::size_t bytes, const std::function<bool()>& work);

} // namespace firsthit
