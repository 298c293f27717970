package rasterlab.tests.bench.language;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;
import picocli.CommandLine;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The words of the benchmarks in one language; names of works and methods are the same in each. */
public record BenchWords(Language language) {
    public static final BenchWords ENGLISH = new BenchWords(Language.ENGLISH);

    /** Pattern of {@link MessageFormat}; numbers are given as text. */
    public String text(String key, Object... arguments) {
        return new MessageFormat(bundle().getString(key), Locale.ROOT).format(arguments);
    }

    /** The machine that is measured on. */
    public String machine() {
        return text(
                "machine",
                System.getProperty("os.name"),
                System.getProperty("os.arch"),
                String.valueOf(Runtime.getRuntime().availableProcessors()),
                Runtime.version().toString());
    }

    /** The table's head with the line that Markdown wants below it. */
    public String head(String key) {
        String head = text(key);
        return head + "\n" + head.replaceAll("[^|]+", " --- ").strip();
    }

    /** The command with its help in this language. */
    public CommandLine worn(CommandLine command) {
        return command.setResourceBundle(bundle());
    }

    private ResourceBundle bundle() {
        return Texts.bundle("rasterlab.tests.bench.language.words", language);
    }
}
