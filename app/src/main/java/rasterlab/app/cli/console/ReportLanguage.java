package rasterlab.app.cli.console;

import java.util.Locale;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.TypeConversionException;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The languages of what people read: help, reports, progress and complaints. */
public enum ReportLanguage {
    EN,
    RU;

    /** "en" or "ru". */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * The language of that code, in capitals too.
     *
     * @throws TypeConversionException if there is none; the message lists those there are
     */
    public static ReportLanguage named(String code) {
        for (ReportLanguage each : values()) if (each.code().equalsIgnoreCase(code)) return each;
        String codes =
                Stream.of(values()).map(ReportLanguage::code).collect(Collectors.joining(", "));
        throw new TypeConversionException("expected one of " + codes + ", got '" + code + "'");
    }

    /**
     * The language that {@code --lang} asks for, whatever is wrong with the other arguments; else
     * English.
     */
    public static ReportLanguage asked(String[] args) {
        String words = String.join("\n", args) + "\n";
        return words.matches("(?is)(.*\\n)?--lang[\\n=]ru\\n.*") ? RU : EN;
    }

    public Language inWindow() {
        return this == EN ? Language.ENGLISH : Language.RUSSIAN;
    }

    /** The words of help, for picocli; empty where they stand with the commands. */
    public Optional<ResourceBundle> help() {
        return this == EN ? Optional.empty() : Optional.of(Texts.bundle("cli", "help", inWindow()));
    }

    public Texts texts() {
        return Texts.of("cli", "report", inWindow());
    }
}
