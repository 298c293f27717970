package rasterlab.app.golden;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

/**
 * The published answers of one topic, in one file a topic: each part behind a line {@code == PART}.
 *
 * <p>Where that is meant to change, {@code -Drasterlab.golden=write} writes the parts anew; the
 * change of each line is then reviewed as any other. The inputs of a topic are those in its part
 * {@code answers}: a further one is added as a line there, with any method and no right answer.
 *
 * @param parts the lines of each, in the order of the file
 */
public record GoldenFile(Path file, Map<String, List<String>> parts) {
    private static final Path FOLDER =
            Path.of("src", "test", "resources", "rasterlab", "app", "golden");
    private static final String HEAD = "== ";

    /** A method and its options, an input, and what came of it. */
    private static final Pattern ANSWER =
            Pattern.compile(
                    "(?<how>[a-z0-9-]+(?: --steps)?) (?<input>.*?) ?-> (?<code>\\d)(?: .*)?");

    /** The file of that topic; without parts where there is none. */
    public static GoldenFile of(String topic) {
        Path file = FOLDER.resolve(topic + ".txt");
        var parts = new LinkedHashMap<String, List<String>>();
        List<String> part = new ArrayList<>();
        for (String line : read(file))
            if (line.startsWith(HEAD)) {
                part = new ArrayList<>();
                parts.put(line.substring(HEAD.length()), part);
            } else part.add(line);
        return new GoldenFile(file, parts);
    }

    private static List<String> read(Path file) {
        try {
            return Files.exists(file) ? Files.readAllLines(file) : List.of();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The inputs whose answers are held, each once; the topic's hazards where none is yet. */
    public static List<String> inputs(String topic) {
        List<String> held =
                of(topic).lines("answers").stream()
                        .map(line -> parsed(line).group("input"))
                        .distinct()
                        .toList();
        return held.isEmpty() ? hazards(Topics.named(topic)) : held;
    }

    private static <C, I, O> List<String> hazards(Topic<C, I, O> topic) {
        return topic.hazards().stream()
                .limit(2)
                .map(hazard -> CommandInput.of(topic.format(), hazard.input()))
                .toList();
    }

    /** An input that most of the topic's methods answer. */
    public static String example(String topic) {
        return inputs(topic).get(0);
    }

    /**
     * An input that is refused.
     *
     * @param code exit code of {@code ./lab run}
     */
    public record Refused(String topic, String method, String input, int code) {}

    /** The inputs of that topic which are held to be refused. */
    public static Stream<Refused> refused(String topic) {
        return of(topic).lines("refused").stream()
                .map(GoldenFile::parsed)
                .map(
                        found ->
                                new Refused(
                                        topic,
                                        found.group("how"),
                                        found.group("input"),
                                        Integer.parseInt(found.group("code"))));
    }

    private static Matcher parsed(String line) {
        Matcher found = ANSWER.matcher(line);
        if (!found.matches()) throw new AssertionError("no answer: " + line);
        return found;
    }

    private List<String> lines(String part) {
        return parts.getOrDefault(part, List.of());
    }

    /** Passes if that part has those lines. */
    public void assertKept(String part, List<String> lines) throws IOException {
        assertKept(part, lines, line -> line);
    }

    /**
     * Passes if that part has those lines.
     *
     * @param same what two lines must have in common to be the same
     */
    public void assertKept(String part, List<String> lines, UnaryOperator<String> same)
            throws IOException {
        if ("write".equals(System.getProperty("rasterlab.golden"))) write(part, lines);
        List<String> golden = lines(part);
        for (int i = 0; i < Math.min(golden.size(), lines.size()); i++)
            assertEquals(
                    same.apply(golden.get(i)),
                    same.apply(lines.get(i)),
                    "%s, %s, line %d of the part".formatted(file, part, i + 1));
        assertEquals(golden.size(), lines.size(), file + ", " + part + ": number of lines");
    }

    private void write(String part, List<String> lines) throws IOException {
        parts.put(part, lines);
        var all = new ArrayList<String>();
        parts.forEach(
                (name, kept) -> {
                    all.add(HEAD + name);
                    all.addAll(kept);
                });
        Files.write(file, all);
    }
}
