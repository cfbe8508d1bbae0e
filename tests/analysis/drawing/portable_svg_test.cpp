#include "analysis/drawing/portable_svg.hpp"

#include <gtest/gtest.h>

namespace eerie::drawing {
namespace {

TEST(PortableSvg, KeepsSpacesNamesOtherFontsAndDropsTooltips) {
  EXPECT_EQ(portable_svg("<svg \n viewBox=\"0 0 9 9\"><title>Gnuplot</title><g "
                         "font-family=\"DejaVu Sans:Bold\"><text><tspan font-family=\"DejaVu "
                         "Sans\" > a</tspan></text></g></svg>"),
            "<svg xml:space=\"preserve\" \n viewBox=\"0 0 9 9\"><g font-family=\"DejaVu Sans, "
            "Verdana, sans-serif\"><text><tspan font-family=\"DejaVu Sans, Verdana, sans-serif\" > "
            "a</tspan></text></g></svg>");
}

TEST(PortableSvg, ChangesNoWordsOfTheFigure) {
  const std::string words = "<text>font-family=\"DejaVu Sans\" &lt;title&gt; &lt;svg</text>";
  EXPECT_EQ(portable_svg(words), words);
  EXPECT_EQ(portable_svg(""), "");
  EXPECT_EQ(portable_svg("a < b"), "a < b");
}

}  // namespace
}  // namespace eerie::drawing
