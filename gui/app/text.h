// Conversions between the tracer's UTF-8 strings and Qt's.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <filesystem>
#include <string>
#include <string_view>

#include "tracer/base/result.h"

namespace glint {

[[nodiscard]] inline QString toQString(std::string_view utf8) {
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}
[[nodiscard]] inline std::filesystem::path toPath(const QString& text) {
    return text.toStdString();
}
[[nodiscard]] inline QString pathText(const std::filesystem::path& path) {
    return toQString(path.string());
}

/// An error as one readable line.
[[nodiscard]] inline QString toQString(const Error& error) { return toQString(error.text()); }

/// A name from a field table or type list ("vertical_fov_degrees") as a person reads it ("Vertical
/// fov").
[[nodiscard]] inline QString labelOf(std::string_view name) {
    QString text = toQString(name);
    if (QString known = QCoreApplication::translate("Field", text.toUtf8().constData());
        known != text)
        return known;
    // The unit stands behind the number.
    for (const char* unit : {"_degrees", "_seconds", "_percent", "_ev"})
        if (text.endsWith(QLatin1String(unit)))
            text.chop(qsizetype(std::char_traits<char>::length(unit)));
    if (text == QLatin1String("ior")) return QStringLiteral("IOR");
    if (text == QLatin1String("spp")) return QStringLiteral("Samples a pixel");
    text.replace(QLatin1Char('_'), QLatin1Char(' '));
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}
/// What a field table says about a field, in the person's language.
[[nodiscard]] inline QString explanationOf(std::string_view doc) {
    return QCoreApplication::translate("FieldDoc", std::string(doc).c_str());
}

}  // namespace glint
