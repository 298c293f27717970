package rasterlab.tests.rules;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.mapping;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

/** The list of attacks on the grading server names cases that exist, so that none is lost. */
class AttackCasesTest {
    private static final String FILE = "attack-cases.txt";
    private static final int ATTACKS = 64;

    /** An attack: its number, its name, what has to come of it, and the tests that hold that. */
    private record Attack(int number, String name, String outcome, List<HeldBy> tests) {
        static Attack of(String line) {
            String[] parts = line.split(" \\| ");
            assertEquals(
                    3, parts.length, () -> FILE + ": write number | attack | outcome: " + line);
            return new Attack(Integer.parseInt(parts[0]), parts[1], parts[2], new ArrayList<>());
        }
    }

    /**
     * A test, or one of its cases.
     *
     * @param name of the case in the report; empty for a test without cases
     */
    private record HeldBy(String type, String test, String name) {
        static HeldBy of(String line) {
            String[] parts = line.strip().split("[.\\[]", 3);
            assertTrue(
                    parts.length == 2 || parts.length == 3 && line.endsWith("]"),
                    () -> FILE + ": write Class.method or Class.method[case]: " + line);
            String name = parts.length == 2 ? "" : parts[2].substring(0, parts[2].length() - 1);
            return new HeldBy(parts[0], parts[1], name);
        }

        boolean isIn(TestText text) {
            return name.isEmpty() ? text.hasTest(test) : text.hasCase(test, name);
        }

        @Override
        public String toString() {
            return type + "." + test + (name.isEmpty() ? "" : "[" + name + "]");
        }
    }

    @Test
    @DisplayName("an attack has no line, or its line stands in another one's place")
    void eachNumberHasALine() throws IOException {
        assertEquals(
                IntStream.rangeClosed(1, ATTACKS).boxed().toList(),
                attacks().stream().map(Attack::number).toList(),
                FILE + ": one line for each number from 1 to " + ATTACKS);
        for (Attack attack : attacks())
            assertFalse(attack.tests().isEmpty(), () -> "no test holds against " + attack);
    }

    @Test
    @DisplayName("a test against an attack, or the case of it, was renamed or removed")
    void eachCaseExists() throws IOException {
        Map<String, List<TestText>> classes = classes();
        for (Attack attack : attacks())
            for (HeldBy test : attack.tests()) {
                List<TestText> texts = classes.getOrDefault(test.type(), List.of());
                String said = FILE + ": attack " + attack.number() + ": " + test;
                if (test.name().isEmpty())
                    assertTrue(
                            texts.stream().noneMatch(one -> one.hasCases(test.test())),
                            said + " has cases; name the attack's");
                assertTrue(
                        texts.stream().anyMatch(test::isIn),
                        said + " does not exist; name what holds against it");
            }
    }

    @Test
    @DisplayName("one case stands for two attacks, so that one of them may be held by nothing")
    void eachCaseIsOfOneAttack() throws IOException {
        Map<HeldBy, Integer> owners = new HashMap<>();
        for (Attack attack : attacks())
            for (HeldBy test : attack.tests()) {
                Integer other = owners.put(test, attack.number());
                assertEquals(null, other, () -> test + " is also named for " + attack.number());
            }
    }

    /** The classes of tests by their names, which two modules may share. */
    private static Map<String, List<TestText>> classes() {
        return Repository.sources("Test.java", "Test.kt").stream()
                .collect(
                        groupingBy(
                                file -> file.getFileName().toString().replaceFirst("\\.\\w+$", ""),
                                mapping(
                                        file -> new TestText(Repository.text(file)),
                                        Collectors.toList())));
    }

    private static List<Attack> attacks() throws IOException {
        List<Attack> attacks = new ArrayList<>();
        try (InputStream file = AttackCasesTest.class.getResourceAsStream(FILE)) {
            new String(file.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> !line.startsWith("#"))
                    .forEach(
                            line -> {
                                if (line.startsWith(" "))
                                    attacks.get(attacks.size() - 1).tests().add(HeldBy.of(line));
                                else attacks.add(Attack.of(line));
                            });
        }
        return attacks;
    }
}
