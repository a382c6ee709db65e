// Names in encodings that files do not tell.
#include <burin/base/error.h>

#include "cad_files.h"
#include "encoding.h"

#include <filesystem>
#include <vector>

namespace burin {
namespace {

using Strings = std::vector<std::string>;

struct Encoded {
  Strings names, bytes;
  const char* encoding;
};

const std::vector<Encoded>& examples() {
  static const std::vector<Encoded> all = {
      {{"Gehäusedeckel"}, {"Geh\xe4usedeckel"}, "WINDOWS-1252"},
      {{"Führung Ø8"},
       {"F\xfchrung \xd8"
        "8"},
       "WINDOWS-1252"},
      {{"90° Écrou"},
       {"90\xb0 \xc9"
        "crou"},
       "WINDOWS-1252"},
      {{"pièce à œil"},
       {"pi\xe8"
        "ce \xe0 \x9cil"},
       "WINDOWS-1252"},
      {{"Корпус насоса"}, {"\xca\xee\xf0\xef\xf3\xf1 \xed\xe0\xf1\xee\xf1\xe0"}, "WINDOWS-1251"},
      {{"Прокладка"}, {"\xcf\xf0\xee\xea\xeb\xe0\xe4\xea\xe0"}, "WINDOWS-1251"},
      {{"Šroub"}, {"\x8aroub"}, "WINDOWS-1250"},
      {{"Łożysko"}, {"\xa3o\xbfysko"}, "WINDOWS-1250"},
      {{"Łącznik", "koło"},
       {"\xa3\xb9"
        "cznik",
        "ko\xb3o"},
       "WINDOWS-1250"},
      {{"Śruba główna"}, {"\x8cruba g\xb3\xf3wna"}, "WINDOWS-1250"},
      {{"Příruba č. 2"}, {"P\xf8\xedruba \xe8. 2"}, "WINDOWS-1250"},
      {{"Şaft gövdesi", "ağırlık"},
       {"\xde"
        "aft g\xf6vdesi",
        "a\xf0\xfdrl\xfdk"},
       "WINDOWS-1254"},
      {{"Крышка подшипника", "Вал"},
       {"\xca\xf0\xfb\xf8\xea\xe0 \xef\xee\xe4\xf8\xe8\xef\xed\xe8\xea\xe0", "\xc2\xe0\xeb"},
       "WINDOWS-1251"},
      {{"КОРПУС", "ВИНТ М8"},
       {"\xca\xce\xd0\xcf\xd3\xd1",
        "\xc2\xc8\xcd\xd2 \xcc"
        "8"},
       "WINDOWS-1251"},
      {{"Κάλυμμα", "Άξονας"},
       {"\xca\xdc\xeb\xf5\xec\xec\xe1", "\xa2\xee\xef\xed\xe1\xf2"},
       "WINDOWS-1253"},
      {{"Bride n°3 Ø8 5µm m³/h"},
       {"Bride n\xb0"
        "3 \xd8"
        "8 5\xb5m m\xb3/h"},
       "WINDOWS-1252"},
      {{"Þykkt, stærð"}, {"\xdeykkt, st\xe6r\xf0"}, "WINDOWS-1252"},
      {{"轴承盖", "齿轮轴"}, {"\xd6\xe1\xb3\xd0\xb8\xc7", "\xb3\xdd\xc2\xd6\xd6\xe1"}, "GB18030"},
      {{"底板", "支架", "螺母"},
       {"\xb5\xd7\xb0\xe5", "\xd6\xa7\xbc\xdc", "\xc2\xdd\xc4\xb8"},
       "GB18030"},
      {{"螺栓M8"}, {"\xc2\xdd\xcb\xa8M8"}, "GB18030"},
      {{"軸受カバー", "表示板ソ"},
       {"\x8e\xb2\x8e\xf3\x83J\x83o\x81[", "\x95\x5c\x8e\xa6\x94\xc2\x83\x5c"},
       "CP932"},
      {{"ボルト M8"}, {"\x83{\x83\x8b\x83g M8"}, "CP932"},
      {{"部品"}, {"\x95\x94\x95i"}, "CP932"},
      {{"베어링 커버"}, {"\xba\xa3\xbe\xee\xb8\xb5 \xc4\xbf\xb9\xf6"}, "CP949"},
      {{"하우징", "볼트", "본체"},
       {"\xc7\xcf\xbf\xec\xc2\xa1", "\xba\xbc\xc6\xae", "\xba\xbb\xc3\xbc"},
       "CP949"},
      {{"ボルト", "ナット"}, {"\xa5\xdc\xa5\xeb\xa5\xc8", "\xa5\xca\xa5\xc3\xa5\xc8"}, "EUC-JP"},
      {{"外殼"}, {"\xa5~\xb4\xdf"}, "BIG5"},
  };
  return all;
}

std::string guess(const Strings& bytes) { return guess_encoding(bytes).encoding; }

TEST(NameEncodings, AreToldByTheLettersThatTheyMake) {
  for (const Encoded& one : examples()) EXPECT_EQ(guess(one.bytes), one.encoding) << one.names[0];
}

TEST(NameEncodings, OfUnixInRussiaAreToldByTheirCapitals) {
  const EncodingGuess cover =
      guess_encoding({"\xeb\xd2\xd9\xdb\xcb\xc1 \xd0\xcf\xc4\xdb\xc9\xd0\xce\xc9\xcb\xc1"});
  EXPECT_EQ(cover.encoding, "KOI8-R");
  EXPECT_FALSE(cover.sure);
}

TEST(NameEncodings, GiveTheNames) {
  for (const Encoded& one : examples()) {
    TextDecoder decoder("");
    for (const std::string& bytes : one.bytes) decoder.learn(bytes);
    for (std::size_t i = 0; i < one.bytes.size(); ++i) {
      EXPECT_EQ(decoder.utf8(one.bytes[i]), one.names[i]) << one.encoding;
    }
  }
}

TEST(NameEncodings, Utf8AndAsciiStayAsTheyAre) {
  TextDecoder decoder("");
  for (const char* name : {"Gehäuse", "轴承", "plain"}) decoder.learn(name);
  EXPECT_EQ(decoder.utf8("Gehäuse"), "Gehäuse");
  Diagnostics said;
  decoder.report(said);
  EXPECT_TRUE(said.empty());
  EXPECT_EQ(utf8_text("#1 = PRODUCT('Gehäuse');\n", "", said), "");
  EXPECT_TRUE(said.empty());
}

TEST(NameEncodings, WhatIsUnsureIsSaidOnceAndTheUserDecides) {
  // Axis, of one letter that Korean and Chinese files may both mean.
  const std::string axis = "\xc3\xe0";
  TextDecoder decoder("");
  for (int i = 0; i < 3; ++i) decoder.learn(axis);
  EXPECT_EQ(decoder.utf8(axis), "축");
  Diagnostics said;
  decoder.report(said);
  ASSERT_EQ(said.entries().size(), 1u);
  EXPECT_EQ(said.entries()[0].code, "names.encoding");
  EXPECT_NE(said.entries()[0].message.find("EUC-KR is assumed ('축')"), std::string::npos)
      << said.entries()[0].message;
  Diagnostics quiet;
  for (const char* name : {"GB18030", "gbk", "GB2312"}) {
    TextDecoder reported(name);
    reported.learn(axis);
    EXPECT_EQ(reported.utf8(axis), "绵") << name;
    reported.report(quiet);
  }
  EXPECT_TRUE(quiet.empty());
}

TEST(NameEncodings, BytesThatAreNoLetterAreReplaced) {
  TextDecoder decoder("UTF-8");
  decoder.learn("Geh\xe4use");
  EXPECT_EQ(decoder.utf8("Geh\xe4use"), "Geh\xef\xbf\xbduse");
}

TEST(NameEncodings, OfWhichSomeBytesAreNoLettersAreSaidOnce) {
  TextDecoder wrong("UTF-8");
  for (const char* name : {"Geh\xe4use", "F\xfchrung", "Deckel"}) wrong.learn(name);
  EXPECT_EQ(wrong.utf8("Geh\xe4use"), "Geh\xef\xbf\xbduse");
  wrong.utf8("F\xfchrung");
  wrong.utf8("Deckel");
  Diagnostics said;
  wrong.report(said);
  ASSERT_EQ(said.entries().size(), 1u);
  EXPECT_EQ(said.entries()[0].code, "names.encoding");
  EXPECT_EQ(said.entries()[0].count, 2);
  EXPECT_NE(said.entries()[0].message.find("not valid in UTF-8"), std::string::npos);
  TextDecoder right("latin1");
  right.utf8("Geh\xe4use");
  Diagnostics nothing;
  right.report(nothing);
  EXPECT_TRUE(nothing.entries().empty());
}

TEST(NameEncodings, ThatNobodyKnowsAreRefused) {
  EXPECT_NO_THROW(check_encoding("option --encoding", "Shift_JIS"));
  for (const char* name : {"klingon", ""}) {
    EXPECT_THROW(check_encoding("option --encoding", name), UsageError) << name;
  }
}

TEST(NameEncodings, WhatIsNotSureIsSaidByTheNameAlone) {
  Diagnostics said;
  const std::string text =
      utf8_text("#1 = PRODUCT('b','\xd8\xd8','',(#2));\n#2 = X('');\n", "", said);
  ASSERT_EQ(said.entries().size(), 1u);
  const std::string& message = said.entries()[0].message;
  EXPECT_EQ(message.find("PRODUCT"), std::string::npos) << message;
  const std::size_t name = message.find("('") + 2;
  EXPECT_NE(text.find("'" + message.substr(name, message.find("')") - name) + "'"), text.npos)
      << message;
}

class CadNames : public test::CadTest {};

TEST_F(CadNames, OfProductsThatHaveNumbersAlone) {
  test::CadDocument document;
  document.part(test::solid_box(1, 1, 1), "QPARTQ");
  const std::string file = document.step(folder_ / "plain.step");
  const std::string named = "PRODUCT('QPARTQ','QPARTQ'";
  for (const auto& [product, name] :
       {std::pair("PRODUCT('B-17',''", "B-17"), std::pair("PRODUCT('B-17',' '", "B-17"),
        std::pair("PRODUCT('B-17',$", "B-17"), std::pair("PRODUCT('',''", "part"),
        std::pair("PRODUCT('Rhino Product','Rhino Product'", "part")}) {
    const Scene scene = read(changed(file, named, product, "part.step"));
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].name, name) << product;
  }
}

