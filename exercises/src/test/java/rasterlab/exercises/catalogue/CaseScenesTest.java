package rasterlab.exercises.catalogue;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;

/** A file that a search for hazards wrote is a case of an instructor's exercise. */
class CaseScenesTest {
    private static final String INPUT = "{\"from\":[0,0],\"to\":[7,3]}";
    private static final String SCENE =
            """
            {"version":1,"topic":"line","method":"naive-textbook","input":%s,
             "found":{"verdict":"wrong","seed":5}}"""
                    .formatted(INPUT);

    @TempDir Path folder;
    private Path mine;

    @BeforeEach
    void copyTheBuiltInExercise() throws IOException {
        mine = Files.createDirectory(folder.resolve("my-line"));
        for (Map.Entry<String, byte[]> file :
                Catalogue.builtIn().files("line-bresenham").entrySet())
            Files.write(mine.resolve(file.getKey()), file.getValue());
        for (String picture : Catalogue.builtIn().named("line-bresenham").pictures().keySet())
            Files.write(
                    mine.resolve(picture),
                    ExerciseFolder.onClassPath("line-bresenham").content(picture));
    }

    private List<String> faults(String visibility, String input, String scene) throws IOException {
        String one =
                "{\"name\": \"found\", \"kind\": \"stability\", \"visibility\": \"%s\","
                        + " \"title\": {\"en\": \"found\", \"ru\": \"найдено\"},"
                        + " \"points\": 0, \"input\": %s},";
        Path cases = mine.resolve("cases.json");
        String text = Files.readString(cases);
        String added = one.formatted(visibility, input);
        Files.writeString(cases, text.replaceFirst("\\[", "[" + added));
        Files.writeString(mine.resolve("found.scene.json"), scene);
        return Catalogue.read(mine).faults().stream().map(CatalogueException::getMessage).toList();
    }

    @ParameterizedTest(name = "{0} case cannot come from a scene file")
    @CsvSource({"open", "verdict-only"})
    void caseHasTheInputOfTheFile(String visibility) throws IOException {
        assertEquals(List.of(), faults(visibility, "{\"scene\": \"found.scene.json\"}", SCENE));
        Exercise read = Catalogue.builtIn().withFolder(folder).named("my-line");
        Case found =
                read.cases().stream().filter(one -> one.name().equals("found")).findFirst().get();
        assertEquals("{\"given\":" + INPUT + "}", found.input());
    }

    /** The server keeps the files of an exercise and reads it from them again. */
    @Test
    void fileIsKeptWithTheExercise() throws IOException {
        assertEquals(List.of(), faults("open", "{\"scene\": \"found.scene.json\"}", SCENE));
        Catalogue catalogue = Catalogue.builtIn().withFolder(folder);
        Map<String, byte[]> files = catalogue.files("my-line");
        assertTrue(files.containsKey("found.scene.json"), files.keySet()::toString);
        assertEquals(catalogue.named("my-line").cases(), Catalogue.kept("my-line", files).cases());
    }

    @ParameterizedTest(name = "no word of: {2}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "{'scene': 'other.scene.json'} | 'topic':'line' | other.scene.json",
                "{'scene': 'found.scene.json', 'hazard': 'single-pixel'} | 'topic':'line' | must not stand beside 'hazard'",
                "{'scene': 'found.scene.json'} | 'topic':'circle' | must be a scene file of the topic 'line'; 'found.scene.json' is one of 'circle'",
                "{'scene': 'found.scene.json'} | 'topics':'line' | found.scene.json:",
                "{'scene': 'found.scene.json'} | 'topic':'line','drawn':7 | found.scene.json:",
            })
    void mistakeIsTold(String input, String topic, String told) throws IOException {
        String scene = SCENE.replace("\"topic\":\"line\"", topic.replace('\'', '"'));
        List<String> faults = faults("open", input.replace('\'', '"'), scene);
        assertTrue(faults.stream().anyMatch(one -> one.contains(told)), faults::toString);
    }
}
