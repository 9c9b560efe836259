#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "PipelineErrors.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "vtkCallbackCommand.h"
#include "vtkFaceStudySource.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

using namespace mien;

namespace {

const char* const study =
    "{\"mien_study\": 1, \"schemes\": [\"four-curve\", \"spline\"], \"a\": [0.5, 1, 2], \"harmonics\": [4, 40],"
    "\"expressions\": [\"neutral\", \"joy:0.6,surprise:0.4\"], \"resolution\": [38, 20],"
    "\"measures\": [\"area_mm2\", \"motion_max_mm\"]}";
constexpr vtkIdType caseCount = 3 * 2 * 2 * 2;

struct StudyFolder {
  TemporaryFolder folder;
  std::string study = folder.file("study.json"), table = folder.file("table.csv");

  explicit StudyFolder(const std::string& text = ::study) { writeTextFile(study, text); }

  void connect(vtkFaceStudySource* source, bool keepsRows) const {
    source->SetStudyFileName(study.c_str());
    if (keepsRows) source->SetTableFileName(table.c_str());
  }
};

/// Every cell as text, by case.
using Rows = std::map<int, std::string>;
void addRows(vtkTable* table, Rows& rows) {
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i) {
    std::string text;
    for (vtkIdType k = 0; k < table->GetNumberOfColumns(); ++k) text += table->GetValue(i, k).ToString() + "|";
    const int number = table->GetValueByName(i, "case").ToInt();
    EXPECT_TRUE(rows.emplace(number, text).second) << "case " << number << " came twice";
  }
}

Rows rowsOfPieces(vtkFaceStudySource* source, int pieces) {
  Rows rows;
  for (int piece = 0; piece < pieces; ++piece) {
    source->UpdatePiece(piece, pieces, 0);
    addRows(source->GetOutput(), rows);
  }
  return rows;
}

}  // namespace

TEST(FaceStudySource, GivesARowForEachCase) {
  const StudyFolder files;
  vtkNew<vtkFaceStudySource> source;
  files.connect(source, false);
  source->Update();
  vtkTable* const table = source->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), caseCount);
  EXPECT_EQ(source->GetNumberOfComputedCases(), caseCount);
  EXPECT_EQ(table->GetNumberOfColumns(), 8 + 2 + 1);
  int moved = 0;
  for (vtkIdType i = 0; i < caseCount; ++i) {
    EXPECT_EQ(table->GetValueByName(i, "case").ToInt(), i);
    EXPECT_TRUE(std::isnan(table->GetValueByName(i, "frame").ToDouble()));
    const bool isAtRest = table->GetValueByName(i, "expression").ToString() == "neutral";
    if (!isAtRest) {
      EXPECT_EQ(table->GetValueByName(i, "expression").ToString(), "joy:0.6,surprise:0.4");
    }
    const double motion = table->GetValueByName(i, "motion_max_mm").ToDouble();
    if (table->GetValueByName(i, "reason").ToString().empty()) {
      EXPECT_GT(table->GetValueByName(i, "area_mm2").ToDouble(), 1e4);
      EXPECT_EQ(motion == 0.0, isAtRest);
      moved += motion > 1.0;
    }
  }
  EXPECT_GT(moved, 0);
}

TEST(FaceStudySource, PiecesShareTheCases) {
  const StudyFolder files;
  vtkNew<vtkFaceStudySource> whole;
  files.connect(whole, false);
  const Rows rows = rowsOfPieces(whole, 1);
  ASSERT_EQ(rows.size(), caseCount);
  for (const int pieces : {2, 3, 9}) {
    vtkNew<vtkFaceStudySource> source;
    files.connect(source, false);
    EXPECT_EQ(rowsOfPieces(source, pieces), rows) << pieces;
  }
}

