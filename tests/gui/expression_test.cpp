#include "gui/widgets/expression.h"

#include <QtTest>
#include <cmath>

namespace glint {

class ExpressionTest : public QObject {
    Q_OBJECT

  private slots:
    void computes_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("expected");
        QTest::newRow("number") << "1.25"
                                << "" << 1.25;
        QTest::newRow("exponent") << "2e-3"
                                  << "" << 0.002;
        QTest::newRow("comma") << "0,5"
                               << "" << 0.5;
        QTest::newRow("precedence") << "1+2*3"
                                    << "" << 7.0;
        QTest::newRow("brackets") << "(1+2)*3"
                                  << "" << 9.0;
        QTest::newRow("power binds right") << "2^3^2"
                                           << "" << 512.0;
        QTest::newRow("minus") << "-2^2 - -1"
                               << "" << 5.0;
        QTest::newRow("function") << "sqrt(2)*sqrt(2)"
                                  << "" << std::sqrt(2.0) * std::sqrt(2.0);
        QTest::newRow("pi") << "2*pi"
                            << "" << 2 * M_PI;
        QTest::newRow("centimetres") << "35 cm"
                                     << "m" << 0.35;
        QTest::newRow("mixed lengths") << "1m + 20cm"
                                       << "m" << 1.2;
        QTest::newRow("radians") << "2 rad"
                                 << "deg" << 2 * (180 / M_PI);
        QTest::newRow("degree sign") << "45°"
                                     << "deg" << 45.0;
        QTest::newRow("own unit") << "3 W/sr"
                                  << "W/sr" << 3.0;
        QTest::newRow("relative") << "+=0.5"
                                  << "" << 2.5;
        QTest::newRow("scaled") << "*=3"
                                << "" << 6.0;
    }
    void computes() {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(double, expected);
        const auto value = evaluate(text, 2.0, unit);
        QVERIFY(value);
        QCOMPARE(*value, expected);
    }

    void refuses_data() {
        QTest::addColumn<QString>("text");
        for (const char* text : {"", "abc", "1+", "(1", "1)", "1 2", "1/0", "sqrt(-1)", "5 kg",
                                 "pi rad", "1..2", "()"})
            QTest::newRow(text) << QString(text);
        QTest::newRow("deep") << QString(100000, '(');
    }
    void refuses() {
        QFETCH(QString, text);
        QVERIFY(!evaluate(text, 0, "m"));
    }
};

}  // namespace glint

QTEST_APPLESS_MAIN(glint::ExpressionTest)
#include "expression_test.moc"
