#pragma once

#include <array>

namespace mien {

/// A colour for each of the nine patches, 0xrrggbb, told apart without colour vision too (Paul Tol's muted scheme).
constexpr std::array<int, 9> patchColors = {0x332288, 0x88ccee, 0x44aa99, 0x117733, 0x999933,
                                            0xddcc77, 0xcc6677, 0x882255, 0xaa4499};

}  // namespace mien
