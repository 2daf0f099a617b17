// Every input that fuzzing has found, every seed, and broken forms of both, through every reader: a result or a sentence, in bounded time.
#include "tests/fuzz/readers.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

using namespace vp;
namespace fs = std::filesystem;

namespace {

constexpr int kMutations = 300;           // of each input
constexpr std::size_t kMostMutated = 16;  // inputs of a reader, so that the time stays bounded while the found ones grow
constexpr double kLongest = 5.0;          // s for one input; the slowest takes some milliseconds

struct Input {
  std::string name;
  std::string bytes;
};

/// What is committed for a reader: found inputs first, then seeds; sorted, so that runs are alike.
std::vector<Input> inputsOf(const fuzz::Reader& reader) {
  std::vector<Input> inputs;
  for (const char* folder : {"found", "seeds"}) {
    std::vector<fs::path> files;
    std::error_code code;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(VOLPLANE_FUZZ_DIR) / folder / reader.name, code)) {
      files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      std::ostringstream bytes;
      bytes << std::ifstream(file, std::ios::binary).rdbuf();
      inputs.push_back({std::string(folder) + "/" + file.filename().string(), bytes.str()});
    }
  }
  return inputs;
}

/// One to four changes: bits, digits, cuts, copies, pieces that matter to one format or another.
std::string mutated(std::string bytes, const std::vector<Input>& others, std::mt19937_64& random) {
  static const std::vector<std::string> kPieces{"\"",
                                                ",",
                                                "{",
                                                "[",
                                                "<",
                                                "&#0;",
                                                "]]>",
                                                "1e999",
                                                "-1",
                                                "nan",
                                                "inf",
                                                "99999999999999999999",
                                                "\xff\xfe",
                                                "\xc3",
                                                "/",
                                                "\n",
                                                std::string(4, '\xff'),
                                                std::string(4, '\0'),
                                                "\x7f\xff\xff\xff",
                                                "180",
                                                "90.0001",
                                                "\\ud800",
                                                "\\u0000",
                                                "\x1b[2J"};
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random() % n); };
  for (std::size_t change = 1 + below(4); change > 0; --change) {
    const std::size_t at = below(bytes.size() + 1);
    const std::size_t count = 1 + below(std::min<std::size_t>(bytes.size() - at + 1, 64));
    switch (below(8)) {
      case 0:
        bytes.insert(at, kPieces[below(kPieces.size())]);
        break;
      case 1:
        bytes.replace(at, count, kPieces[below(kPieces.size())]);
        break;
      case 2:
        bytes.erase(at, count);
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(bytes.size()), count));
        break;
      case 4:
        if (below(4) == 0) {
          bytes.resize(at);
        }
        break;
      case 5: {  // the beginning of one, the end of another
        const std::string& other = others[below(others.size())].bytes;
        bytes = bytes.substr(0, at) + other.substr(below(other.size()));
        break;
      }
      case 6:
        if (const std::size_t digit = bytes.find_first_of("0123456789", at); digit != std::string::npos) {
          bytes[digit] = "0123456789-.eE+"[below(15)];
        }
        break;
      default:
        if (at < bytes.size()) {
          bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1u << below(8)));
        }
    }
  }
  return bytes;
}

}  // namespace

class TestFoundInputs : public QObject {
  Q_OBJECT

  /// Reads and judges; a slow one is a finding too.
  static std::string fault(fuzz::InputFile& file, const std::string& bytes, bool& isRefused) {
    const auto begin = std::chrono::steady_clock::now();
    const fuzz::Outcome outcome = file.read(bytes);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    isRefused = outcome.error.has_value();
    return !outcome.complaint.empty() ? outcome.complaint : seconds > kLongest ? "took " + std::to_string(seconds) + " s" : "";
  }

private Q_SLOTS:
  void everyReader_hasSeedsThatItReads_data() { addReaders(); }
  void everyReader_hasSeedsThatItReads() {
    QFETCH(QString, reader);
    const fuzz::Reader& it = *fuzz::readerOf(reader.toStdString());
    fuzz::InputFile file(it);
    int seeds = 0;
    for (const Input& input : inputsOf(it)) {
      if (input.name.starts_with("seeds/")) {
        const fuzz::Outcome outcome = file.read(input.bytes);
        QVERIFY2(!outcome.error, (input.name + ": " + (outcome.error ? outcome.error->message() : "")).c_str());
        QVERIFY2(input.bytes.size() <= it.longest, input.name.c_str());
        ++seeds;
      }
    }
    QVERIFY(seeds > 0);
  }

  void foundInputs_andSeeds_giveResultsOrSentences_data() { addReaders(); }
  void foundInputs_andSeeds_giveResultsOrSentences() {
    QFETCH(QString, reader);
    const fuzz::Reader& it = *fuzz::readerOf(reader.toStdString());
    fuzz::InputFile file(it);
    bool isRefused = false;
    for (const Input& input : inputsOf(it)) {
      const std::string wrong = fault(file, input.bytes, isRefused);
      QVERIFY2(wrong.empty(), (input.name + ": " + wrong).c_str());
    }
  }

  void brokenForms_giveResultsOrSentences_data() { addReaders(); }
  void brokenForms_giveResultsOrSentences() {
    QFETCH(QString, reader);
    const fuzz::Reader& it = *fuzz::readerOf(reader.toStdString());
    fuzz::InputFile file(it);
    const std::vector<Input> inputs = inputsOf(it);
    std::mt19937_64 random(17);
    int refusals = 0;
    for (std::size_t i = 0; i < std::min(inputs.size(), kMostMutated); ++i) {
      for (int k = 0; k < kMutations; ++k) {
        const std::string bytes = mutated(inputs[i].bytes, inputs, random);
        bool isRefused = false;
        const std::string wrong = fault(file, bytes, isRefused);
        refusals += isRefused ? 1 : 0;
        if (!wrong.empty()) {
          const QString kept = QDir::temp().filePath(QStringLiteral("volplane-broken-%1").arg(reader));
          std::ofstream(kept.toStdString(), std::ios::binary) << bytes;
          QFAIL(qPrintable(QStringLiteral("%1, mutation %2 of seed 17 (kept in %3): %4")
                               .arg(QString::fromStdString(inputs[i].name))
                               .arg(k)
                               .arg(kept, QString::fromStdString(wrong))));
        }
      }
    }
    QVERIFY(refusals > 0);  // else nothing was tried
  }

private:
  static void addReaders() {
    QTest::addColumn<QString>("reader");
    for (const fuzz::Reader& reader : fuzz::readers()) {
      QTest::newRow(reader.name) << QString::fromLatin1(reader.name);
    }
  }
};

QTEST_APPLESS_MAIN(TestFoundInputs)
#include "tst_found_inputs.moc"
