package rasterlab.app.cli;

import java.util.Locale;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The languages a report is printed in. */
enum ReportLanguage {
    EN,
    RU;

    /** "en" or "ru". */
    String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    Language inWindow() {
        return this == EN ? Language.ENGLISH : Language.RUSSIAN;
    }

    Texts texts() {
        return Texts.of("cli", "report", inWindow());
    }
}
