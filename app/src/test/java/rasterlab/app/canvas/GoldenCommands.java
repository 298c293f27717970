package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.zip.CRC32;

/**
 * Holds the commands that a lab copies to those that it copied before.
 *
 * <p>Where they are meant to change, {@code -Drasterlab.golden=write} writes the files anew; the
 * change of each line is then reviewed as any other.
 */
public final class GoldenCommands {
    private static final Path FOLDER =
            Path.of("src", "test", "resources", "rasterlab", "app", "golden", "commands");

    /** A number that is not whole, since its digits differ between versions of Java. */
    private static final Pattern FRACTION = Pattern.compile("-?\\d+\\.\\d+(?:E-?\\d+)?");

    /** The most characters of a command that is kept whole; of a longer one the checksum is. */
    private static final int WHOLE = 400;

    private GoldenCommands() {}

    /** Passes if the file of that topic has those commands, each behind what it is of. */
    public static void assertKept(String topic, List<String> commands) throws IOException {
        List<String> lines = commands.stream().map(GoldenCommands::exact).toList();
        Path file = FOLDER.resolve(topic + ".txt");
        if ("write".equals(System.getProperty("rasterlab.golden"))) {
            Files.createDirectories(FOLDER);
            Files.write(file, lines);
        }
        List<String> golden = Files.readAllLines(file);
        for (int i = 0; i < Math.min(golden.size(), lines.size()); i++)
            assertEquals(golden.get(i), lines.get(i), file + ", line " + (i + 1));
        assertEquals(golden.size(), lines.size(), file + ": number of lines");
    }

    private static String exact(String command) {
        String exact =
                FRACTION.matcher(command)
                        .replaceAll(
                                number -> Double.toHexString(Double.parseDouble(number.group())));
        return exact.length() <= WHOLE ? exact : exact.substring(0, WHOLE) + "… " + sum(exact);
    }

    private static String sum(String text) {
        var sum = new CRC32();
        sum.update(text.getBytes(StandardCharsets.UTF_8));
        return "%d characters, %08x".formatted(text.length(), sum.getValue());
    }
}
