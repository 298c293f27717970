package rasterlab.tests.bench;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;
import picocli.CommandLine;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;

/**
 * What the benchmarks say to people, in one language; names of works and methods are the same in
 * each.
 */
public record BenchWords(Language language) {
    public static final BenchWords ENGLISH = new BenchWords(Language.ENGLISH);

    /** Pattern of {@link MessageFormat}; numbers are given as text. */
    public String text(String key, Object... arguments) {
        return new MessageFormat(bundle().getString(key), Locale.ROOT).format(arguments);
    }

    /** The table's head with the line that Markdown wants below it. */
    public String head(String key) {
        String head = text(key);
        return head + "\n" + head.replaceAll("[^|]+", " --- ").strip();
    }

    /** The command with its help in this language. */
    CommandLine worn(CommandLine command) {
        return language == Language.ENGLISH ? command : command.setResourceBundle(bundle());
    }

    /** What picocli says in English. */
    String said(String english) {
        if (language == Language.ENGLISH) return english;
        String sentence = Character.toLowerCase(english.charAt(0)) + english.substring(1);
        return Complaints.said(language, sentence).replaceAll("'([^']*)'", "«$1»");
    }

    private ResourceBundle bundle() {
        var onlyAsked =
                ResourceBundle.Control.getNoFallbackControl(
                        ResourceBundle.Control.FORMAT_PROPERTIES);
        return ResourceBundle.getBundle(
                "rasterlab.tests.bench.words", language.locale(), onlyAsked);
    }
}
