package rasterlab.exercises.folder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.exercises.score.Phrase;

/** All that is wrong in an exercise's folder is told at once, with file, place and reason. */
class FolderCheckTest {
    @TempDir Path parent;
    private Path folder;

    @BeforeEach
    void begin() throws IOException {
        folder = Files.createDirectory(parent.resolve("my-polygon"));
        for (Map.Entry<String, String> file : NewFolder.files("point-in-polygon").entrySet())
            Files.writeString(folder.resolve(file.getKey()), file.getValue());
    }

    private void change(String file, String from, String to) throws IOException {
        String text = Files.readString(folder.resolve(file));
        assertTrue(text.contains(from), text);
        Files.writeString(folder.resolve(file), text.replace(from, to));
    }

    private List<String> faults() {
        return FolderCheck.faults(folder).stream().map(one -> one.in("en")).toList();
    }

    @ParameterizedTest(name = "{2} is not told")
    @CsvSource(
            delimiter = '|',
            value = {
                "exercise.json | \"accuracy\" : 75 | \"accuracy\" : 74 | must add up to 100",
                "exercise.json | \"accuracy\" : 75 | \"accuracy\" : -5 | field 'accuracy' must be a whole number",
                "exercise.json | \"topic\" : \"point-in-polygon\" | \"topic\" : \"points\" | field 'topic'",
                "exercise.json | \"ru\" : \"Точка в многоугольнике\" | \"de\" : \"TITEL\" | field 'title'",
                "exercise.json | \"Point in a polygon\" | \"TITLE\" | field 'title.en' is still the placeholder 'TITLE'",
                "exercise.json | \"Точка в многоугольнике\" | \"НАЗВАНИЕ\" | field 'title.ru' is still the placeholder 'НАЗВАНИЕ'",
                "statement.ru.md | # Точка в многоугольнике | # НАЗВАНИЕ | statement.ru.md: the heading is still the placeholder 'НАЗВАНИЕ'",
                "exercise.json | \"tolerance\" : { } | \"tolerance\" : {\"worst\": 1} | field 'unit' is missing",
                "exercise.json | \"tolerance\" | \"caps\" : {\"bytes\": 1}, \"tolerance\" | field 'caps.bytes'",
                "exercise.json | \"count\" : 20 | \"count\" : 0 | count",
                "exercise.json | \"Model.java\" | \"None.java\" | None.java",
                "exercise.json | \"tolerance\" | \"tolerances\" | field 'tolerances'",
                "exercise.json | { | [ | is not JSON",
                "hidden-cases.json | \"points\" : 37 | \"points\" : 36 | accuracy cases have 74",
                "hidden-cases.json | \"points\" : 37 | \"points\" : 1.5 | 'points'",
                "cases.json | ray-through-a-corner | last-edge | two cases are called 'last-edge'",
                "cases.json | \"hazard\" : \"last-edge\" | \"hazard\" : \"none\" | hazard",
                "cases.json | \"kind\" : \"accuracy\" | \"kind\" : \"speed\" | 'kind'",
                "hidden-cases.json | \"group\" : \"ordinary\" | \"group\" : \"other\" | 'group'",
                "statement.en.md | $x^2 + y^2 = r^2$ | $\\unheard{x}$ | statement.en.md: formula",
                "Starter.java | return false | return 0 | Starter.java:7",
                "Starter.java | public class | class | Starter.java",
                "Model.java | return false | return new java.io.File(\"x\").exists() | Model.java:7"
            })
    void oneFaultIsTold(String file, String from, String to, String told) throws IOException {
        change(file, from, to);
        List<String> faults = faults();
        assertTrue(faults.stream().anyMatch(one -> one.contains(told)), faults.toString());
        assertTrue(faults.stream().allMatch(one -> one.contains("my-polygon")), faults.toString());
    }

    @Test
    @DisplayName("a picture that neither statement can show is told for one of them only")
    void aMissingPictureIsToldForEachStatement() throws IOException {
        for (String language : List.of("en", "ru"))
            Files.writeString(
                    folder.resolve("statement." + language + ".md"), "\n![window](none.svg)\n");
        List<String> faults = faults();
        assertEquals(2, faults.size(), faults.toString());
        for (String language : List.of("en", "ru"))
            assertTrue(
                    faults.stream().anyMatch(one -> one.contains("statement." + language + ".md")),
                    faults.toString());
    }

