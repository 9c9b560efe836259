/// The mean facial deformation table of several recordings: mean_table "COMMENT" RECORDING.csv ... > mean.csv
#include <iostream>

#include "DefaultRegions.h"
#include "TableFit.h"
#include "TableStatistics.h"
#include "TableText.h"
#include "TextFile.h"

int main(int argc, char** argv) {
  std::vector<mien::DeformationTable> tables;
  for (int i = 2; i < argc; ++i) {
    mien::MarkerTable markers;
    mien::TableFit fit;
    std::string fault = markers.parse(readTextFile(argv[i]));
    if (fault.empty()) fault = fit.fit(mien::samplesOf(markers, mien::defaultRegions()));
    if (!fault.empty()) {
      std::cerr << argv[i] << ":" << fault << "\n";
      return 1;
    }
    tables.push_back(fit.table);
  }
  if (tables.empty()) {
    std::cerr << "usage: mean_table COMMENT RECORDING.csv ...\n";
    return 2;
  }
  std::cout << mien::writeTable(mien::meanTable(tables), argv[1]);
}
