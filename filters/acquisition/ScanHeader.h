#pragma once

#include <cstdint>
#include <string>

namespace mien {

/// Whether a scan's header promises more vertices or faces than its file can hold, or fewer than none, which OpenMesh
/// would allocate unseen.
///
/// @param start   the first bytes of the file, header included
/// @param ending  ".ply", ".off" or ".stl" (".obj" has no header)
/// @param size    bytes of the whole file; every vertex and face takes at least one
bool promisesTooMuch(const std::string& start, const std::string& ending, std::uintmax_t size);

}  // namespace mien
