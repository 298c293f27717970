package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.spline.function.SplineProblem;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** The steps of a program of the user's own that puts a function through knots. */
@Tag("slow")
class OwnFunctionTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("spline-function");

    private static final String STRAIGHT =
            """
            public class Mine implements rasterlab.contract.SplineFunction {
                public double[] coefficients(double[] x, double[] y,
                        rasterlab.contract.SplineEnds ends) {
                    double[] all = new double[4 * x.length - 4];
                    for (int i = 0; i + 1 < x.length; i++) {
                        all[4 * i] = y[i];
                        all[4 * i + 1] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
                    }
                    return all;
                }
            }
            """;

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final OwnMethods own = new OwnMethods();
    private final FunctionLabModel model = new FunctionLabModel(own, Runnable::run, failures::add);

    @AfterEach
    void close() {
        model.close();
        own.close();
        assertEquals(List.of(), failures);
    }

    private void show(String source) throws InterruptedException {
        own.bring(EXERCISE, source);
        model.show(
                new SplineProblem(
                        new double[] {0, 1, 2},
                        new double[] {0, 1, 0},
                        SplineEnds.natural(),
                        new double[0],
                        false));
        model.chooseMethod(OwnMethods.NAME);
        model.settle();
    }

    private FunctionReadings readings(int step) {
        model.goTo(step);
        return new FunctionReadings(model.state(), Texts.of("spline", Language.ENGLISH));
    }

    @Test
    void eachAskedPlaceIsAStepBesideTheRightValue() throws InterruptedException {
        show(STRAIGHT);
        assertEquals(13, model.last());
        assertEquals("value at x = 0", readings(1).phase());
        assertEquals("0, right", readings(1).decision());
        assertEquals("value at x = 0.5", readings(4).phase());
        // The natural spline through these knots is 3/2·s − s³/2 on its first piece.
        assertEquals("0.5, but 0.6875 is right", readings(4).decision());
        assertEquals("answer", readings(4).decides());
        assertEquals(4, model.state().answers().size());
        assertTrue(model.state().answers().get(3).wrong());
    }

    @Test
    void theModelSolutionAnswersRightlyAtEachPlace() throws InterruptedException {
        show(EXERCISE.evidence().model().orElseThrow());
        model.goTo(model.last());
        assertEquals(13, model.state().answers().size());
        for (FunctionDrawing.FunctionAnswer each : model.state().answers())
            assertFalse(each.wrong(), "" + each);
    }
}
