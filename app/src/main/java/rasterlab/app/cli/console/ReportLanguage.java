package rasterlab.app.cli.console;

import java.util.ListResourceBundle;
import java.util.Locale;
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

    /**
     * The words of help, for picocli; in English they stand with the commands, but for those of the
     * options that it adds itself.
     */
    public ResourceBundle help() {
        return this == EN ? new AddedOptions() : Texts.bundle("cli", "help", inWindow());
    }

    public Texts texts() {
        return Texts.of("cli", "report", inWindow());
    }

    private static final class AddedOptions extends ListResourceBundle {
        @Override
        protected Object[][] getContents() {
            return new Object[][] {
                {"help", "Shows this help and exits."},
                {"version", "Prints the version and exits."}
            };
        }
    }
}