    @ParameterizedTest(name = "that {0} is missing is not told")
    @CsvSource({
        "exercise.json",
        "cases.json",
        "statement.en.md",
        "statement.ru.md",
        "hints.en.md",
        "hints.ru.md",
        "Starter.java",
        "Model.java"
    })
    void aMissingFileIsTold(String file) throws IOException {
        Files.delete(folder.resolve(file));
        List<String> faults = faults();
        assertEquals(1, faults.size(), faults.toString());
        assertTrue(faults.get(0).contains(file), faults.toString());
    }

    @ParameterizedTest(name = "an input that no report can show is taken: {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "line-plane | parallel | a plane is told by a point of it, not by c | плоскость передаётся точкой на ней",
                "spline-function | overshoot | that the shape counts is not told | то, что важна форма, не передаётся",
                "texture-filter | hair | a picture is told in greys, got 0 | изображение передаётся в серых тонах"
            })
    void anUntoldHazardIsTold(String topic, String hazard, String why, String russian)
            throws IOException {
        folder = Files.createDirectory(parent.resolve("untold"));
        for (Map.Entry<String, String> file : NewFolder.files(topic).entrySet())
            Files.writeString(folder.resolve(file.getKey()), file.getValue());
        String cases = Files.readString(folder.resolve("cases.json"));
        Files.writeString(
                folder.resolve("cases.json"),
                cases.replaceFirst(
                        "(?s)\"input\" : \\{.*?}",
                        "\"input\" : {\"hazard\" : \"" + hazard + "\"}"));
        List<Phrase> faults = FolderCheck.faults(folder);
        assertEquals(1, faults.size(), faults.toString());
        String said = faults.get(0).in("en");
        String place = "field 'hazard' must be a hazard that a report can show, got '" + hazard;
        assertTrue(said.contains("cases.json") && said.contains(place), said);
        assertTrue(said.endsWith(why), said);
        assertTrue(faults.get(0).in("ru").contains(russian), faults.get(0).in("ru"));
    }

    @ParameterizedTest(name = "a statement that says nothing is taken: [{0}]")
    @ValueSource(strings = {"", " \n\n", "# НАЗВАНИЕ\n"})
    void aStatementWithoutWordsIsAFault(String text) throws IOException {
        Files.writeString(folder.resolve("statement.ru.md"), text);
        assertEquals(
                List.of(
                        folder.resolve("statement.ru.md")
                                + ": has no words; it must say what is asked"),
                faults());
    }

    @Test
    @DisplayName("only the first of several faults is told")
    void allFaultsAreToldAtOnce() throws IOException {
        change("exercise.json", "\"accuracy\" : 75", "\"accuracy\" : 74");
        change("exercise.json", "\"Точка в многоугольнике\"", "\"\"");
        change("cases.json", "\"hazard\" : \"last-edge\"", "\"hazard\" : \"none\"");
        change("exercise.json", "\"tolerance\"", "\"colour\" : 1, \"size\" : 2, \"tolerance\"");
        change("hidden-cases.json", "\"points\" : 37", "\"shade\" : 3, \"points\" : 1.5");
        Files.delete(folder.resolve("statement.ru.md"));
        Files.delete(folder.resolve("Starter.java"));
        List<String> faults = faults();
        for (String unknown : List.of("'colour'", "'size'", "'shade'"))
            assertTrue(faults.stream().anyMatch(one -> one.contains(unknown)), unknown);
        assertEquals(9, faults.size(), faults.toString());
    }

    @Test
    @DisplayName("an unknown field within an object hides what else is wrong there")
    void allFaultsOfAnObjectAreToldAtOnce() throws IOException {
        change("exercise.json", "\"accuracy\" : 75", "\"depth\" : 1, \"accuracy\" : -75");
        change("exercise.json", "\"speed\" : 10", "\"colour\" : 2, \"speed\" : 1000");
        change("exercise.json", "\"ru\" : \"Точка в многоугольнике\"", "\"de\" : \"TITEL\"");
        change("exercise.json", "\"count\" : 20", "\"counts\" : 3, \"count\" : 0");
        change("cases.json", "\"hazard\" : \"last-edge\"", "\"hazards\" : 1, \"hazard\" : \"x\"");
        change("hidden-cases.json", "\"group\" : \"ordinary\"", "\"group\" : \"other\"");
        change(
                "hidden-cases.json",
                "\"visibility\" : \"after-deadline\"",
                "\"visibility\" : \"seldom\"");
        List<String> faults = faults();
        for (String told :
                List.of(
                        "'depth' is not",
                        "'accuracy' must be",
                        "'colour' is not",
                        "'speed' must be",
                        "'de' is not",
                        "'title', field 'ru' is missing",
                        "'counts' is not",
                        "'hazards' is not",
                        "'hazard' must be",
                        "'group' must be",
                        "'visibility' must be"))
            assertTrue(faults.stream().anyMatch(one -> one.contains(told)), told + " " + faults);
    }

    @Test
    @DisplayName("nobody is told that no speed can be measured")
    void inputsThatAreTooLargeToBeTimedAreTold() throws IOException {
        String points = "[0.5, 0.5], ".repeat(19_000) + "[0.25, 0.25]";
        String file = "exercise.json";
        JsonNode all = new JsonMapper().readTree(Files.readString(folder.resolve(file)));
        ((ObjectNode) all.get("timed").get("given"))
                .set("points", new JsonMapper().readTree("[" + points + "]"));
        Files.writeString(folder.resolve(file), all.toString());
        List<String> faults = faults();
        assertEquals(1, faults.size(), faults.toString());
        String told = folder.resolve(file) + ", field 'timed': the inputs that are timed at once";
        assertTrue(faults.get(0).startsWith(told), faults.toString());
    }

    @Test
    void theSourcesOfAReadableFolderAreBothLookedAt() throws IOException {
        change("Starter.java", "return false", "return");
        change("Model.java", "return false", "return");
        change("statement.ru.md", "$x^2 + y^2 = r^2$", "$\\nothing$");
        List<String> faults = faults();
        assertEquals(3, faults.size(), faults.toString());
    }

    @ParameterizedTest(name = "{2} hides what is wrong in the other files")
    @CsvSource(
            delimiter = '|',
            value = {
                "cases.json | \"hazard\" : \"last-edge\" | \"hazard\" : \"none\"",
                "exercise.json | \"topic\" : \"point-in-polygon\" | \"topic\" : \"points\"",
                "exercise.json | { | ["
            })
    void theFilesAreLookedAtWhereTheExerciseCannotBeRead(String file, String from, String to)
            throws IOException {
        change(file, from, to);
        int before = faults().size();
        change("statement.ru.md", "$x^2 + y^2 = r^2$", "$\\foo{$ ![](none.png) ![](no.svg)");
        change("hints.en.md", "The idea", "$\\bar$");
        change("Starter.java", "return false", "return");
        Files.writeString(folder.resolve("Model.java"), "public class Model {");
        List<String> faults = faults();
        for (String told :
                List.of(
                        "statement.ru.md: formula",
                        "none.png",
                        "no.svg",
                        "hints.en.md: formula",
                        "Model.java:1"))
            assertTrue(faults.stream().anyMatch(one -> one.contains(told)), told + " " + faults);
        assertTrue(faults.size() >= before + 5, faults.toString());
    }

    @Test
    @DisplayName("only the first of several wrong limits is told")
    void allWrongLimitsAreTold() throws IOException {
        String caps = "\"caps\" : {\"items\": 0, \"bytes\": -3, \"seconds\": 99}, ";
        change("exercise.json", "\"tolerance\"", caps + "\"tolerance\"");
        List<String> faults = faults();
        assertEquals(3, faults.size(), faults.toString());
        for (String told : List.of("'items'", "'bytes'", "'seconds'"))
            assertTrue(faults.stream().anyMatch(one -> one.contains(told)), told + " " + faults);
    }

    @Test
    void aPictureOfAnInputThatCannotBeReadIsTold() throws IOException {
        Files.writeString(folder.resolve("example.json"), "{\"given\": {\"polygon\": 7}}");
        Files.writeString(
                folder.resolve("statement.en.md"), "# Title\n\n![an example](example.png)\n");
        List<String> faults = faults();
        assertEquals(1, faults.size(), faults.toString());
        assertTrue(faults.get(0).contains("example.json"), faults.toString());
    }

    @Test
    @DisplayName("a fault is told in English in Russian")
    void faultsAreToldInRussian() throws IOException {
        change("exercise.json", "\"accuracy\" : 75", "\"accuracy\" : 74");
        String said = FolderCheck.faults(folder).get(0).in("ru");
        assertTrue(said.contains("в сумме"), said);
    }

    @Test
    void aMissingFolderIsTold() {
        assertEquals(
                List.of(parent.resolve("none") + ": no such folder"),
                FolderCheck.faults(parent.resolve("none")).stream()
                        .map(one -> one.in("en"))
                        .toList());
    }
}
