package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.Sheet;
import rasterlab.exercises.predicting.SheetText;

/** Which sheet a lab goes on with. */
@Timeout(300)
class BeginningTest {
    private static final String STARTER = "GET /api/v1/exercises/predict-line/starter";
    private static final long HERE = 5;
    private static final long THERE = 77;

    private final Exercise exercise = Catalogue.builtIn().named("predict-line");

    private Beginning beginning(Optional<Account> account) {
        return new Beginning(exercise, account, CourseServer.ServerTimeouts.USUAL);
    }

    /** The sheet of this machine, with an answer to its first question. */
    private String begun() {
        Sheet sheet = Sheet.of("line", exercise.predicting().orElseThrow(), HERE);
        return SheetText.written(exercise.id(), sheet, BeginningTest::first);
    }

    private static JsonNode first(Question one) {
        return one.number() == 1 ? one.right() : JsonNodeFactory.instance.objectNode();
    }

    @Test
    void withoutACourseASheetIsGoneOnWithAsItIs() throws Exception {
        String open = SheetText.open(exercise, HERE);
        assertEquals(HERE, beginning(Optional.empty()).sheet(open).sheet().seed());
    }

    @Test
    void whatIsNoSheetIsToldSo() {
        assertThrows(UnreadableSheet.class, () -> beginning(Optional.empty()).sheet("{"));
    }

    @Test
    @Tag("slow")
    void untouchedSheetGivesWayToTheServersAndABegunOneDoesNot(@TempDir Path folder)
            throws Exception {
        try (var server = SubmittingTest.server();
                var trial = new Trial(folder)) {
            server.on(STARTER, 200, SheetText.open(exercise, THERE));
            trial.model.enrolment().join(server.address(), "CODE", "Ann");
            trial.awaitEnd();
            Beginning joined = beginning(trial.state().account());
            String open = SheetText.open(exercise, HERE);
            assertEquals(THERE, joined.sheet(open).sheet().seed());
            assertEquals(HERE, joined.sheet(begun()).sheet().seed());
        }
    }
}