TEST(FaceStudySource, RowsThatAreKeptAreNotComputedAgain) {
  const StudyFolder files;
  vtkNew<vtkFaceStudySource> whole, first, others;
  files.connect(whole, false);
  files.connect(first, true);
  files.connect(others, true);
  first->UpdatePiece(1, 3, 0);
  const vtkIdType computed = first->GetNumberOfComputedCases();
  EXPECT_GT(computed, 0);
  EXPECT_EQ(entriesIn(files.folder.file("")), 2) << "the study and one part";
  Rows rows;
  vtkIdType others_computed = 0;
  for (int piece = 0; piece < 2; ++piece) {
    others->UpdatePiece(piece, 2, 0);
    addRows(others->GetOutput(), rows);
    others_computed += others->GetNumberOfComputedCases();
  }
  EXPECT_EQ(others_computed, caseCount - computed);
  EXPECT_EQ(rows, rowsOfPieces(whole, 1));
  EXPECT_TRUE(others->WriteTable());
  EXPECT_EQ(entriesIn(files.folder.file("")), 2) << "the study and its table";
  vtkNew<vtkFaceStudySource> again;
  files.connect(again, true);
  EXPECT_EQ(rowsOfPieces(again, 1), rows);
  EXPECT_EQ(again->GetNumberOfComputedCases(), 0);
}

TEST(FaceStudySource, NoTableIsWrittenBeforeAllIsDone) {
  const StudyFolder files;
  vtkNew<vtkFaceStudySource> source;
  files.connect(source, true);
  PipelineErrors errors;
  errors.observe(source);
  source->UpdatePiece(0, 2, 0);
  EXPECT_FALSE(source->WriteTable());
  EXPECT_NE(errors.first().find("of 24 cases are in no part beside it"), std::string::npos) << errors.first();
  EXPECT_FALSE(std::filesystem::exists(files.table));
}

TEST(FaceStudySource, AnAbortKeepsWhatIsDone) {
  const StudyFolder files;
  vtkNew<vtkFaceStudySource> source;
  files.connect(source, true);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = source->AddObserver(vtkCommand::ProgressEvent, abort);
  source->SetNumberOfThreads(1);
  source->Update();
  const vtkIdType computed = source->GetNumberOfComputedCases();
  EXPECT_LT(computed, caseCount);
  source->RemoveObserver(tag);
  source->SetAbortExecute(0);
  source->Modified();
  source->Update();
  EXPECT_EQ(source->GetNumberOfComputedCases(), caseCount - computed);
  EXPECT_EQ(source->GetOutput()->GetNumberOfRows(), caseCount);
}

TEST(FaceStudySource, RunsAgainOnlyWhenSomethingIsSet) {
  const StudyFolder files;
  vtkNew<vtkFaceStudySource> source;
  files.connect(source, false);
  source->Update();
  const vtkMTimeType time = source->GetOutput()->GetMTime();
  source->SetStudyFileName(files.study.c_str());
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetMTime(), time);
  source->SetNumberOfThreads(2);
  source->Update();
  EXPECT_GT(source->GetOutput()->GetMTime(), time);
}

TEST(FaceStudySource, WhatIsWrongIsOneSentence) {
  const StudyFolder files("{\"mien_study\": 1,\n \"a\": [1,}");
  vtkNew<vtkFaceStudySource> source;
  PipelineErrors errors;
  errors.observe(source);
  const auto expectFault = [&](const std::string& sentence) {
    errors.clear();
    source->Modified();
    source->Update();
    EXPECT_NE(errors.first().find(sentence), std::string::npos) << errors.first();
  };
  expectFault("no study is given");
  errors.clear();
  EXPECT_FALSE(source->WriteTable());
  EXPECT_NE(errors.first().find("no table is given"), std::string::npos) << errors.first();
  files.connect(source, false);
  expectFault(files.study + ":2: study: it is no valid JSON");
  source->SetStudyFileName(files.folder.file("none.json").c_str());
  expectFault(files.folder.file("none.json"));
  source->SetStudyFileName(files.study.c_str());
  writeTextFile(files.study, study);
  source->SetTableFileName(files.folder.file("none/table.csv").c_str());
  expectFault("cannot be written");
}
