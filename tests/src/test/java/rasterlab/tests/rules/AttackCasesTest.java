package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

/** The list of attacks on the grading server names tests that exist, so that none is lost. */
class AttackCasesTest {
    private static final String FILE = "attack-cases.txt";
    private static final int CASES = 64;

    /** An attack: its number, what it is, and the tests that hold against it. */
    private record Attack(int number, String name, List<String> tests) {
        static Attack of(String line) {
            String[] parts = line.split(" \\| ");
            assertEquals(3, parts.length, () -> FILE + ": write number | attack | tests: " + line);
            return new Attack(
                    Integer.parseInt(parts[0]), parts[1], List.of(parts[2].trim().split(" ")));
        }
    }

    @Test
    @DisplayName("an attack has no line, or its line stands in another one's place")
    void eachNumberHasALine() throws IOException {
        assertEquals(
                IntStream.rangeClosed(1, CASES).boxed().toList(),
                attacks().stream().map(Attack::number).toList(),
                FILE + ": one line for each number from 1 to " + CASES);
    }

    @Test
    @DisplayName("a test against an attack was renamed or removed")
    void eachTestExists() throws IOException {
        Map<String, Path> classes = new HashMap<>();
        for (Path file : Repository.sources("Test.java", "Test.kt"))
            classes.put(file.getFileName().toString().replaceFirst("\\.\\w+$", ""), file);
        for (Attack attack : attacks())
            for (String test : attack.tests()) {
                String[] names = test.split("\\.");
                Path file = classes.get(names[0]);
                String said =
                        "%s: attack %d, %s, is held by %s, which does not exist; name the test that does"
                                .formatted(FILE, attack.number(), attack.name(), test);
                assertTrue(file != null, said);
                Pattern method = Pattern.compile("\\b(?:void|fun) " + names[1] + "\\(");
                assertTrue(method.matcher(Repository.text(file)).find(), said);
            }
    }

    private static List<Attack> attacks() throws IOException {
        try (InputStream file = AttackCasesTest.class.getResourceAsStream(FILE)) {
            return new String(file.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(Attack::of)
                    .toList();
        }
    }
}
