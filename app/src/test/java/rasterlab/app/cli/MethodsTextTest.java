package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.StringJoiner;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import rasterlab.engine.Topics;

/**
 * Holds what {@code ./lab methods} says of each topic, in both languages, to what was published, by
 * checksums.
 *
 * <p>Where a text is meant to change, {@code -Drasterlab.golden=write} writes the file anew; the
 * change of each line is then reviewed as any other.
 */
class MethodsTextTest {
    private static final Path FILE =
            Path.of("src", "test", "resources", "rasterlab", "app", "golden", "methods.txt");

    @Test
    void everyTopicIsExplainedAsPublished() throws IOException {
        List<String> said = new ArrayList<>();
        for (String topic : Topics.names()) {
            var line = new StringJoiner(" ");
            line.add(topic);
            for (String language : List.of("en", "ru"))
                line.add(sum(Ran.lab("--lang", language, "methods", topic)));
            said.add(line.toString());
        }
        if ("write".equals(System.getProperty("rasterlab.golden"))) Files.write(FILE, said);
        assertEquals(String.join("\n", Files.readAllLines(FILE)), String.join("\n", said));
    }

    private static String sum(Ran ran) {
        ran.assertDone();
        var sum = new CRC32();
        sum.update(ran.out().replace("\r\n", "\n").getBytes(StandardCharsets.UTF_8));
        return "%s:%08x".formatted(ran.out().lines().count(), sum.getValue());
    }
}
