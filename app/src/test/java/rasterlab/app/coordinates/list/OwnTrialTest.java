package rasterlab.app.coordinates.list;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** A program of the user's own that is tried on points of space. */
@Tag("slow")
class OwnTrialTest {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ConcurrentLinkedQueue<Runnable> answers = new ConcurrentLinkedQueue<>();
    private final OwnMethods own = new OwnMethods();
    private final ListLabModel model = new ListLabModel(own, answers::add, failures::add);

    @AfterEach
    void close() {
        model.close();
        own.close();
        assertEquals(List.of(), failures);
    }

    private TrialScene tried(String id, String source) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named(id);
        own.bring(exercise, source);
        model.enter(exercise.topic());
        model.tryMethod(OwnMethods.NAME);
        model.settle();
        for (Runnable next = answers.poll(); next != null; next = answers.poll()) next.run();
        TrialScene scene = model.trial().orElseThrow();
        assertEquals(OwnMethods.NAME, scene.trial().method());
        return scene;
    }

    @ParameterizedTest
    @ValueSource(strings = {"view", "rotate-axis"})
    void theModelSolutionIsRight(String id) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named(id);
        TrialScene scene = tried(id, exercise.evidence().model().orElseThrow());
        assertEquals(Verdict.Kind.EXACT, scene.verdict().kind(), scene.verdict().detail());
        assertTrue(scene.size() > 0);
        assertEquals(0, scene.off());
    }

    @Test
    void aPointThatIsElsewhereIsSeen() throws InterruptedException {
        TrialScene scene =
                tried(
                        "rotate-axis",
                        """
                        import rasterlab.contract.*;
                        public class Mine implements AxisRotation {
                            public void rotate(double[] through, double[] direction,
                                    double degrees, double[] points) {
                                points[0] += 1;
                            }
                        }
                        """);
        assertTrue(scene.off() > 0, scene.verdict().detail());
    }
}
