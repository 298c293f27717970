package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiFunction;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

/** A simple name stands for one thing in all modules, so that a search for it finds that thing. */
class SimpleNamesTest {
    /** A type of Kotlin that stands in no other. */
    private static final Pattern KOTLIN_TYPE =
            Pattern.compile("^(?:[a-z]+ )*(?:class|interface|object) (\\w+)", Pattern.MULTILINE);

    /** A type of Java within another one, which other files see unless it is private. */
    private static final Pattern NESTED =
            Pattern.compile(
                    "^ +((?:[a-z-]+ )*)(?:class|record|interface|enum) (\\w+)", Pattern.MULTILINE);

    /** A type of Kotlin within another one. */
    private static final Pattern KOTLIN_NESTED =
            Pattern.compile(
                    "^ +((?:[a-z]+ )*)(?:class|interface|object) (\\w+)", Pattern.MULTILINE);

    /** Where a comment's words are not taken for types. */
    private static final Pattern COMMENT = Pattern.compile("/\\*.*?\\*/", Pattern.DOTALL);

    /**
     * Names of types within others, such as {@code Line.Step}, that stand for more than one thing
     * today, one a line: no line is added.
     */
    private static final String SHARED = "nested-names.txt";

    @Test
    @DisplayName("a type has the name of another one")
    void noNameStandsForTwoThings() {
        var places = places(SimpleNamesTest::types);
        assertTrue(places.size() > 1_000, "only " + places.size() + " types were found");
        places.values().removeIf(paths -> paths.size() < 2);
        assertEquals(Map.of(), places, "rename all but one type of each of these names");
    }

    @Test
    @DisplayName("a type within another one has the name of a third")
    void noNestedNameIsAddedThatStandsForTwoThings() throws IOException {
        Map<String, List<String>> shared = places(SimpleNamesTest::allTypes);
        shared.values().removeIf(paths -> paths.size() < 2);
        Set<String> listed = listed();
        var fresh = new TreeMap<>(shared);
        fresh.keySet().removeAll(listed);
        assertEquals(
                Map.of(), fresh, "rename a nested type of each of these names, or make it private");
        var single = new TreeSet<>(listed);
        single.removeAll(shared.keySet());
        assertEquals(Set.of(), single, "these stand for one thing: take them off " + SHARED);
    }

    @Test
    @DisplayName("a type within another one is not seen, or a private one is")
    void nestedTypesOfBothLanguagesAreSeen() {
        String java = "/*\n class No */\nclass A {\n    record B() {}\n    private enum C {}\n}";
        assertEquals(List.of("A", "B"), allTypes("A.java", java));
        String kotlin = "class A {\n    data class B(\n    private class C\n    companion object {";
        assertEquals(List.of("A", "B"), allTypes("Main.kt", kotlin));
    }

    /** The types by their names, with the files that declare them. */
    private static Map<String, List<String>> places(
            BiFunction<String, String, List<String>> types) {
        var places = new TreeMap<String, List<String>>();
        for (Path file : Repository.sources(".java", ".kt")) {
            String path = Repository.root().relativize(file).toString();
            if (!path.contains("/src/main/") || path.contains("/resources/")) continue;
            for (String name : types.apply(file.getFileName().toString(), Repository.text(file)))
                places.computeIfAbsent(name, any -> new ArrayList<>()).add(path);
        }
        return places;
    }

    private static Set<String> listed() throws IOException {
        try (var in = SimpleNamesTest.class.getResourceAsStream(SHARED)) {
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            return text.lines().collect(Collectors.toCollection(TreeSet::new));
        }
    }

    @Test
    @DisplayName("a type of Kotlin is not seen, or one within another is")
    void typesOfBothLanguagesAreSeen() {
        assertEquals(List.of("Grip"), types("Grip.java", "record Other() {}"));
        assertEquals(List.of(), types("package-info.java", ""));
        String kotlin = "private class A(\n    class B\ndata class C(\nfun interface D\nclass E {";
        assertEquals(List.of("A", "C", "D", "E"), types("Main.kt", kotlin));
    }

    /** The types that a file declares, but for those within others. */
    private static List<String> types(String file, String text) {
        if (file.equals("package-info.java")) return List.of();
        if (file.endsWith(".java")) return List.of(file.substring(0, file.length() - 5));
        return KOTLIN_TYPE.matcher(text).results().map(type -> type.group(1)).toList();
    }

    /** The types that a file declares, with those within others that are not private. */
    private static List<String> allTypes(String file, String text) {
        var names = new ArrayList<>(types(file, text));
        Pattern nested = file.endsWith(".java") ? NESTED : KOTLIN_NESTED;
        nested.matcher(COMMENT.matcher(text).replaceAll(""))
                .results()
                .filter(type -> !type.group(1).contains("private "))
                .forEach(type -> names.add(type.group(2)));
        return names;
    }
}
