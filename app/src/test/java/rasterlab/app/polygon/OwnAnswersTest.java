package rasterlab.app.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.outcome.InsideAnswer;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.exercises.catalogue.Catalogue;

/** The steps of a program of the user's own that says of points whether they are inside. */
@Tag("slow")
class OwnAnswersTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final OwnMethods own = new OwnMethods();
    private final PolygonLabModel model =
            new PolygonLabModel(new PolygonTopics(own), thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        own.close();
        assertEquals(List.of(), failures);
    }

    private PolygonReadings readings(int step) {
        model.goTo(step);
        return new PolygonReadings(model.state(), Texts.of("polygon", Language.ENGLISH));
    }

    @Test
    void eachPointInATriangleIsAStepBesideTheRightAnswer() {
        own.bring(
                Catalogue.builtIn().named("point-in-triangle"),
                """
                public class Mine implements rasterlab.contract.PointInTriangle {
                    public boolean contains(double ax, double ay, double bx, double by, double cx,
                            double cy, double x, double y) {
                        return x > 1;
                    }
                }
                """);
        show(PolygonMode.TRIANGLE, Points.of(0, 0, 4, 0, 0, 4));
        thereAreStepsForEachPoint();
    }

    @Test
    void eachPointInAPolygonIsAStepBesideTheRightAnswer() {
        own.bring(
                Catalogue.builtIn().named("point-in-polygon"),
                """
                public class Mine implements rasterlab.contract.PointInPolygon {
                    public boolean contains(double[] xs, double[] ys, double x, double y) {
                        return x > 1;
                    }
                }
                """);
        show(PolygonMode.POLYGON, Points.of(0, 0, 4, 0, 4, 1, 0, 4));
        thereAreStepsForEachPoint();
    }

    private void show(PolygonMode mode, Points corners) {
        model.showInput(mode, new ShapeAndPoints(corners, Points.of(2, 1, 1, 1, 9, 1)));
        model.chooseMethod(OwnMethods.NAME);
        thread.settle(model::settle);
    }

    private void thereAreStepsForEachPoint() {
        var answer = (InsideAnswer) model.state().results().outcome().answer();
        assertEquals(3, answer.steps());
        assertEquals("point 1 of 3: (2, 1)", readings(1).tested());
        assertEquals("inside", readings(1).decision());
        assertEquals("judged outside, but is inside", readings(2).decision());
        assertEquals("judged inside, but is outside", readings(3).decision());
        assertEquals("answer", readings(3).decides());
        assertFalse(answer.isWrong(0));
        assertTrue(answer.isWrong(1));
        assertEquals("all: 3 steps", readings(4).tested());
    }
}
