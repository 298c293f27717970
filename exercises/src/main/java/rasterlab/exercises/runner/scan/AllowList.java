package rasterlab.exercises.runner.scan;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The classes and members that a student's method may use, as {@code allowed-classes.txt} says. */
public final class AllowList {
    private static final String FILE = "allowed-classes.txt";

    /** Internal class name to the words after it. */
    private final Map<String, Set<String>> members = new HashMap<>();

    private AllowList(String text) {
        text.lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty() && !line.startsWith("#"))
                .forEach(this::add);
    }

    private void add(String line) {
        List<String> words = List.of(line.split("\\s+"));
        String name = words.get(0).replace('.', '/');
        if (members.put(name, Set.copyOf(words.subList(1, words.size()))) != null)
            throw new IllegalStateException(FILE + " lists " + words.get(0) + " twice");
    }

    public static AllowList builtIn() {
        return new AllowList(text());
    }

    public static String text() {
        try (InputStream in = AllowList.class.getResourceAsStream(FILE)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Whether the class may be mentioned.
     *
     * @param type internal name, such as "java/util/List"
     */
    boolean allows(String type) {
        return members.containsKey(type);
    }

    /** Whether that method, field or constructor of the class may be used. */
    boolean allows(String type, String member) {
        Set<String> words = members.getOrDefault(type, Set.of());
        return words.contains(member) || words.contains("*") && !words.contains("-" + member);
    }

    /** All methods and fields that may be used, sorted, where the class has only some. */
    List<String> some(String type) {
        Set<String> words = members.getOrDefault(type, Set.of());
        if (words.contains("*")) return List.of();
        return words.stream().filter(word -> !word.equals("<init>")).sorted().toList();
    }
}
