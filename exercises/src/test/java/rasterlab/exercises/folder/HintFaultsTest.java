package rasterlab.exercises.folder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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

/** All faults of hints are told at once, with file, place and reason. */
class HintFaultsTest {
    private static final String COSTS = "\"hintCosts\" : [ 1, 2, 4 ]";

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

    private List<String> faults(String language) {
        return FolderCheck.faults(folder).stream().map(one -> one.in(language)).toList();
    }

    @ParameterizedTest(name = "in {0}, {2} is not told")
    @CsvSource(
            delimiter = '|',
            value = {
                "hints.ru.md | ## 3 | ### 3 | hints.ru.md: must have three steps, under the headings '## 1', '## 2' and '## 3' in this order; it has ## 1, ## 2",
                "hints.en.md | ## 2 | ## 3 | hints.en.md: must have three steps",
                "hints.en.md | ## | #### | hints.en.md: has no hint",
                "hints.en.md | The idea … | '' | hints.en.md: step 1 is empty",
                "hints.en.md | ## 1 | 'Read this. ## 1' | hints.en.md: must have three steps",
                "hints.en.md | The idea | ![idea](idea.png) | hints.en.md: step 1 shows a picture",
                "hints.ru.md | Идея | $\\nothing$ | hints.ru.md: formula"
            })
    void wrongTextsAreTold(String file, String from, String to, String told) throws IOException {
        change(file, from, to);
        assertMessage(told);
    }

    @ParameterizedTest(name = "that costs are {0} is not told")
    @CsvSource(
            delimiter = '|',
            value = {
                "[1, -2, 4] | field 'hintCosts[1]' must be a whole number from 0 to 99, got -2",
                "[1, 2, 100] | field 'hintCosts[2]' must be a whole number from 0 to 99, got 100",
                "[60, 60, \"a\"] | field 'hintCosts[2]' must be a whole number from 0 to 99, got \"a\"",
                "[1, 2.5, 4] | field 'hintCosts[1]' must be a whole number",
                "[20, 30, 50] | field 'hintCosts' comes to 100 points together, which must be less than the 100 points",
                "[1, 2] | field 'hintCosts' must have 3 whole numbers",
                "7 | field 'hintCosts' must have 3 whole numbers"
            })
    void wrongCostsAreTold(String costs, String told) throws IOException {
        change("exercise.json", COSTS, "\"hintCosts\" : " + costs);
        assertMessage(told);
    }

    private void assertMessage(String told) {
        List<String> faults = faults("en");
        assertEquals(1, faults.size(), faults.toString());
        assertTrue(faults.get(0).contains("my-polygon"), faults.toString());
        assertTrue(faults.get(0).contains(told), faults.toString());
    }

    @Test
    void whatNoStepShowsIsTold() throws IOException {
        change("hints.ru.md", "## 1\n", "# Подсказки\n\nСначала подумайте.\n\n## 1\n");
        assertMessage("hints.ru.md: only a title '# …' may stand above '## 1'");
        change("hints.ru.md", "Сначала подумайте.", "");
        assertEquals(List.of(), faults("en"));
    }

    @Test
    void aStepOfAThousandCharactersIsTheLongest() throws IOException {
        change("hints.en.md", "The idea …", "x".repeat(1000));
        assertEquals(List.of(), faults("en"));
        change("hints.en.md", "xx", "xxx");
        assertMessage("hints.en.md: step 1 has 1500 characters, at most 1000 are allowed");
    }

    @Test
    @DisplayName("only the first of several faults is told")
    void allFaultsAreToldAtOnce() throws IOException {
        change("exercise.json", COSTS, "\"hintCosts\" : [1, -2, 4]");
        change("hints.en.md", "The idea …", "");
        change("hints.en.md", "Where", "![](a.png)");
        Files.delete(folder.resolve("hints.ru.md"));
        List<String> faults = faults("ru");
        assertEquals(4, faults.size(), faults.toString());
        assertTrue(faults.stream().anyMatch(one -> one.contains("шаг 1 пуст")), faults.toString());
    }

    @Test
    @DisplayName("hints of the kinds 'break' and 'predict' are not looked at")
    void hintsOfOtherKindsAreLookedAt() throws IOException {
        for (String kind : List.of("break-circle", "predict-circle")) {
            Path other = Files.createDirectory(parent.resolve(kind));
            for (String file : files(kind))
                try (var in = getClass().getResourceAsStream("../" + kind + "/" + file)) {
                    Files.copy(in, other.resolve(file));
                }
            assertEquals(List.of(), FolderCheck.faults(other));
            Files.writeString(other.resolve("hints.en.md"), "## 1\n\nLook.\n");
            List<String> faults =
                    FolderCheck.faults(other).stream().map(one -> one.in("en")).toList();
            assertEquals(2, faults.size(), faults.toString());
        }
    }

    private static List<String> files(String kind) {
        return kind.startsWith("break")
                ? List.of("exercise.json", "statement.en.md", "statement.ru.md", "Starter.json")
                : List.of("exercise.json", "statement.en.md", "statement.ru.md");
    }

    @Test
    void anExerciseNeedsNoHints() throws IOException {
        Files.delete(folder.resolve("hints.en.md"));
        Files.delete(folder.resolve("hints.ru.md"));
        assertEquals(2, faults("en").size());
        change("exercise.json", COSTS + ",", "");
        assertEquals(List.of(), faults("en"));
    }
}
