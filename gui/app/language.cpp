#include "gui/app/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <memory>
#include <vector>

namespace glint {

namespace {

/// Translators in use; they belong to the application.
std::vector<QTranslator*>& installed() {
    static std::vector<QTranslator*> translators;
    return translators;
}

void install(const QString& name, const QString& folder) {
    auto translator = std::make_unique<QTranslator>(QCoreApplication::instance());
    if (!translator->load(name, folder)) return;
    QCoreApplication::installTranslator(translator.get());
    installed().push_back(translator.release());
}

bool isChinese(Language language) {
    return language == Language::Chinese ||
           (language == Language::System && QLocale::system().language() == QLocale::Chinese);
}

}  // namespace

void applyLanguage(Language language) {
    for (QTranslator* translator : std::exchange(installed(), {})) {
        QCoreApplication::removeTranslator(translator);
        delete translator;
    }
    if (!isChinese(language)) return install("glint_en", ":/translations");
    install("qtbase_zh_CN", QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install("glint_zh_CN", ":/translations");
}

QString nameOf(Language language) {
    switch (language) {
        case Language::System:
            return QCoreApplication::translate("Language", "As the system");
        case Language::English:
            return QStringLiteral("English");
        case Language::Chinese:
            return QStringLiteral("简体中文");
    }
    return {};
}

}  // namespace glint
