package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.Tuple;
import rasterlab.app.cli.Ran;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** {@code ./lab} answers whatever it is given, or says in one line what is wrong: never a crash. */
@Tag("slow")
class RunPropertyTest {
    private static final List<String> ODD =
            List.of(
                    "NaN",
                    "-Infinity",
                    "1e999",
                    "-1e308",
                    "1e-320",
                    "-0.0",
                    "0.5",
                    "2147483648",
                    "null",
                    "true",
                    "\"name\"",
                    "\"\\ud800\"",
                    "[]",
                    "{}",
                    "[[0,0]]",
                    "[1,2,3]",
                    "{\"name\":\"ISOMETRIC\"}");
    private static final List<String> PIECES =
            List.of("", "[", "]", "{", "}", ",", ":", "\"", "-", "e", "\u0000", "é", "1");

    /** The text's program as printed, which reads before the first corner of every polygon. */
    private static final String CRASHES = "shortest-diagonal-printed-textbook";

    /** A method, JSON for it, and the options. */
    record Input(String topic, String method, String json, List<String> options) {
        Ran run() {
            var arguments = new ArrayList<>(List.of("run", topic, method));
            arguments.addAll(options);
            return Ran.labReading(json, arguments.toArray(String[]::new));
        }
    }

    @Example
    void undamagedInputIsAnsweredBySomeMethod() {
        for (Topic<?, ?, ?> topic : Topics.all())
            assertTrue(
                    topic.methods().stream()
                            .map(
                                    method ->
                                            new Input(
                                                    topic.name(),
                                                    method.name(),
                                                    GoldenFile.example(topic.name()),
                                                    List.of()))
                            .anyMatch(input -> input.run().exitCode() == 0),
                    topic.name());
    }

    @Property(tries = 200)
    void changedValuesNeverCrashAMethod(@ForAll("inputsWithOtherValues") Input input) {
        assertAnsweredOrComplains(input);
    }

    @Property(tries = 150)
    void damagedTextNeverCrashesTheParser(@ForAll("damagedInputs") Input input) {
        assertAnsweredOrComplains(input);
    }

    private static void assertAnsweredOrComplains(Input input) {
        Ran ran = input.run();
        ran.out().lines().forEach(RunPropertyTest::read);
        // Faulty methods are known to be endless, and right ones may have too much to say.
        boolean gaveUp =
                ran.err().contains(" does not end: ")
                        || ran.err().contains(" the most that one ")
                        || ran.err().startsWith("./lab run: " + CRASHES + " crashed: ");
        assertEnded(ran, gaveUp ? List.of(0, 2, 3, 4) : List.of(0, 2, 3));
    }

    private static void assertEnded(Ran ran, List<Integer> allowed) {
        assertTrue(allowed.contains(ran.exitCode()), ran.exitCode() + ": " + ran.err());
        assertFalse(ran.err().contains("\tat "), ran.err());
        if (ran.exitCode() == 0) return;
        assertEquals("", ran.out());
        assertEquals(1, ran.err().lines().count(), ran.err());
    }

    @Provide
    Arbitrary<Input> inputsWithOtherValues() {
        return inputs(
                Combinators.combine(Arbitraries.integers().between(0, 40), values())
                        .as(Change::new)
                        .list()
                        .ofMaxSize(3)
                        .map(changes -> (Damage) json -> changed(json, changes)));
    }

    @Provide
    Arbitrary<Input> damagedInputs() {
        return inputs(
                Combinators.combine(
                                Arbitraries.integers().between(0, 150),
                                Arbitraries.integers().between(0, 3),
                                Arbitraries.of(PIECES))
                        .as(Cut::new)
                        .list()
                        .ofMinSize(1)
                        .ofMaxSize(2)
                        .map(cuts -> (Damage) json -> cut(json, cuts)));
    }

    private static final List<String> WORDS =
            List.of(
                    "run",
                    "methods",
                    "completion",
                    "help",
                    "grader",
                    "render",
                    "check",
                    "line",
                    "matrix",
                    "bresenham",
                    "formula",
                    "house.obj",
                    "--help",
                    "--version",
                    "--steps",
                    "--lines",
                    "--lang",
                    "ru",
                    "--size",
                    "9x9",
                    "--camera",
                    "1,2,3",
                    "--out",
                    "/nowhere/at/all.png",
                    "--",
                    "-",
                    "",
                    " ",
                    "--=",
                    "@file",
                    "\u0000",
                    "two\nlines",
                    "é");

