// Letters of other threads: each is opened once, in the thread of the box, in the order of posting, and none after the box is gone.
#include "ui/document/mailbox.h"

#include <QTest>
#include <QThread>

#include <algorithm>
#include <memory>
#include <thread>
#include <vector>

using vp::document::Mailbox;

class TestMailbox : public QObject {
  Q_OBJECT

private slots:
  void letters_areOpenedLaterInOrderInTheThreadOfTheBox() {
    Mailbox box;
    std::vector<int> opened;
    bool isHere = true;
    std::jthread([&] {
      for (int i = 0; i < 100; ++i) {
        box.post([&, i] {
          opened.push_back(i);
          isHere = isHere && QThread::currentThread() == box.thread();
        });
      }
    }).join();
    QVERIFY(opened.empty());
    QTRY_COMPARE(opened.size(), std::size_t{100});
    QVERIFY(std::is_sorted(opened.begin(), opened.end()));
    QVERIFY(isHere);
  }

  void lettersOfManyThreads_allArrive() {
    Mailbox box;
    int count = 0;
    {
      std::vector<std::jthread> threads;
      for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
          for (int k = 0; k < 500; ++k) {
            box.post([&] { ++count; });
          }
        });
      }
    }
    QTRY_COMPARE(count, 2000);
  }

  void lettersThatNobodyOpened_areDroppedWithTheBox() {
    bool isOpened = false;
    const auto kept = std::make_shared<int>(1);
    auto box = std::make_unique<Mailbox>();
    box->post([&isOpened, kept] { isOpened = true; });
    QCOMPARE(kept.use_count(), 2L);
    box.reset();
    QCOMPARE(kept.use_count(), 1L);
    QCoreApplication::processEvents();
    QVERIFY(!isOpened);
  }

  void letter_mayPostAnotherAndDestroyTheBox() {
    auto box = std::make_unique<Mailbox>();
    int steps = 0;
    box->post([&] {
      ++steps;
      box->post([&] {
        ++steps;
        box.reset();
      });
    });
    QTRY_COMPARE(steps, 2);
    QVERIFY(box == nullptr);
  }
};

QTEST_GUILESS_MAIN(TestMailbox)
#include "tst_mailbox.moc"
