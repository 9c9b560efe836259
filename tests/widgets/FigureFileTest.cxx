#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <cstdlib>
#include <filesystem>

#include "FigureApplication.h"
#include "FigureText.h"
#include "SampleFigure.h"
#include "SmallDisk.h"

namespace {

namespace fs = std::filesystem;

class FigureFile : public testing::Test {
 protected:
  FigureFile() : folder_(fs::temp_directory_path() / ("mien_figure_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~FigureFile() override { fs::remove_all(folder_); }

  std::string name(const std::string& file) const { return (folder_ / file).string(); }

  mien::FigureApplication application_;
  fs::path folder_;
};

TEST_F(FigureFile, SVGHasVectorsAndTextOnly) {
  const std::string svg = mien::writtenFigure(mien::sampleFigure(), name("a.svg"));
  EXPECT_EQ(svg.find("<image"), std::string::npos);
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
  EXPECT_NE(svg.find("width=\"170mm\""), std::string::npos);
  EXPECT_NE(svg.find("mien sweep --scheme all"), std::string::npos);
  for (const char* const text : {"(a)", "Lebesgue constant", "RMS length of the contribution", "four-curve",
                                 "breaks down here", "Smoothing parameter a", "remainder", "N = 5"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST_F(FigureFile, TheSameFigureHasTheSameBytes) {
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  for (const char* const file : {"b.svg", "b.pdf", "b.png"})
    EXPECT_TRUE(mien::writtenFigure(mien::sampleFigure(), name(file)) ==
                mien::writtenFigure(mien::sampleFigure(), name(file)))
        << file;
  unsetenv("SOURCE_DATE_EPOCH");
}

TEST_F(FigureFile, PDFHasFontsAndNoImageAndTheDateOfTheEnvironment) {
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  const std::string pdf = mien::writtenFigure(mien::sampleFigure(), name("c.pdf"));
  unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_NE(pdf.find("/FontFile2"), std::string::npos);
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos);
  EXPECT_NE(pdf.find("D:20231114221320Z)"), std::string::npos);
  const size_t reference = std::stoul(pdf.substr(pdf.rfind("startxref") + 10));
  EXPECT_EQ(pdf.substr(reference, 4), "xref");
}

TEST_F(FigureFile, PicturesHaveTheAskedSizeAndKnowTheirCommand) {
  mien::writtenFigure(mien::sampleFigure(), name("d.png"), 85.0);
  const QImage image(QString::fromStdString(name("d.png")));
  EXPECT_NEAR(image.width(), 85.0 / 25.4 * 300.0, 1.0);
  EXPECT_NEAR(image.dotsPerMeterX() * 0.0254, 300.0, 0.1);
  EXPECT_EQ(image.text("Description"), "mien sweep --scheme all");
}

TEST_F(FigureFile, PrintIsWhite) {
  mien::writtenFigure(mien::sampleFigure(), name("e.png"), 85.0, "print");
  EXPECT_EQ(QImage(QString::fromStdString(name("e.png"))).pixel(1, 1), qRgb(255, 255, 255));
}

TEST_F(FigureFile, AFigureThatCannotBeWrittenLeavesNothing) {
  mien::FigureFile missing(name("no/such/folder.svg"));
  EXPECT_NE(missing.write({100.0, 100.0}, [](QPainter&) {}), "");
  mien::FigureFile unknown(name("f.gif"));
  EXPECT_NE(unknown.write({100.0, 100.0}, [](QPainter&) {}).find(".svg, .pdf or .png"), std::string::npos);
  mien::FigureFile large(name("f.png"));
  large.setDotsPerInch(2400.0);
  EXPECT_NE(large.write({1e6, 1e6}, [](QPainter&) {}).find("too many pixels"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(FigureFile, AFullDiskLeavesTheOldFigure) {
  for (const char* const file : {"g.svg", "g.pdf", "g.png"}) {
    mien::FigureFile figure(name(file));
    ASSERT_EQ(figure.write({1000.0, 1000.0}, [](QPainter&) {}), "");
    const auto before = fs::file_size(name(file));
    const SmallDisk disk(before);
    const std::string fault = figure.write({1e4, 1e4}, [](QPainter& painter) {
      for (int i = 0; i < 2000; ++i) painter.drawLine(7 * i % 9973, 13 * i % 9967, 17 * i % 9949, 19 * i % 9941);
    });
    EXPECT_NE(fault.find("space left"), std::string::npos) << fault;
    EXPECT_EQ(fs::file_size(name(file)), before);
  }
}

}  // namespace
