package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.server.FakeServer;

/** Handing in after the deadline, with the student's consent. */
@Tag("slow")
@Timeout(300)
class LateSubmissionTest {
    @TempDir Path folder;

    @Test
    @DisplayName(
            "a late hand-in offers no consent, or its consent is not sent, or the text is lost")
    void aLateHandInIsOfferedWithWhatItCosts() throws Exception {
        try (var server = SubmittingTest.server();
                var trial = new Trial(folder)) {
            trial.model.enrolment().join(server.address(), "CODE", "Ann");
            trial.awaitEnd();
            server.on(
                    SubmittingTest.SUBMIT,
                    exchange -> {
                        boolean agreed = "late=accept".equals(exchange.getRequestURI().getQuery());
                        String refusal =
                                "{\"type\":\"urn:rasterlab:problem:late\",\"detail\":\"x\"}";
                        String taken = "{\"id\":\"s1\",\"state\":\"queued\",\"position\":2}";
                        FakeServer.send(
                                exchange,
                                agreed ? 202 : 409,
                                "application/json",
                                agreed ? taken : refusal);
                    });
            String source = trial.model.state().source();
            trial.model.submit();
            ExerciseState state = trial.awaitEnd();
            assertEquals(Notice.of("late"), state.notice());
            for (Language language : Language.values()) {
                String said = state.notice().in(Texts.of("exercise", language));
                String button = Texts.of("exercise", language).label("submitLate");
                assertTrue(said.contains(button), said);
            }
            assertEquals(source, state.source());
            trial.model.submit(true);
            assertEquals(3, trial.awaitEnd().outcome().orElseThrow().attempt());
        }
    }
}
