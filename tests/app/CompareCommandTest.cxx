#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "Program.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

namespace {

using nlohmann::json;

std::string surface(const TemporaryFolder& folder, const std::string& name, const std::string& scheme = "spline") {
  EXPECT_EQ(runMien({"surface", "--scheme", scheme, "-o", folder.file(name)}).exitCode, 0);
  return folder.file(name);
}

json comparison(const std::string& a, const std::string& b) {
  const Outcome outcome = runMien({"compare", a, b, "--json"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return json::parse(outcome.output, nullptr, false);
}

TEST(CompareCommand, TheSameSurfaceInEveryFormatHasNoDistance) {
  const TemporaryFolder folder;
  const std::string grid = surface(folder, "a.vts");
  for (const char* const name : {"b.vtp", "b.ply", "b.obj", "b.stl"}) {
    const json result = comparison(grid, surface(folder, name));
    for (const char* const way : {"a_to_b", "b_to_a"}) {
      EXPECT_LT(result[way]["rms_mm"], 1e-3) << name;  // text and single precision
      EXPECT_LT(result[way]["max_mm"], 1e-2) << name;
    }
  }
}

TEST(CompareCommand, UnitsOfTheOtherSurfaceAreToldOrDoubted) {
  const TemporaryFolder folder;
  const std::string metres = folder.file("metres.obj"), millimetres = folder.file("millimetres.obj");
  std::ofstream(metres) << "v 0 0 0\nv 0.1 0 0\nv 0.1 0.2 0\nv 0 0.2 0\nf 1 2 3 4\n";
  std::ofstream(millimetres) << "v 0 0 0\nv 100 0 0\nv 100 200 0\nv 0 200 0\nf 1 2 3 4\n";
  const Outcome doubted = runMien({"compare", millimetres, metres, "--json"});
  EXPECT_NE(doubted.errors.find("are both in mm? --units"), std::string::npos) << doubted.errors;
  const Outcome told = runMien({"compare", millimetres, metres, "--units", "m", "--json"});
  EXPECT_EQ(told.errors, "");
  EXPECT_LT(json::parse(told.output)["b_to_a"]["max_mm"], 1e-4);
  EXPECT_EQ(runMien({"compare", millimetres, metres, "--units", "mile"}).exitCode, 2);
}

TEST(CompareCommand, WhatTheOtherSurfaceDoesNotCoverCanBeLeftOut) {
  const TemporaryFolder folder;
  const auto square = [&](const std::string& name, double size, double height) {
    const std::string a = std::to_string(-size), b = std::to_string(size), z = " " + std::to_string(height) + "\n";
    writeTextFile(folder.file(name), "v " + a + " " + a + z + "v " + b + " " + a + z + "v " + b + " " + b + z + "v " +
                                         a + " " + b + z + "v 1 2" + z + "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    return folder.file(name);
  };
  const std::string small = square("small.obj", 10.0, 3.0), large = square("large.obj", 40.0, 1.0);
  const json all = comparison(small, large);
  EXPECT_FALSE(all["covered"]);
  EXPECT_GT(all["b_to_a"]["max_mm"], 40.0);
  const Outcome outcome = runMien({"compare", small, large, "--covered", "-o", folder.file("d.vtp")});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("Covered: points whose nearest point lies on the rim"), std::string::npos)
      << outcome.output;
  const json covered = json::parse(runMien({"compare", small, large, "--covered", "--json"}).output);
  EXPECT_TRUE(covered["covered"]);
  EXPECT_NEAR(covered["a_to_b"]["max_mm"].get<double>(), 2.0, 1e-6);
  EXPECT_NEAR(covered["b_to_a"]["max_mm"].get<double>(), 2.0, 1e-6);
  EXPECT_EQ(covered["b_to_a"]["points"], 1);
  EXPECT_NE(runMien({"compare", "--help"}).output.find("--covered"), std::string::npos);
}

TEST(CompareCommand, WaysAreExchangedWithTheSurfaces) {
  const TemporaryFolder folder;
  const std::string a = surface(folder, "a.vts"), b = surface(folder, "b.ply", "four-curve");
  const json forth = comparison(a, b), back = comparison(b, a);
  EXPECT_GT(forth["a_to_b"]["rms_mm"], 0.05);
  EXPECT_NEAR(forth["a_to_b"]["rms_mm"].get<double>(), back["b_to_a"]["rms_mm"].get<double>(), 1e-9);
  EXPECT_NEAR(forth["b_to_a"]["max_mm"].get<double>(), back["a_to_b"]["max_mm"].get<double>(), 1e-9);
}

TEST(CompareCommand, TheFirstSurfaceIsWrittenWithItsDistances) {
  const TemporaryFolder folder;
  const std::string a = surface(folder, "a.vts"), b = surface(folder, "b.ply", "four-curve");
  ASSERT_EQ(runMien({"compare", a, b, "-o", folder.file("d.vtp"), "-o", folder.file("d.svg")}).exitCode, 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("d.vtp").c_str());
  reader->Update();
  vtkDataArray* distances = reader->GetOutput()->GetPointData()->GetArray("Distance");
  ASSERT_NE(distances, nullptr);
  EXPECT_NEAR(distances->GetRange()[1], comparison(a, b)["a_to_b"]["max_mm"].get<double>(), 1e-9);
  EXPECT_NE(readTextFile(folder.file("d.svg")).find("a.vts to b.ply"), std::string::npos);
}

TEST(CompareCommand, WhatIsNoSurfaceIsRefused) {
  const TemporaryFolder folder;
  const std::string a = surface(folder, "a.vtp");
  writeTextFile(folder.file("bad.ply"), "ply\nformat ascii 1.0\nelement vertex 3\n");
  writeTextFile(folder.file("bad.vts"), "<VTKFile");
  EXPECT_EQ(runMien({"compare", a, folder.file("bad.ply")}).exitCode, 1);
  EXPECT_EQ(runMien({"compare", a, folder.file("bad.vts")}).exitCode, 1);
  EXPECT_EQ(runMien({"compare", a, folder.file("missing.obj")}).exitCode, 1);
  EXPECT_EQ(runMien({"compare", a, folder.file("a.txt")}).exitCode, 2);
  EXPECT_EQ(runMien({"compare", a}).exitCode, 2);
}

}  // namespace
