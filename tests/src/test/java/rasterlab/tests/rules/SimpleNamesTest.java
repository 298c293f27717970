package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

/** A simple name stands for one thing in all modules, so that a search for it finds that thing. */
class SimpleNamesTest {
    /** A type of Kotlin that stands in no other. */
    private static final Pattern KOTLIN_TYPE =
            Pattern.compile("^(?:[a-z]+ )*(?:class|interface|object) (\\w+)", Pattern.MULTILINE);

    @Test
    @DisplayName("a type has the name of another one")
    void noNameStandsForTwoThings() {
        var places = new TreeMap<String, List<String>>();
        for (Path file : Repository.sources(".java", ".kt")) {
            String path = Repository.root().relativize(file).toString();
            if (!path.contains("/src/main/") || path.contains("/resources/")) continue;
            for (String name : types(file.getFileName().toString(), Repository.text(file)))
                places.computeIfAbsent(name, any -> new ArrayList<>()).add(path);
        }
        assertTrue(places.size() > 1_000, "only " + places.size() + " types were found");
        places.values().removeIf(paths -> paths.size() < 2);
        assertEquals(Map.of(), places, "rename all but one type of each of these names");
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
}
