package rasterlab.app.cli;

import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * What a command reads from and writes to.
 *
 * @param out results only
 * @param err progress and complaints
 */
record Console(InputStream in, PrintStream out, PrintStream err) {
    /**
     * Text goes out in UTF-8, also where the system's locale is set to plain ASCII, but for a
     * Windows console, which shows only its own code page.
     */
    static Console of(InputStream in, PrintStream out, PrintStream err) {
        return new Console(
                in,
                new PrintStream(out, false, charset("stdout.encoding")),
                new PrintStream(err, true, charset("stderr.encoding")));
    }

    private static Charset charset(String property) {
        boolean windows =
                System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("windows");
        if (!windows) return StandardCharsets.UTF_8;
        String console = System.getProperty(property, System.getProperty("sun." + property));
        return console == null ? StandardCharsets.UTF_8 : Charset.forName(console);
    }
}
