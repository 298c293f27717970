package rasterlab.exercises.folder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All faults in a folder of the kind 'break' are told at once. */
class BreakFaultsTest {
    @TempDir Path parent;
    private Path folder;

    @BeforeEach
    void copy() throws IOException {
        folder = Files.createDirectory(parent.resolve("break-circle"));
        for (String file :
                List.of("exercise.json", "statement.en.md", "statement.ru.md", "Starter.json"))
            try (var in = getClass().getResourceAsStream("../break-circle/" + file)) {
                Files.copy(in, folder.resolve(file));
            }
    }

    private void change(String from, String to) throws IOException {
        Path file = folder.resolve("exercise.json");
        String text = Files.readString(file);
        assertTrue(text.contains(from), text);
        Files.writeString(file, text.replaceFirst(from, to));
    }

    private List<String> faults() {
        return FolderCheck.faults(folder).stream().map(one -> one.in("en")).toList();
    }

    @Test
    void rightFolderHasNone() {
        assertEquals(List.of(), faults());
    }

    @Test
    @DisplayName("only the first of several faults of a folder of the kind 'break' is told")
    void allFaultsAreToldAtOnce() throws IOException {
        change("\"minutes\": 20", "\"minutes\": 0, \"cases\": []");
        change("\"ru\"", "\"de\"");
        change("\"inputs\": 5", "\"inputs\": 0");
        change("\"small\": 100", "\"small\": 0");
        change("\"axes-twice\"", "\"axes-thrice\"");
        change("\"name\": \"diagonals-left-out\"", "\"name\": \"bresenham-textbook\"");
        Files.delete(folder.resolve("statement.en.md"));
        Files.delete(folder.resolve("statement.ru.md"));
        Files.delete(folder.resolve("Starter.json"));
        List<String> faults = faults();
        for (String place :
                List.of(
                        "'cases'",
                        "'minutes'",
                        "'de' is not known",
                        "'ru' is missing",
                        "'inputs'",
                        "'small'",
                        "'targets[1]'",
                        "'targets[7]'",
                        "statement.en.md",
                        "statement.ru.md",
                        "Starter.json"))
            assertEquals(
                    1,
                    faults.stream().filter(one -> one.contains(place)).count(),
                    place + " in " + faults);
        assertEquals(11, faults.size(), faults.toString());
    }

    @Test
    @DisplayName("points that do not make up the whole are not told, or are told of targets unread")
    void sumIsAskedOfTargetsThatCanBeRead() throws IOException {
        change(
                "\"diagonals-twice\",\n        \"points\": 11",
                "\"diagonals-twice\",\n        \"points\": 12");
        assertEquals(1, faults().size(), faults().toString());
        assertTrue(faults().get(0).contains("'targets' have 91 points"), faults().toString());
        change("\"axes-twice\"", "\"axes-thrice\"");
        assertEquals(1, faults().size(), faults().toString());
        assertTrue(faults().get(0).contains("'targets[1]'"), faults().toString());
    }
}
