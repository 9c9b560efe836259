#pragma once

namespace CLI {
class App;
}

namespace mien {

/// The commands of `mien fdt`, each a file of its own.
void addFdtFitCommand(CLI::App& parent);
void addFdtMeanCommand(CLI::App& parent);
void addFdtApplyCommand(CLI::App& parent);
void addFdtClassifyCommand(CLI::App& parent);
void addFdtCheckCommand(CLI::App& parent);
void addFdtShowCommand(CLI::App& parent);
void addFdtMirrorCommand(CLI::App& parent);
void addFdtBlendCommand(CLI::App& parent);
void addFdtFromFapCommand(CLI::App& parent);
void addFdtPackCommand(CLI::App& parent);

}  // namespace mien
