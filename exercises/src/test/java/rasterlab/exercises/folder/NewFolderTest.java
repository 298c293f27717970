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
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.Grading;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.proving.Marked;
import rasterlab.exercises.proving.Proof;
import rasterlab.exercises.proving.Proving;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;
import rasterlab.exercises.topic.TopicGradings;

/** The folder that an exercise begins with is one that the server takes, whatever the topic. */
class NewFolderTest {
    private static final long SEED = 20261127;

    @TempDir Path parent;

    static List<String> topics() {
        return TopicGradings.names();
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
            for (TopicGrading.GradedCall call :
                    TopicGradings.of(made).calls(one, made.tolerance(), 1))
                assertTrue(call.items() <= 20_000, one.name() + ": " + call.items());
    }

    @Test
    void aMistakeThatOnlyALongAnswerShowsIsNotAsked() throws IOException {
        assertEquals(Set.of("squares-in-int"), made("circle").evidence().notAsked());
        assertEquals(Set.of(), made("view").evidence().notAsked());
    }

    /** Only the model solution is left to be written. */
    @Tag("slow")
    @ParameterizedTest(name = "something but its model solution speaks against a new folder of {0}")
    @MethodSource("topics")
    void aNewFolderIsProvedButForItsModel(String topic) throws Exception {
        Exercise made = made(topic);
        Grading judge = (exercise, source, cases, progress) -> forNothing(exercise, cases);
        Proof proof = Proving.of(made, SEED, judge);
        List<String> told = proof.faults().stream().map(one -> one.in("en")).toList();
        assertEquals(1, told.size(), told.toString());
        assertTrue(told.get(0).startsWith("the model solution earns 0 of 75"), told.toString());
    }

    /** The report on a source that does nothing, as the new starter and the new model do. */
    private static Report forNothing(Exercise exercise, CaseSelection cases) {
        TopicGrading grading = TopicGradings.of(exercise);
        Object nothing = Nothing.of(grading.contract());
        Marking marking = Marked.cases(exercise, grading, nothing, cases.seed());
        int earned = marking.reports().stream().mapToInt(CaseReport::points).sum();
        assertEquals(0, earned, "points for nothing");
        return new Report(
                GradingVerdict.WRONG,
                new ScorePoints(0, 0, 0, 100),
                marking.reports(),
                List.of(),
                Report.PROCESS_LIMITS,
                0);
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

    static Stream<Arguments> copied() {
        return Stream.of(TaskKind.BREAK, TaskKind.PREDICT)
                .flatMap(
                        form ->
                                CopiedFolder.topics(form).stream()
                                        .map(topic -> Arguments.of(form, topic)));
    }

    @ParameterizedTest(name = "a new folder of the kind {0} on {1} is not valid")
    @MethodSource("copied")
    void aNewFolderThatIsACopyIsValid(TaskKind form, String topic) throws IOException {
        Path folder = Files.createDirectory(parent.resolve("new-one"));
        var files = CopiedFolder.files(topic, form, "new-one").orElseThrow();
        for (Map.Entry<String, byte[]> file : files.entrySet())
            Files.write(folder.resolve(file.getKey()), file.getValue());
        assertEquals(List.of(), FolderCheck.faults(folder));
        if (form == TaskKind.BREAK) return; // its statement does not name it
        for (String statement : List.of("statement.en.md", "statement.ru.md"))
            assertTrue(Files.readString(folder.resolve(statement)).contains("new-one"), statement);
    }
}
