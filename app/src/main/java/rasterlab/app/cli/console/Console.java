package rasterlab.app.cli.console;

import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * The streams that a command reads from and writes to.
 *
 * @param out results only
 * @param err progress and complaints
 * @param language of what people read
 */
public record Console(InputStream in, PrintStream out, PrintStream err, ReportLanguage language) {
    /**
     * Text goes out in UTF-8, also where the system's locale is set to plain ASCII, but for a
     * Windows console, which shows only its own code page.
     */
    public static Console of(
            InputStream in, PrintStream out, PrintStream err, ReportLanguage language) {
        return new Console(
                in,
                new PrintStream(out, false, charset("stdout.encoding")),
                new PrintStream(err, true, charset("stderr.encoding")),
                language);
    }

    /** Says something to who waits, in the report's words and one line. */
    public void tell(String key, Object... arguments) {
        err.println(Failures.oneLine(language.texts().text(key, arguments)));
    }

    private static Charset charset(String property) {
        boolean windows =
                System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("windows");
        if (!windows) return StandardCharsets.UTF_8;
        String console = System.getProperty(property, System.getProperty("sun." + property));
        return console == null ? StandardCharsets.UTF_8 : Charset.forName(console);
    }
}
