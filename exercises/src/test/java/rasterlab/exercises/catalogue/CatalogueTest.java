package rasterlab.exercises.catalogue;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.StatedLimits;
import rasterlab.exercises.Grading;
import rasterlab.exercises.StatementPicture;

/** An instructor's folder is read, or its mistake is named with file and field. */
class CatalogueTest {
    private static final List<String> FILES =
            List.of(
                    "exercise.json",
                    "cases.json",
                    "hidden-cases.json",
                    "Starter.java",
                    "statement.en.md",
                    "statement.ru.md",
                    "segment.svg",
                    "hints.en.md",
                    "hints.ru.md");

    /** Two words that are no names. */
    private static final Pattern ENGLISH = Pattern.compile("[a-z]{2,} [a-z]{2,}");

    @TempDir Path folder;
    private Path mine;

    @BeforeEach
    void copyTheBuiltInExercise() throws IOException {
        mine = Files.createDirectory(folder.resolve("my-line"));
        for (String file : FILES)
            try (InputStream in = Exercise.class.getResourceAsStream("line-bresenham/" + file)) {
                Files.copy(in, mine.resolve(file));
            }
    }

    /**
     * Exercises that come with the program are read without this check, which draws every input.
     */
    @Test
    void builtInExercisesHaveNoFaultOfInstructorsFolders() {
        for (String id : Catalogue.builtIn().ids())
            assertEquals(List.of(), Catalogue.read(sources(id)).faults(), id);
    }

    private static Path sources(String id) {
        return Path.of("src/main/resources/rasterlab/exercises", id);
    }

    @Test
    void aFolderIsAddedWithoutCompiling() {
        Catalogue catalogue = Catalogue.builtIn().withFolder(folder);
        assertEquals(
                Stream.concat(builtIn().stream(), Stream.of("my-line")).toList(), catalogue.ids());
        // It stands with its topic.
        assertEquals("my-line", catalogue.all().get(2).id());
        Exercise exercise = catalogue.named("my-line");
        assertEquals(100, exercise.points().total());
        assertTrue(exercise.statement("ru").contains("Брезенхем"), exercise.statement("ru"));
        assertEquals(exercise.statement("en"), exercise.statement("de"));
    }

    @Test
    void exercisesComeByTopicAsTheCourseDoesAndWhatIsWrittenFirst() {
        List<Exercise> all = Catalogue.builtIn().withFolder(folder).all();
        assertEquals("line-bresenham", all.get(0).id());
        List<String> course = Topics.names();
        assertTrue(course.indexOf("view") < course.indexOf("color"), course.toString());
        for (int i = 1; i < all.size(); i++) {
            Exercise before = all.get(i - 1);
            Exercise one = all.get(i);
            int topics = course.indexOf(one.topic()) - course.indexOf(before.topic());
            boolean late = one.form() == Exercise.TaskKind.WRITE && before.form() != one.form();
            assertTrue(
                    topics > 0 || topics == 0 && !late, () -> one.id() + " after " + before.id());
        }
    }

    /** A folder of an exercise is whole by itself, so each has the picture; it is one picture. */
    @Test
    void bothExercisesOnLightShowTheSameDirections() {
        assertArrayEquals(directions("shade"), directions("shade-face"));
    }

    private static byte[] directions(String id) {
        return ExerciseFolder.onClassPath(id).content("directions.svg");
    }

    @ParameterizedTest
    @CsvSource({"0", "481", "\"long\""})
    void minutesAreAWholeNumberOfAWorkingDay(String minutes) throws IOException {
        assertEquals(OptionalInt.of(60), Catalogue.builtIn().named("line-bresenham").minutes());
        Path file = folder.resolve("my-line/exercise.json");
        String text = Files.readString(file);
        Files.writeString(file, text.replace("\"minutes\": 60", "\"minutes\": " + minutes));
        CatalogueException wrong =
                assertThrows(
                        CatalogueException.class, () -> Catalogue.builtIn().withFolder(folder));
        assertTrue(wrong.getMessage().contains("minutes"), wrong.getMessage());
    }

    @Test
    void anExerciseStatesLimitsOfACallOrHasTheUsualOnes() throws IOException {
        assertEquals(StatedLimits.NONE, Catalogue.builtIn().named("line-bresenham").caps());
        change(
                "exercise.json",
                "\"points\"",
                "\"caps\": {\"items\": 30000, \"bytes\": 500000, \"seconds\": 0.25}, \"points\"");
        assertEquals(
                new StatedLimits(
                        OptionalInt.of(30_000),
                        OptionalInt.of(500_000),
                        Optional.of(Duration.ofMillis(250))),
                Catalogue.builtIn().withFolder(folder).named("my-line").caps());
    }

    @Test
    void picturesAreReadWithTheStatementAndChangeNoGrade() throws IOException {
        Exercise before = Catalogue.builtIn().withFolder(folder).named("my-line");
        assertEquals(Set.of("segment.svg"), before.pictures().keySet());
        assertEquals(
                StatementPicture.PictureFormat.SVG, before.pictures().get("segment.svg").form());
        change("segment.svg", "#d55e00", "#0072b2");
        Exercise after = Catalogue.builtIn().withFolder(folder).named("my-line");
        assertEquals(before.revision(), after.revision());
        assertFalse(
                Arrays.equals(
                        before.pictures().get("segment.svg").content("en"),
                        after.pictures().get("segment.svg").content("en")));
    }

