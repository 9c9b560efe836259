#include <gtest/gtest.h>

#include <filesystem>

#include "FAPFrame.h"
#include "FAPSequence.h"
#include "FAPText.h"
#include "PipelineErrors.h"
#include "ReferenceData.h"
#include "TextFile.h"
#include "vtkFAPReader.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace {

std::string rampText(int frames, const std::string& rate = "10") {
  std::string text = "2.1 ramp " + rate + " " + std::to_string(frames) + "\n";
  for (int i = 0; i < frames; ++i)
    text += maskText({53}) + "\n" + std::to_string(i + 1) + " " + std::to_string(100 * i) + "\n";
  return text;
}

/// A file of its own for every test, removed at its end.
class FAPReader : public testing::Test {
 protected:
  FAPReader() {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    path = testing::TempDir() + "mien_" + name + ".fap";
    writeTextFile(path, rampText(5));
    reader->SetFileName(path.c_str());
  }
  ~FAPReader() override { std::filesystem::remove(path); }

  double value(const char* column) { return reader->GetOutput()->GetValueByName(0, column).ToDouble(); }
  double dataTime() { return reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()); }

  vtkNew<vtkFAPReader> reader;
  std::string path;
};

}  // namespace

TEST_F(FAPReader, PublishesTimeStepsInSeconds) {
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  ASSERT_EQ(information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[i], i / 10.0);
  EXPECT_EQ(information->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE())[1], 0.4);
  EXPECT_EQ(reader->GetNumberOfFrames(), 5);
  EXPECT_EQ(reader->GetFramesPerSecond(), 10.0);
  EXPECT_EQ(reader->GetName(), "ramp");
  EXPECT_EQ(reader->GetVersion(), "2.1");
  EXPECT_EQ(reader->GetFAPsUsed(), std::vector<int>{53});
  EXPECT_TRUE(reader->GetWarnings().empty());
  EXPECT_EQ(reader->GetIndexOfFrameNumber(3), 2);
  EXPECT_EQ(reader->GetIndexOfFrameNumber(0), -1);
}

TEST_F(FAPReader, GivesTheFirstFrameWithoutATimeAndTheFrameBeforeWithOne) {
  reader->Update();
  EXPECT_EQ(value("FAP53"), 0.0);
  EXPECT_EQ(value("frame"), 1.0);
  reader->UpdateTimeStep(0.3);
  EXPECT_EQ(value("FAP53"), 300.0);
  EXPECT_EQ(dataTime(), 0.3);
  reader->UpdateTimeStep(0.25);
  EXPECT_EQ(value("FAP53"), 200.0);
  EXPECT_EQ(dataTime(), 0.2);
  reader->UpdateTimeStep(-1.0);
  EXPECT_EQ(value("FAP53"), 0.0);
  reader->UpdateTimeStep(7.0);
  EXPECT_EQ(value("FAP53"), 400.0);
  EXPECT_EQ(dataTime(), 0.4);
}

TEST_F(FAPReader, EveryPublishedTimeGivesItsFrame) {
  writeTextFile(path, rampText(200, "29.97"));
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  for (int i = 0; i < 200; ++i) {
    reader->UpdateTimeStep(information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[i]);
    ASSERT_EQ(value("FAP53"), 100.0 * i);
  }
}

TEST_F(FAPReader, InterpolatesOnRequest) {
  reader->InterpolateOn();
  reader->UpdateTimeStep(0.25);
  EXPECT_NEAR(value("FAP53"), 250.0, 1e-9);
  EXPECT_EQ(dataTime(), 0.25);
  reader->UpdateTimeStep(0.1);
  EXPECT_EQ(value("FAP53"), 100.0);
}

TEST_F(FAPReader, AFrameIndexWinsOverTheTimeAndIsChecked) {
  reader->SetFrameIndex(2);
  reader->UpdateTimeStep(0.4);
  EXPECT_EQ(value("FAP53"), 200.0);
  EXPECT_EQ(dataTime(), 0.2);
  mien::PipelineErrors errors;
  errors.observe(reader);
  reader->SetFrameIndex(5);
  reader->Update();
  EXPECT_EQ(errors.first(), path + ": there is no frame with index 5; give 0 to 4, or -1 for the frame of the time");
}

TEST_F(FAPReader, TheSameRequestDoesNotRunTwiceAndChangesDo) {
  reader->UpdateTimeStep(0.2);
  const vtkMTimeType first = reader->GetOutput()->GetMTime();
  reader->UpdateTimeStep(0.2);
  EXPECT_EQ(reader->GetOutput()->GetMTime(), first);
  const vtkMTimeType before = reader->GetMTime();
  reader->SetFrameIndex(reader->GetFrameIndex());
  reader->SetFileName(path.c_str());
  EXPECT_EQ(reader->GetMTime(), before) << "a setter that changes nothing is no modification";
  reader->SetInterpolate(true);
  EXPECT_GT(reader->GetMTime(), before);
  reader->UpdateTimeStep(0.2);
  EXPECT_GT(reader->GetOutput()->GetMTime(), first);
}

TEST_F(FAPReader, UpdatesWithoutATimeDoNotRunAgain) {
  reader->Update();
  const vtkMTimeType first = reader->GetOutput()->GetMTime();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetMTime(), first);
}

TEST_F(FAPReader, AChangedFileIsReadAgainAfterModified) {
  reader->Update();
  writeTextFile(path, rampText(9));
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetNumberOfFrames(), 9);
}

