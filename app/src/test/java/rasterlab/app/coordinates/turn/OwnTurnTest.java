package rasterlab.app.coordinates.turn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.app.mine.OwnMethods;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** A program of the user's own that turns a point. */
@Tag("slow")
class OwnTurnTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("cheap-rotation");

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ConcurrentLinkedQueue<Runnable> answers = new ConcurrentLinkedQueue<>();
    private final OwnMethods own = new OwnMethods();
    private final TurnLabModel model = new TurnLabModel(own, answers::add, failures::add);

    @AfterEach
    void close() {
        model.close();
        own.close();
        assertEquals(List.of(), failures);
    }

    private TurnScene.Drift drift(String source) throws InterruptedException {
        own.bring(EXERCISE, source);
        model.chooseMethod(OwnMethods.NAME);
        model.settle();
        for (Runnable next = answers.poll(); next != null; next = answers.poll()) next.run();
        assertEquals(OwnMethods.NAME, model.scene().drift().method());
        return model.scene().drift();
    }

    private static String turning(String body) {
        return """
            import rasterlab.contract.*;
            public class Mine implements PlaneRotation {
                public void rotate(double degrees, int times, double[] points) {
                    %s
                }
            }
            """
                .formatted(body);
    }

    @Test
    void theModelSolutionDriftsAsLittleAsItMay() throws InterruptedException {
        TurnScene.Drift drift = drift(EXERCISE.evidence().model().orElseThrow());
        assertEquals("", drift.refusal());
        assertTrue(drift.error() < 1e-9, String.valueOf(drift.error()));
        assertEquals(model.choice().times(), model.scene().steps().size());
        assertEquals(7, drift.samples().size());
    }

    @Test
    void aPointThatStaysIsSeen() throws InterruptedException {
        TurnScene.Drift drift = drift(turning(""));
        assertTrue(drift.error() > 0.1, String.valueOf(drift.error()));
    }

    @Test
    void anEndlessOneIsStoppedAndTheOthersAreShown() throws InterruptedException {
        TurnScene.Drift drift = drift(turning("while (times > 0) points[0]++;"));
        assertEquals("your program did not answer within 2.0 s and was stopped", drift.refusal());
        assertEquals(model.methods().size() + 1, model.scene().drifts().size());
    }
}
