package rasterlab.app.cli.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.cli.Ran;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** {@code ./lab exercises}: the catalogue, an instructor's own folder, proofs. */
class ExercisesCommandTest {
    @TempDir Path folder;

    private Path made(String topic, String id) {
        Path made = folder.resolve(id);
        Ran.lab("exercises", "new", topic, made.toString()).assertDone();
        return made;
    }

    @ParameterizedTest(name = "a new exercise of kind {0} is refused by validate")
    @CsvSource({"write", "break", "predict"})
    void aNewExerciseOfEachKindIsValid(String kind) throws IOException {
        Path made = folder.resolve("my-line");
        Ran.lab("exercises", "new", "line", made.toString(), "--kind", kind).assertDone();
        Ran.lab("exercises", "validate", made.toString()).assertDone();
        Exercise read = Catalogue.read(made).exercise().orElseThrow();
        assertEquals(kind, read.form().name().toLowerCase(Locale.ROOT));
        assertEquals(
                kind.equals("predict"),
                Files.readString(made.resolve("statement.ru.md")).contains("lab check my-line"));
    }

    @Test
    void aNewExerciseIsRefusedWhereThereIsNoneToBeginWith() {
        String place = folder.resolve("mine").toString();
        Ran color = Ran.lab("exercises", "new", "color", place, "--kind", "predict");
        assertEquals(2, color.exitCode());
        assertTrue(
                color.err().contains("no exercise of topic 'color'; there are line,"), color.err());
        Ran kind = Ran.lab("exercises", "new", "line", place, "--kind", "read");
        assertEquals(2, kind.exitCode());
        assertTrue(
                kind.err().contains("no kind 'read'; there are write, break, predict"), kind.err());
    }

    @Test
    void listsAllExercises() throws IOException {
        String table = Ran.lab("exercises", "list").out();
        for (String id : Catalogue.builtIn().ids()) assertTrue(table.contains("\n" + id + " "), id);
        JsonNode json = new JsonMapper().readTree(Ran.lab("exercises", "list", "--json").out());
        JsonNode first = json.get("exercises").get(0);
        Exercise same = Catalogue.builtIn().all().get(0);
        assertEquals(same.form().code(), first.get("kind").asText());
        assertEquals(same.minutes().orElseThrow(), first.get("minutes").asInt());
        assertEquals("line", first.get("lab").asText());
        assertTrue(
                table.lines()
                        .anyMatch(
                                line ->
                                        line.matches(
                                                "predict-circle +circle +predict +100 +\\d+ .*"
                                                        + " Lines .*")),
                table);
        assertEquals(
                Catalogue.builtIn().all().stream().map(Exercise::id).toList(),
                Stream.iterate(0, i -> i + 1)
                        .limit(json.get("exercises").size())
                        .map(i -> json.get("exercises").get(i).get("id").asText())
                        .toList());
    }

    @ParameterizedTest(
            name = "whoever begins an exercise of kind {0} is not told what is left to do")
    @CsvSource({"write, true", "break, false", "predict, false"})
    void newTellsWhatIsLeftToDo(String kind, boolean hasModel) {
        Path made = folder.resolve("my-line");
        String told = Ran.lab("exercises", "new", "line", made + "", "--kind", kind).out();
        assertEquals(hasModel, told.contains("Model.java"), told);
        String prove = "then prove it: ./lab exercises prove my-line --exercises " + folder + "\n";
        assertTrue(told.endsWith(prove), told);
    }

    @Test
    @DisplayName("an exercise of one's own needs more than its folder")
    void anExerciseOfDataAloneIsListedAndChecked() throws IOException {
        Path made = made("circle", "my-circle");
        String own = folder.toString();
        assertTrue(Ran.lab("exercises", "list", "--exercises", own).out().contains("my-circle"));
        Ran checked =
                Ran.lab(
                        "check",
                        "my-circle",
                        made.resolve("Starter.java").toString(),
                        "--exercises",
                        own,
                        "--out",
                        folder.resolve("pictures").toString());
        assertEquals(1, checked.exitCode(), checked.err());
        assertTrue(checked.out().contains("0 of 48"), checked.out());
    }

    @Test
    void aNewFolderIsValidAndNotYetProved() throws IOException {
        Path made = made("visible-faces", "my-faces");
        Ran valid = Ran.lab("exercises", "validate", made.toString());
        valid.assertDone();
        assertEquals(made + ": nothing is wrong\n", valid.out());
        Ran proof = Ran.lab("exercises", "prove", "my-faces", "--json", "--exercises", folder + "");
        assertEquals(1, proof.exitCode(), proof.err());
        JsonNode one = new JsonMapper().readTree(proof.out()).get("exercises").get(0);
        assertTrue(one.get("faults").toString().contains("the model solution earns 0"));
    }

