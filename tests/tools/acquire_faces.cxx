// mien acquire in its narrowest form: OUTPUT LANDMARKS SCAN...; several scans give their symmetric mean.
#include "Acquire.h"

#include <iostream>

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: acquire_faces OUTPUT.vtp LANDMARKS.csv SCAN...\n";
    return 2;
  }
  mien::AcquireOptions options;
  options.outputFile = argv[1];
  options.landmarkFile = argv[2];
  options.scans.assign(argv + 3, argv + argc);
  options.mean = argc > 4;
  const std::string fault = mien::acquire(options);
  if (!fault.empty()) std::cerr << fault << "\n";
  return fault.empty() ? 0 : 1;
}