TEST_F(CadNames, OfSolidsInAProductThatSomebodyGave) {
  test::CadDocument document;
  document.part(test::boxes_in_a_row(4), "chip");
  std::string text = test::slurp(document.step(folder_ / "plain.step"));
  std::size_t at = 0;
  for (const char* name : {"Housing", "Pin", "Pin", "Body 4"}) {
    const std::string before = "MANIFOLD_SOLID_BREP('";
    at = text.find(before, at) + before.size();
    text.replace(at, text.find('\'', at) - at, name);
  }
  Scene scene = read(folder_.write("named.step", text));
  ASSERT_EQ(scene.parts.size(), 1u);
  const std::vector<Piece>& pieces = scene.parts[0].pieces;
  ASSERT_EQ(pieces.size(), 4u);
  Strings names;
  for (const Piece& piece : pieces) names.push_back(piece.name);
  EXPECT_EQ(names, (Strings{"solid 1 (Housing)", "solid 2 (Pin)", "solid 3 (Pin)", "solid 4"}));
}

TEST_F(CadNames, OfStepAreDecodedWhereverTheyStand) {
  test::CadDocument document;
  const TDF_Label part = document.part(test::solid_box(1, 1, 1), "QPARTQ");
  const TDF_Label top = document.assembly("QTOPQ");
  document.use(top, part, test::moved(1, 0, 0), "QPARTQ");
  const std::string file = document.step(folder_ / "plain.step");
  for (const Encoded& one : examples()) {
    const std::string& name = one.bytes.front();
    // A second byte of Shift-JIS may be a backslash, which a control directive begins with.
    const Scene scene = read(changed(changed(file, "QPARTQ", name, "part.step"), "QTOPQ",
                                     one.bytes.back() + "\\X2\\00C4\\X0\\", "both.step"));
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_EQ(scene.parts[0].name, one.names.front()) << one.encoding;
    EXPECT_EQ(scene.parts[0].assembly, Strings{one.names.back() + "Ä"}) << one.encoding;
  }
}

