#include <gtest/gtest.h>

#include <QPainter>

#include "FigureApplication.h"
#include "FigureFile.h"
#include "FigureMetadata.h"
#include "TemporaryFolder.h"
#include "TextFile.h"

namespace {

class FigureMetadata : public testing::Test {
 protected:
  mien::FigureApplication application_;
  TemporaryFolder folder_;

  std::string written(const std::string& ending, const std::string& title, const std::string& description) {
    const std::string name = folder_.file("figure." + ending);
    mien::FigureFile file(name);
    file.setTitle(title);
    file.setDescription(description);
    EXPECT_EQ(file.write({1000, 500}, [](QPainter& p) { p.drawLine(0, 0, 900, 400); }), "");
    return name;
  }
};

TEST_F(FigureMetadata, EveryFormatGivesBackWhatWasWritten) {
  const std::string title = "Kurven <C22'> & \"mehr\", ä";
  const std::string description = "mien figure pde-1 --face 'a <b> & c.vtp'\n{\"a\": [1, 2]}\nlast line";
  for (const std::string& ending : mien::FigureFile::endings()) {
    const std::string name = written(ending, title, description);
    mien::FigureMetadata read;
    EXPECT_EQ(read.read(name), "") << ending;
    EXPECT_EQ(read.title, title) << ending;
    EXPECT_EQ(read.description, description) << ending;
  }
}

TEST_F(FigureMetadata, OtherAndDamagedFilesAreRefusedByName) {
  for (const std::string& ending : mien::FigureFile::endings()) {
    const std::string name = written(ending, "t", "mien figure pde-1");
    const std::string whole = readTextFile(name);
    for (const std::string& text : {std::string(), std::string("hello"), whole.substr(0, 40), std::string(200, '\0')}) {
      writeTextFile(name, text);
      mien::FigureMetadata read;
      EXPECT_EQ(read.read(name).rfind(name + ": ", 0), 0u) << ending << " " << text;
      EXPECT_TRUE(read.description.empty());
    }
  }
  mien::FigureMetadata read;
  EXPECT_EQ(read.read(folder_.file("none.svg")).rfind(folder_.file("none.svg") + ": ", 0), 0u);
}

}  // namespace
