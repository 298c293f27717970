package rasterlab.exercises.folder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Form;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.topic.TopicGradings;

/** The folder that an exercise begins with is one that the server takes, whatever the topic. */
class NewFolderTest {
    @TempDir Path parent;

    static List<String> topics() {
        return TopicGradings.names().stream().filter(topic -> !topic.equals("line")).toList();
    }

    @ParameterizedTest(name = "a new folder of topic {0} is not valid")
    @MethodSource("topics")
    void aNewFolderIsValid(String topic) throws IOException {
        assertEquals(List.of(), FolderCheck.faults(folder(topic)));
    }

    @ParameterizedTest(name = "a case of a new folder of topic {0} has an answer too long to prove")
    @MethodSource("topics")
    void noCaseHasAnAnswerThatIsTooLongToProve(String topic) throws IOException {
        Exercise made = made(topic);
        assertFalse(made.cases().isEmpty());
        for (Exercise.Case one : made.cases())
            for (TopicGrading.Call call : TopicGradings.of(made).calls(one, made.tolerance(), 1))
                assertTrue(call.items() <= 20_000, one.name() + ": " + call.items());
    }

    @Test
    void aMistakeThatOnlyALongAnswerShowsIsNotAsked() throws IOException {
        assertEquals(Set.of("squares-in-int"), made("circle").evidence().notAsked());
        assertEquals(Set.of(), made("view").evidence().notAsked());
    }

    private Exercise made(String topic) throws IOException {
        return Catalogue.read(folder(topic)).exercise().orElseThrow();
    }

    private Path folder(String topic) throws IOException {
        Path folder = Files.createDirectory(parent.resolve("new-" + topic));
        for (Map.Entry<String, String> file : NewFolder.files(topic).entrySet())
            Files.writeString(folder.resolve(file.getKey()), file.getValue());
        return folder;
    }

    static List<String> predicted() {
        return CopiedFolder.topics(Form.PREDICT);
    }

    @ParameterizedTest(name = "a new folder that asks for steps of {0} is not valid")
    @MethodSource("predicted")
    void aNewFolderThatAsksForStepsIsValid(String topic) throws IOException {
        Path folder = Files.createDirectory(parent.resolve("new-one"));
        var files = CopiedFolder.files(topic, Form.PREDICT, "new-one").orElseThrow();
        for (Map.Entry<String, byte[]> file : files.entrySet())
            Files.write(folder.resolve(file.getKey()), file.getValue());
        assertEquals(List.of(), FolderCheck.faults(folder));
    }
}
