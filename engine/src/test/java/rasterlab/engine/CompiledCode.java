package rasterlab.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URI;
import java.nio.file.Path;
import java.util.spi.ToolProvider;

/** The compiled code of a class, to count its arithmetic. */
public final class CompiledCode {
    private CompiledCode() {}

    /**
     * The instructions of a class, as {@code javap -c} writes them.
     *
     * @param neighbour a class compiled to the same folder
     * @param name of the class in full, {@code $} before a nested one
     */
    public static String of(Class<?> neighbour, String name) {
        URI place =
                URI.create(
                        neighbour.getProtectionDomain().getCodeSource().getLocation().toString());
        var out = new StringWriter();
        var writer = new PrintWriter(out, true);
        int code =
                ToolProvider.findFirst("javap")
                        .orElseThrow()
                        .run(writer, writer, "-p", "-c", "-cp", Path.of(place).toString(), name);
        assertEquals(0, code, out.toString());
        return out.toString();
    }
}