TEST_F(CadNames, OfIgesAreDecodedToo) {
  test::CadDocument document;
  document.part(test::solid_box(1, 1, 1), "NAMENAME");
  const std::string file = document.iges(folder_ / "plain.igs");
  // As many bytes, for lines of IGES have 80 and texts a length before them.
  const Scene scene = read(changed(file, "NAMENAME",
                                   "F\xfc"
                                   "hrung8",
                                   "named.igs"));
  ASSERT_FALSE(scene.parts.empty());
  EXPECT_EQ(scene.parts[0].name, "Führung8");
}

TEST_F(CadNames, OfForeignFilesArriveWhole) {
  const std::filesystem::path folder = std::filesystem::path(BURIN_TEST_DATA) / "outside";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const auto& [file, first, second] :
       {std::tuple("names_latin1.step", "Gehäusedeckel", "Führung Ø8"),
        std::tuple("names_gb18030.step", "轴承盖", "齿轮轴"),
        std::tuple("names_sjis.step", "軸受カバー", "表示板ソ")}) {
    const Scene scene = read((folder / file).string());
    ASSERT_EQ(scene.parts.size(), 2u) << file;
    EXPECT_EQ(scene.parts[0].name, first);
    EXPECT_EQ(scene.parts[1].name, second);
    EXPECT_EQ(test::count_of(scene.diagnostics, "names.encoding"), 0) << file;
  }
}

}  // namespace
}  // namespace burin
