package rasterlab.exercises.folder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.exercises.catalogue.Catalogue;

/** All faults in the rules of an exercise are told at once. */
class PredictFaultsTest {
    @TempDir Path parent;

    private List<String> faults(String id, Map<String, String> changes) throws IOException {
        Path folder = Files.createDirectory(parent.resolve(id));
        for (var file : Catalogue.builtIn().files(id).entrySet())
            Files.write(folder.resolve(file.getKey()), file.getValue());
        Path json = folder.resolve("exercise.json");
        String text = Files.readString(json, StandardCharsets.UTF_8);
        for (var change : changes.entrySet()) {
            assertTrue(text.contains(change.getKey()), change.getKey() + " in " + text);
            text = text.replace(change.getKey(), change.getValue());
        }
        Files.writeString(json, text);
        return FolderCheck.faults(folder).stream().map(one -> one.in("en")).toList();
    }

    @Test
    @DisplayName("only the first of several faults of 'predict' is told")
    void allFaultsOfTheRulesAreToldAtOnce() throws IOException {
        List<String> faults =
                faults(
                        "predict-rotate-axis",
                        Map.of(
                                "\"method\": \"seven-steps\"", "\"method\": \"eight-steps\"",
                                "\"steps\": 14", "\"steps\": 9",
                                "\"least\": 7", "\"least\": 0",
                                "\"tolerance\": 0.01", "\"tolerance\": -1",
                                "\"step\": \"same\"", "\"step\": \"after\"",
                                "\"told\": [\"step\"]", "\"told\": 3"));
        for (String place :
                List.of("'method'", "'steps'", "'least'", "'tolerance'", "'step'", "'told'"))
            assertEquals(
                    1,
                    faults.stream().filter(one -> one.contains(place + " ")).count(),
                    place + " in " + faults);
        assertEquals(6, faults.size(), faults.toString());
    }

    @Test
    @DisplayName("only the first of several fields that the steps have not is told")
    void allFieldsThatTheStepsHaveNotAreTold() throws IOException {
        List<String> faults =
                faults(
                        "predict-rotate-axis",
                        Map.of(
                                "\"told\": [\"step\"]", "\"told\": [\"stop\"]",
                                "\"field\": \"step\"", "\"field\": \"stap\""));
        assertEquals(2, faults.size(), faults.toString());
        assertTrue(faults.get(0).contains("'told'"), faults.toString());
        assertTrue(faults.get(1).contains("'reason'"), faults.toString());
    }

    @Test
    @DisplayName("only the first of several unknown mistakes of 'notAsked' is told")
    void allUnknownMistakesAreTold() throws IOException {
        List<String> faults =
                faults(
                        "circle",
                        Map.of("\"notAsked\": [\"", "\"notAsked\": [\"no-one\", \"nor-this\", \""));
        assertEquals(2, faults.size(), faults.toString());
        assertTrue(faults.get(0).endsWith("got 'no-one'"), faults.toString());
        assertTrue(faults.get(1).endsWith("got 'nor-this'"), faults.toString());
    }
}
