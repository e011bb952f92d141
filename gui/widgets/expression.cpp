#include "gui/widgets/expression.h"

#include <QHash>
#include <cmath>
#include <numbers>

namespace glint {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// Factor from a typed unit to the field's, or nothing where the two do not go together.
std::optional<double> unitFactor(const QString& typed, const QString& unit) {
    static const QHash<QString, double> lengths = {{"mm", 1e-3}, {"cm", 1e-2},   {"m", 1},
                                                   {"km", 1e3},  {"in", 0.0254}, {"ft", 0.3048}};
    if (typed == unit) return 1;
    if (unit == "m" && lengths.contains(typed)) return lengths.value(typed);
    if (unit == "deg" && typed == QStringLiteral("°")) return 1;
    if (unit == "deg" && typed == "rad") return kDegreesPerRadian;
    return std::nullopt;
}

/// Recursive descent over  sum := product {(+|-) product}  product := power {(*|/) power}
/// power := unary [^ power]  unary := [-|+] unary | number [unit] | name | name(sum) | (sum).
class Parser {
  public:
    Parser(const QString& text, const QString& unit) : text_(text), unit_(unit) {}

    std::optional<double> parse() {
        const double value = sum();
        skipSpace();
        if (failed_ || at_ != text_.size() || !std::isfinite(value)) return std::nullopt;
        return value;
    }

  private:
    double sum() {
        double value = product();
        for (;;) {
            if (take('+'))
                value += product();
            else if (take('-'))
                value -= product();
            else
                return value;
        }
    }
    double product() {
        double value = power();
        for (;;) {
            if (take('*'))
                value *= power();
            else if (take('/'))
                value /= power();
            else
                return value;
        }
    }
    double power() {
        const double base = unary();
        return take('^') ? std::pow(base, power()) : base;
    }
    double unary() {
        if (++depth_ > kMaxDepth) return fail();
        const double value = take('-') ? -unary() : take('+') ? unary() : primary();
        --depth_;
        return value;
    }
    double primary() {
        if (take('(')) {
            const double value = sum();
            return take(')') ? value : fail();
        }
        skipSpace();
        if (at_ < text_.size() && (text_[at_].isDigit() || text_[at_] == '.')) return number();
        const QString name = word();
        if (name == "pi") return std::numbers::pi;
        if (name.isEmpty() || !take('(')) return fail();
        const double x = sum();
        return take(')') ? function(name, x) : fail();
    }
    double function(const QString& name, double x) {
        if (name == "sqrt") return std::sqrt(x);
        if (name == "abs") return std::abs(x);
        if (name == "sin") return std::sin(x / kDegreesPerRadian);
        if (name == "cos") return std::cos(x / kDegreesPerRadian);
        if (name == "tan") return std::tan(x / kDegreesPerRadian);
        return fail();
    }
    double number() {
        const qsizetype start = at_;
        while (at_ < text_.size() && (text_[at_].isDigit() || text_[at_] == '.')) ++at_;
        if (at_ + 1 < text_.size() && text_[at_].toLower() == 'e') {
            const qsizetype sign = text_[at_ + 1] == '-' || text_[at_ + 1] == '+' ? 1 : 0;
            if (at_ + 1 + sign < text_.size() && text_[at_ + 1 + sign].isDigit()) {
                at_ += 1 + sign;
                while (at_ < text_.size() && text_[at_].isDigit()) ++at_;
            }
        }
        bool ok = false;
        const double value = text_.mid(start, at_ - start).toDouble(&ok);
        if (!ok) return fail();
        skipSpace();
        if (!unit_.isEmpty() && text_.mid(at_).startsWith(unit_)) {
            at_ += unit_.size();
            return value;
        }
        const QString typed = word();
        if (typed.isEmpty()) return value;
        const auto factor = unitFactor(typed, unit_);
        return factor ? value * *factor : fail();
    }
    QString word() {
        skipSpace();
        const qsizetype start = at_;
        while (at_ < text_.size() && (text_[at_].isLetter() || text_[at_] == QChar(0xb0))) ++at_;
        return text_.mid(start, at_ - start);
    }
    bool take(char c) {
        skipSpace();
        if (at_ >= text_.size() || text_[at_] != QLatin1Char(c)) return false;
        ++at_;
        return true;
    }
    void skipSpace() {
        while (at_ < text_.size() && text_[at_].isSpace()) ++at_;
    }
    double fail() {
        failed_ = true;
        at_ = text_.size();
        return 0;
    }

    static constexpr int kMaxDepth = 100;
    const QString text_, unit_;
    qsizetype at_ = 0;
    int depth_ = 0;
    bool failed_ = false;
};

}  // namespace

std::optional<double> evaluate(const QString& text, double current, const QString& unit) {
    QString plain = text.trimmed();
    plain.replace(',', '.');
    QChar assign;
    if (plain.size() > 2 && plain[1] == '=' && QStringLiteral("+-*/").contains(plain[0])) {
        assign = plain[0];
        plain = plain.mid(2);
    }
    const auto value = Parser(plain, unit).parse();
    if (!value || assign.isNull()) return value;
    const double result = assign == '+'   ? current + *value
                          : assign == '-' ? current - *value
                          : assign == '*' ? current * *value
                                          : current / *value;
    return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

}  // namespace glint
