package rasterlab.app.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.StringJoiner;
import java.util.zip.CRC32;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;

/**
 * Holds what {@code ./lab methods} says of each topic, in both languages, to what was published, by
 * checksums.
 *
 * @see GoldenFile
 */
class MethodsTextTest {
    static List<String> topics() {
        return Topics.names();
    }

    @ParameterizedTest
    @MethodSource("topics")
    void everyTopicIsExplainedAsPublished(String topic) throws IOException {
        var line = new StringJoiner(" ");
        for (String language : List.of("en", "ru"))
            line.add(sum(Ran.lab("--lang", language, "methods", topic)));
        GoldenFile.of(topic).assertKept("methods", List.of(line.toString()));
    }

    private static String sum(Ran ran) {
        ran.assertDone();
        var sum = new CRC32();
        sum.update(ran.out().replace("\r\n", "\n").getBytes(StandardCharsets.UTF_8));
        return "%s:%08x".formatted(ran.out().lines().count(), sum.getValue());
    }
}
