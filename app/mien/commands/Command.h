#pragma once

namespace CLI {
class App;
}

namespace mien {

/// Each command is one file, which adds itself to the program: its options, its help with an example, what it does.
/// What goes wrong is thrown as a Failure.
void addInfoCommand(CLI::App& program);
void addSurfaceCommand(CLI::App& program);
void addCurvesCommand(CLI::App& program);
void addPatchCommand(CLI::App& program);
void addRenderCommand(CLI::App& program);
void addAnimateCommand(CLI::App& program);
void addConvertCommand(CLI::App& program);
void addAcquireCommand(CLI::App& program);
void addAdaptCommand(CLI::App& program);
void addEditCommand(CLI::App& program);
void addContinuityCommand(CLI::App& program);
void addSpectrumCommand(CLI::App& program);
void addSweepCommand(CLI::App& program);
void addInfluenceCommand(CLI::App& program);
void addEnsembleCommand(CLI::App& program);
void addCompareCommand(CLI::App& program);
void addVectorsCommand(CLI::App& program);
void addTextureCommand(CLI::App& program);
void addLodCommand(CLI::App& program);
void addFatCommand(CLI::App& program);
void addFdtCommand(CLI::App& program);
void addFigureCommand(CLI::App& program);
void addReferenceCommand(CLI::App& program);

}  // namespace mien
