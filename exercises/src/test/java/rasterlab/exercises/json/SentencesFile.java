package rasterlab.exercises.json;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;

/**
 * Sentences that were said so far. Where one is meant to change, {@code -Drasterlab.golden=write}
 * writes the file anew; each changed line is then reviewed.
 */
public final class SentencesFile {
    private static final Path FOLDER =
            Path.of("src", "test", "resources", "rasterlab", "exercises", "json");

    private SentencesFile() {}

    /**
     * The complaints of each reader about a text without the field {@code f}, and about one with
     * each value in it: a line each.
     *
     * @param readers by their names
     * @param said reads a text and tells what came of it
     */
    public static <R> List<String> ofField(
            Map<String, R> readers, List<String> values, BiFunction<R, String, String> said) {
        var lines = new ArrayList<String>();
        readers.forEach(
                (name, reader) -> {
                    lines.add(name + " of nothing: " + said.apply(reader, "{}"));
                    for (String value : values) {
                        String json = "{\"f\": " + value + "}";
                        lines.add(name + " of " + value + ": " + said.apply(reader, json));
                    }
                });
        return lines;
    }

    /** The lines of the file of that name. */
    public static List<String> read(String name, List<String> said) {
        try {
            Path file = FOLDER.resolve(name);
            if ("write".equals(System.getProperty("rasterlab.golden"))) Files.write(file, said);
            return Files.readAllLines(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