    @Property(tries = 150)
    void argumentsNeverCrashTheCommandLine(@ForAll("arguments") List<String> arguments) {
        assertEnded(Ran.lab(arguments.toArray(String[]::new)), List.of(0, 2, 3));
    }

    @Provide
    Arbitrary<List<String>> arguments() {
        return Arbitraries.oneOf(Arbitraries.of(WORDS), Arbitraries.strings().ofMaxLength(5))
                .list()
                .ofMaxSize(5);
    }

    /** These would go to work; an option that nobody knows keeps them from it. */
    @Property(tries = 50)
    void argumentsNeverStartALongCommand(
            @ForAll("longCommands") String command, @ForAll("arguments") List<String> arguments) {
        var all = new ArrayList<>(List.of(command, "--unknown"));
        all.addAll(arguments);
        Ran ran = Ran.lab(all.toArray(String[]::new));
        assertEnded(ran, List.of(0, 2));
    }

    @Provide
    Arbitrary<String> longCommands() {
        return Arbitraries.of("study", "hazards", "tour", "render", "check", "bench");
    }

    /** Makes other JSON of a topic's example. */
    private interface Damage {
        String of(String json);
    }

    private static Arbitrary<Input> inputs(Arbitrary<Damage> damages) {
        Arbitrary<List<String>> options =
                Arbitraries.of(List.of(), List.of("--steps"), List.of("--lines"));
        return Arbitraries.of(Topics.all())
                .flatMap(
                        topic ->
                                Combinators.combine(methods(topic), damages, options)
                                        .as(
                                                (method, damage, option) ->
                                                        new Input(
                                                                topic.name(),
                                                                method,
                                                                damage.of(
                                                                        GoldenFile.example(
                                                                                topic.name())),
                                                                option)));
    }

    private static Arbitrary<String> methods(Topic<?, ?, ?> topic) {
        return Arbitraries.of(topic.methods().stream().map(Method::name).toList());
    }

    private static Arbitrary<String> values() {
        return Arbitraries.frequencyOf(
                Tuple.of(3, Arbitraries.integers().between(-100, 100).map(String::valueOf)),
                Tuple.of(2, Arbitraries.doubles().map(String::valueOf)),
                Tuple.of(3, Arbitraries.of(ODD)));
    }

    /**
     * A change of one value to another.
     *
     * @param place which, counted through all values that hold no others, and beyond the last from
     *     the first again
     */
    record Change(int place, String value) {}

    private static String changed(String json, List<Change> changes) {
        JsonNode tree = read(json);
        for (Change change : changes) change(tree, change);
        return tree.toString();
    }

    /** Reads JSON strictly: NaN and Infinity are none. */
    private static JsonNode read(String json) {
        try {
            return new ObjectMapper().readTree(json);
        } catch (JsonProcessingException e) {
            throw new AssertionError(json, e);
        }
    }

    private static void change(JsonNode tree, Change change) {
        var leaves = new ArrayList<Runnable>();
        collect(tree, new RawValue(change.value()), leaves);
        if (!leaves.isEmpty()) leaves.get(change.place() % leaves.size()).run();
    }

    /** Adds what puts the value in place of each one below {@code node}. */
    private static void collect(JsonNode node, RawValue value, List<Runnable> leaves) {
        if (node instanceof ObjectNode object)
            object.fieldNames()
                    .forEachRemaining(
                            name -> {
                                leaves.add(() -> object.putRawValue(name, value));
                                collect(object.get(name), value, leaves);
                            });
        if (node instanceof ArrayNode array)
            for (int i = 0; i < array.size(); i++) {
                int at = i;
                leaves.add(() -> array.setRawValue(at, value));
                collect(array.get(i), value, leaves);
            }
    }

    /** A piece of text in place of {@code length} characters. */
    record Cut(int at, int length, String piece) {}

    private static String cut(String json, List<Cut> cuts) {
        var text = new StringBuilder(json);
        for (Cut cut : cuts) {
            int at = Math.min(cut.at(), text.length());
            text.replace(at, Math.min(text.length(), at + cut.length()), cut.piece());
        }
        return text.toString();
    }
}
