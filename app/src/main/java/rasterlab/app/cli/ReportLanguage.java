package rasterlab.app.cli;

import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.TypeConversionException;
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

    /**
     * The language of that code, in capitals too.
     *
     * @throws TypeConversionException if there is none; the message lists those there are
     */
    static ReportLanguage named(String code) {
        for (ReportLanguage each : values()) if (each.code().equalsIgnoreCase(code)) return each;
        String codes =
                Stream.of(values()).map(ReportLanguage::code).collect(Collectors.joining(", "));
        throw new TypeConversionException("expected one of " + codes + ", got '" + code + "'");
    }

    /** What {@code --lang} says, whatever is wrong with the other arguments; else English. */
    static ReportLanguage asked(String[] args) {
        String words = String.join("\n", args) + "\n";
        return words.matches("(?is)(.*\\n)?--lang[\\n=]ru\\n.*") ? RU : EN;
    }

    Language inWindow() {
        return this == EN ? Language.ENGLISH : Language.RUSSIAN;
    }

    Texts texts() {
        return Texts.of("cli", "report", inWindow());
    }
}
