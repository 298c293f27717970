package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
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
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * Holds every answer of {@code ./lab run} to the one that was published: each topic's inputs by all
 * of its methods, with steps and without.
 *
 * <p>Where an answer is meant to change, {@code -Drasterlab.golden=write} writes the files anew;
 * the change of each line is then reviewed as any other.
 */
@EnabledOnOs(
        architectures = {"amd64", "x86_64"},
        disabledReason = "the last bits of sines and cosines differ between processors")
class GoldenRunTest {
    private static final Path FOLDER =
            Path.of("src", "test", "resources", "rasterlab", "app", "golden");

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
        List<String> answers = answers(topic);
        Path file = FOLDER.resolve(topic + ".txt");
        if ("write".equals(System.getProperty("rasterlab.golden"))) Files.write(file, answers);
        List<String> golden = Files.readAllLines(file);
        for (int i = 0; i < Math.min(golden.size(), answers.size()); i++)
            assertEquals(
                    sameInAllVersions(golden.get(i)),
                    sameInAllVersions(answers.get(i)),
                    file + ", line " + (i + 1));
        assertEquals(golden.size(), answers.size(), file + ": number of lines");
    }

    private static List<String> answers(String topic) throws IOException {
        var lines = new ArrayList<String>();
        for (String input : GoldenInputs.of(topic))
            for (Method<?> method : topicNamed(topic).methods()) {
                lines.add(line(input, topic, method.name()));
                lines.add(line(input, topic, method.name(), "--steps"));
            }
        assertTrue(!lines.isEmpty(), "inputs.txt has no input of topic " + topic);
        return lines;
    }

    private static Topic<?, ?, ?> topicNamed(String name) {
        return Topics.all().stream().filter(t -> t.name().equals(name)).findFirst().orElseThrow();
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