    @Test
    @DisplayName("only the first fault of a folder is told")
    void validateTellsAllFaults() throws IOException {
        Path made = made("fill", "my-fill");
        Files.delete(made.resolve("statement.ru.md"));
        Files.delete(made.resolve("Starter.java"));
        Ran ran = Ran.lab("exercises", "validate", made.toString());
        assertEquals(1, ran.exitCode());
        assertEquals(2, ran.out().lines().count(), ran.out());
        // a folder of such folders will do
        assertEquals(2, Ran.lab("exercises", "validate", folder + "").out().lines().count());
    }

    @Test
    void provesAnExerciseByItsTable() {
        Ran ran = Ran.lab("exercises", "prove", "point-in-triangle");
        ran.assertDone();
        assertTrue(ran.out().contains("  side-is-outside "), ran.out());
        assertTrue(ran.out().endsWith("point-in-triangle is proved\n\n"), ran.out());
        assertEquals("proving point-in-triangle (1 of 1)\n", ran.err());
    }

    @Test
    @DisplayName("a method that is known to err passes for a right one, or no table is at the end")
    void provesSeveralWithOneTableAtTheEnd() {
        Ran ran = Ran.lab("exercises", "prove", "break-polygon-fill", "polygon-fill");
        ran.assertDone();
        assertTrue(ran.out().contains("\n  naive (promises nothing) "), ran.out());
        assertTrue(ran.out().contains("\n  scanline "), ran.out());
        assertTrue(ran.out().contains("model solution: accuracy 75, stability 15, speed –"));
        String table = ran.out().substring(ran.out().indexOf("\nExercise ") + 1);
        assertTrue(
                table.matches(
                        "(?s).*\nbreak-polygon-fill +(\\d+) +\\1 +\\1 +–\n"
                                + "polygon-fill +(\\d+) +\\2 +\\2 +–\n.*"),
                table);
        assertTrue(ran.out().endsWith("2 of 2 exercises are proved\n"), ran.out());
        assertEquals(2, ran.err().lines().filter(one -> one.startsWith("proving ")).count());
    }

    @Test
    void theCommandThatNewPrintsTakesAFolderWithSpaces() {
        Path made = folder.resolve("my course's").resolve("my-line");
        String told = Ran.lab("exercises", "new", "line", made + "").out();
        assertTrue(told.endsWith(" --exercises '" + folder + "/my course'\\''s'\n"), told);
    }

    @ParameterizedTest(name = "./lab exercises {0} is not refused in one line")
    @CsvSource({
        "new cube DIR/my-cube, no exercise of topic 'cube'",
        "new circle DIR/My_Circle, lower-case words",
        "new circle DIR, ",
        "validate DIR/none, no such folder",
        "prove square, no exercise 'square'",
        "list --exercises DIR/none, no such folder",
        "prove --seed x, 'x'",
    })
    void isRefused(String arguments, String told) {
        String[] words = ("exercises " + arguments.replace("DIR", folder + "")).split(" ");
        Ran ran = Ran.lab(words);
        assertEquals(2, ran.exitCode(), ran.err());
        assertEquals("", ran.out());
        assertEquals(1, ran.err().lines().count(), ran.err());
        if (told != null) assertTrue(ran.err().contains(told), ran.err());
    }

    @Test
    void whatTakesTheBuiltInOnesPlaceIsNamed() throws IOException {
        made("circle", "circle");
        made("circle", "my-circle");
        String note =
                "note: exercise circle of " + folder + " takes the place of the built-in one\n";
        assertEquals(note, Ran.lab("exercises", "list", "--exercises", folder + "").err());
        assertEquals(note, Ran.lab("exercises", "validate", folder + "").err());
    }

    @Test
    void aFolderThatCannotBeReadIsNamed() throws IOException {
        Path made = made("circle", "my-circle");
        Files.writeString(made.resolve("cases.json"), "[");
        for (List<String> words :
                List.of(
                        List.of("exercises", "list"),
                        List.of("exercises", "prove"),
                        List.of("check", "line-bresenham", "None.java"))) {
            Ran ran =
                    Ran.lab(
                            Stream.concat(words.stream(), Stream.of("--exercises", folder + ""))
                                    .toArray(String[]::new));
            assertEquals(2, ran.exitCode(), ran.err());
            assertTrue(ran.err().contains("my-circle/cases.json is not JSON"), ran.err());
        }
    }
}