TEST_F(FAPReader, ChoosingFramesLooksAtNoFileAndPublishesNoTimes) {
  using SDDP = vtkStreamingDemandDrivenPipeline;
  reader->Update();
  EXPECT_TRUE(reader->GetOutputInformation(0)->Has(SDDP::TIME_STEPS()));
  writeTextFile(path, rampText(9));
  for (int index : {3, 1, 4}) {
    reader->SetFrameIndex(index);
    reader->Update();
    EXPECT_EQ(value("FAP53"), 100.0 * index);
    EXPECT_EQ(reader->GetNumberOfFrames(), 5) << "the file was looked at";
    EXPECT_FALSE(reader->GetOutputInformation(0)->Has(SDDP::TIME_STEPS())) << "the output follows no time";
  }
  reader->SetFrameIndex(-1);
  reader->Modified();
  reader->UpdateInformation();
  EXPECT_EQ(reader->GetOutputInformation(0)->Length(SDDP::TIME_STEPS()), 9);
}

TEST_F(FAPReader, AFileAfterAStreamIsAFile) {
  mien::FAPFrame frame;
  frame.setValue(53, 7.0);
  reader->StartStream(50.0, "live");
  reader->SetFileName("-");
  reader->AppendFrame(frame);
  reader->AppendFrame(frame);
  reader->Update();
  EXPECT_EQ(value("FAP53"), 7.0);
  EXPECT_EQ(reader->GetNumberOfFrames(), 2);
  EXPECT_FALSE(reader->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
  reader->ClearFrames();
  frame.setValue(53, 8.0);
  reader->AppendFrame(frame);
  reader->Update();
  EXPECT_EQ(value("FAP53"), 8.0);
  EXPECT_EQ(reader->GetNumberOfFrames(), 1);
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetNumberOfFrames(), 5);
  reader->ClearFrames();  // only a stream's
  EXPECT_EQ(reader->GetNumberOfFrames(), 5);
  EXPECT_EQ(reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 5);
}

TEST_F(FAPReader, ARefusedFileNamesFileAndLineAndKeepsTheOldOne) {
  reader->UpdateTimeStep(0.3);
  const std::string broken = MIEN_TEST_DIR "/data/malformed/fap/line3_value_is_nan.fap";
  mien::PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(broken.c_str());
  reader->Update();
  EXPECT_EQ(errors.first(), broken + ":3: entry 2 is 'nan'; it must be a finite number");
  EXPECT_EQ(reader->GetNumberOfFrames(), 5);
  EXPECT_EQ(reader->GetName(), "ramp");
  EXPECT_EQ(value("FAP53"), 300.0);
  errors.clear();
  reader->SetFileName(path.c_str());
  reader->UpdateTimeStep(0.1);
  EXPECT_EQ(errors.first(), "");
  EXPECT_EQ(value("FAP53"), 100.0);
}

TEST_F(FAPReader, MissingFilesFoldersAndNoNameAreErrors) {
  mien::PipelineErrors errors;
  errors.observe(reader);
  const std::string missing = path + ".gone";
  for (const char* name : {missing.c_str(), MIEN_TEST_DIR, static_cast<const char*>(nullptr)}) {
    errors.clear();
    reader->SetFileName(name);
    reader->UpdateInformation();
    EXPECT_NE(errors.first().find(name ? name : "no file name"), std::string::npos) << errors.first();
  }
}

TEST_F(FAPReader, WarningsNameFileAndLine) {
  writeTextFile(path, "2.1 n 25 7\n" + maskText({53}) + "\n0 1\n");
  reader->UpdateInformation();
  ASSERT_EQ(reader->GetWarnings().size(), 1u);
  EXPECT_EQ(reader->GetWarnings()[0].rfind(path + ":1: ", 0), 0u);
}

TEST_F(FAPReader, TellsWhatItCanRead) {
  EXPECT_EQ(vtkFAPReader::CanReadFile(path.c_str()), 1);
  EXPECT_EQ(vtkFAPReader::CanReadFile(MIEN_TEST_DIR "/data/malformed/fap/line1_version_3.fap"), 1)
      << "no other reader is for it, and this one says what is wrong";
  EXPECT_EQ(vtkFAPReader::CanReadFile((path + ".gone").c_str()), 0);
  EXPECT_EQ(vtkFAPReader::CanReadFile(nullptr), 0);
}

TEST_F(FAPReader, PlaysEveryReferenceFile) {
  MIEN_REQUIRE_REFERENCE("faps");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(referencePath("faps"))) {
    reader->SetFileName(entry.path().string().c_str());
    reader->UpdateInformation();
    const int last = reader->GetNumberOfFrames() - 1;
    reader->UpdateTimeStep(last / reader->GetFramesPerSecond());
    EXPECT_EQ(value("frame"), reader->GetSequence().frames[last].number) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 14);
}

TEST_F(FAPReader, DataAfterRefusedInformationAreRefusedToo) {
  reader->Update();
  writeTextFile(path, "no animation\n");
  reader->Modified();
  mien::PipelineErrors errors;
  errors.observe(reader);
  reader->UpdateInformation();
  errors.clear();
  reader->Update();
  EXPECT_NE(errors.first().find(path + ":1: "), std::string::npos) << errors.first();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfRows(), 0);
}

TEST(FAPReaderWithoutAFrame, DataAfterRefusedInformationAreRefusedToo) {
  const vtkNew<vtkFAPReader> reader;
  reader->SetFileName("no_such_file.fap");
  mien::PipelineErrors errors;
  errors.observe(reader);
  reader->UpdateInformation();
  reader->Update();
  EXPECT_NE(errors.first().find("no_such_file.fap: "), std::string::npos) << errors.first();
}