    @Test
    void aPictureIsDrawnFromAnInputOfTheFolder() throws IOException {
        Path input = mine.resolve("window.json");
        Files.writeString(input, "{\"given\": {\"from\": [0, 0], \"to\": [5, 3]}}");
        change("statement.en.md", "segment.svg", "window.png");
        Exercise before = Catalogue.builtIn().withFolder(folder).named("my-line");
        StatementPicture drawn = before.pictures().get("window.png");
        assertEquals(StatementPicture.PictureFormat.PNG, drawn.form());
        assertTrue(drawn.content("en").length > 100, "a picture of a segment");
        Exercise kept =
                Catalogue.kept("my-line", Catalogue.builtIn().withFolder(folder).files("my-line"));
        assertArrayEquals(drawn.content("en"), kept.pictures().get("window.png").content("en"));
        Files.writeString(input, "{\"given\": {\"from\": [0, 0], \"to\": [9, 1]}}");
        Exercise after = Catalogue.builtIn().withFolder(folder).named("my-line");
        assertEquals(before.revision(), after.revision());
        assertFalse(
                Arrays.equals(
                        drawn.content("en"), after.pictures().get("window.png").content("en")));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"given\": {\"from\": [0, 0]}} | window.json",
                "{\"hazard\": \"none\"} | must be one of",
                "[] | window.json"
            })
    void anInputThatTellsOfNoPictureIsNamed(String input, String told) throws IOException {
        Files.writeString(mine.resolve("window.json"), input);
        change("statement.ru.md", "segment.svg", "window.png");
        CatalogueException refused =
                assertThrows(
                        CatalogueException.class, () -> Catalogue.builtIn().withFolder(folder));
        String message = refused.getMessage();
        assertTrue(message.contains("statement.ru.md") && message.contains(told), message);
    }

    @Test
    void theRevisionChangesWithAnyFile() throws IOException {
        String before = Catalogue.builtIn().withFolder(folder).named("my-line").revision();
        assertEquals(Catalogue.builtIn().named("line-bresenham").revision(), before);
        change("Starter.java", "So far", "As yet");
        assertNotEquals(before, Catalogue.builtIn().withFolder(folder).named("my-line").revision());
    }

    @Test
    void everyCaseHasATitleOfItsOwnInBothLanguages() {
        for (Exercise exercise : Catalogue.builtIn().all())
            for (String language : List.of("en", "ru")) {
                Set<String> titles = new HashSet<>();
                for (Case one : exercise.cases()) {
                    assertTrue(one.title().containsKey(language), one.name() + " in " + language);
                    assertTrue(titles.add(one.title(language)), one.title(language));
                }
            }
        assertTrue(
                Catalogue.builtIn().named("line-bresenham").cases().stream()
                        .allMatch(one -> one.title("ru").matches(".*[а-яё]{3}.*")));
    }

    @Test
    void casesWithoutTitlesAreReadAndCalledByTheirNames() throws IOException {
        for (String file : List.of("cases.json", "hidden-cases.json")) {
            Path path = mine.resolve(file);
            String text = Files.readString(path, StandardCharsets.UTF_8);
            Files.writeString(path, text.replaceAll("\"title\": \\{[^}]*},", ""));
        }
        Exercise old = Catalogue.builtIn().withFolder(folder).named("my-line");
        assertEquals("octant-1", old.caseTitle("octant-1", "ru"));
        for (Case one : old.cases()) assertEquals(one.name(), one.title("ru"));
    }

    @Test
    void whatAReportNamesIsCalledInTheReadersLanguage() {
        Exercise exercise = Catalogue.builtIn().named("line-bresenham");
        assertEquals(
                "пологие отрезки вправо и вниз нарисованы", exercise.caseTitle("octant-1", "ru"));
        assertEquals(
                "gentle lines right and down are drawn",
                exercise.caseTitle("octant-1", "de"),
                "no such language");
        assertEquals("скорость", exercise.caseTitle("speed", "ru"));
        assertEquals("скрытый", exercise.caseTitle("hidden", "ru"));
        assertEquals("case-of-a-server", exercise.caseTitle("case-of-a-server", "ru"));
    }

    @ParameterizedTest(name = "statement promises another longest source than is accepted: {0}")
    @CsvSource({"en, 'at most %d KiB.'", "ru, 'не больше %d\u00a0КиБ.'"})
    void theStatementNamesTheLongestSource(String language, String promise) {
        String statement = Catalogue.builtIn().named("line-bresenham").statement(language);
        String promised = String.format(promise, Grading.MOST_SOURCE_BYTES / 1024);
        assertTrue(statement.contains(promised), () -> promised + " is not in " + statement);
    }

    @Test
    void anUnknownNameListsTheKnown() {
        Exception e =
                assertThrows(
                        IllegalArgumentException.class, () -> Catalogue.builtIn().named("square"));
        assertEquals(
                "no exercise 'square'; there are " + String.join(", ", builtIn()), e.getMessage());
        assertTrue(builtIn().contains("line-bresenham"));
    }

    private static List<String> builtIn() {
        return Catalogue.builtIn().ids();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("rasterlab.exercises.catalogue.FolderMistakes#all")
    void isNamed(String file, String from, String to, String said) throws IOException {
        change(file, from, to);
        var e =
                assertThrows(
                        CatalogueException.class, () -> Catalogue.builtIn().withFolder(folder));
        assertTrue(e.getMessage().contains(said), e::getMessage);
        assertTrue(e.getMessage().contains("my-line"), e::getMessage);
        String russian = e.in("ru").replace(folder.toString(), "");
        assertTrue(russian.matches("(?s).*[а-яё]{3}.*"), russian);
        assertFalse(ENGLISH.matcher(russian).find(), russian);
    }

    private void change(String file, String from, String to) throws IOException {
        Path path = mine.resolve(file);
        String text = Files.readString(path, StandardCharsets.UTF_8);
        int at = text.indexOf(from);
        assertTrue(at >= 0, () -> from + " is not in " + file);
        Files.writeString(path, text.substring(0, at) + to + text.substring(at + from.length()));
    }
}
