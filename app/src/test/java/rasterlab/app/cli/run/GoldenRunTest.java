package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * Holds every answer of {@code ./lab run} to the one that was published: each topic's inputs by all
 * of its methods, with steps and without.
 *
 * @see GoldenFile
 */
@EnabledOnOs(
        architectures = {"amd64", "x86_64"},
        disabledReason = "the last bits of sines and cosines differ between processors")
class GoldenRunTest {
    /** A longer answer is kept by its beginning and a checksum. */
    private static final int LONGEST = 600;

    /** A number that is not whole, since its digits differ between versions of Java. */
    private static final Pattern FRACTION =
            Pattern.compile("-?\\d+(?:\\.\\d+)?[eE][-+]?\\d+|-?\\d+\\.\\d+");

    static Stream<String> topics() {
        return Topics.all().stream().map(Topic::name);
    }

    @ParameterizedTest
    @MethodSource("topics")
    void everyMethodAnswersAsPublished(String topic) throws IOException {
        GoldenFile.of(topic)
                .assertKept("answers", answers(topic), GoldenRunTest::sameInAllVersions);
    }

    private static List<String> answers(String topic) throws IOException {
        var lines = new ArrayList<String>();
        for (String input : GoldenFile.inputs(topic))
            for (Method<?> method : Topics.named(topic).methods()) {
                lines.add(line(input, topic, method.name()));
                lines.add(line(input, topic, method.name(), "--steps"));
            }
        assertTrue(!lines.isEmpty(), "no input of topic " + topic + " is held");
        return lines;
    }

    private static String line(String input, String topic, String method, String... options) {
        String[] arguments =
                Stream.concat(Stream.of("run", topic, method), Stream.of(options))
                        .toArray(String[]::new);
        Ran ran = Ran.labReading(input, arguments);
        String said = (ran.exitCode() == 0 ? ran.out() : ran.err()).strip();
        String how = String.join(" ", Arrays.asList(arguments).subList(2, arguments.length));
        return "%s %s -> %d %s".formatted(how, input, ran.exitCode(), shortened(said));
    }

    private static String shortened(String said) {
        if (said.length() <= LONGEST) return said;
        var sum = new CRC32();
        sum.update(sameInAllVersions(said).getBytes(StandardCharsets.UTF_8));
        return said.substring(0, LONGEST / 2).replaceFirst("[-0-9.eE]*$", "")
                + "… checksum "
                + Long.toHexString(sum.getValue());
    }

    /** Versions of Java print a double by different digits that all read back as that double. */
    private static String sameInAllVersions(String text) {
        return FRACTION.matcher(text).replaceAll(GoldenRunTest::bits);
    }

    private static String bits(MatchResult number) {
        return Double.toHexString(Double.parseDouble(number.group()));
    }
}
