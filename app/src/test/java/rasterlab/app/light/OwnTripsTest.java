package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.ColorModel;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** A program of the user's own that writes colours in other models. */
@Tag("slow")
class OwnTripsTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("color");

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ConcurrentLinkedQueue<Runnable> answers = new ConcurrentLinkedQueue<>();
    private final OwnMethods own = new OwnMethods();
    private final LightLabModel model = new LightLabModel(own, answers::add, failures::add);

    @AfterEach
    void close() {
        model.close();
        own.close();
        assertEquals(List.of(), failures);
    }

    private OwnTrips.Trips trips(String source) throws InterruptedException {
        own.bring(EXERCISE, source);
        model.enterColors();
        model.color(color -> color.withMethod(OwnMethods.NAME));
        model.ownTrips(model.state().color());
        model.settle();
        for (Runnable next = answers.poll(); next != null; next = answers.poll()) next.run();
        return model.ownTrips(model.state().color()).orElseThrow();
    }

    private static String converting(String body) {
        return """
            import rasterlab.contract.*;
            public class Mine implements ColorConverter {
                public double[] convert(ColorModel from, double[] components, ColorModel to) {
                    %s
                }
            }
            """
                .formatted(body);
    }

    @Test
    void theModelSolutionBringsTheColorBackFromEachModel() throws InterruptedException {
        OwnTrips.Trips trips = trips(EXERCISE.evidence().model().orElseThrow());
        assertEquals("", trips.refusal());
        assertEquals(ColorModel.values().length - 1, trips.errors().size());
        trips.errors().forEach((by, error) -> assertTrue(error < 1e-9, by + " " + error));
    }

    @Test
    void anAnswerOfAWrongLengthIsTold() throws InterruptedException {
        OwnTrips.Trips trips = trips(converting("return new double[9];"));
        assertEquals("your program's answer has 9 values where 3 were asked for", trips.refusal());
    }

    @Test
    void anEndlessOneIsAskedOnce() throws InterruptedException {
        OwnTrips.Trips trips =
                trips(converting("while (to != null) components[0]++; return null;"));
        assertEquals("your program did not answer within 2.0 s and was stopped", trips.refusal());
        assertEquals(0, trips.errors().size());
    }

    @Test
    void anotherTextIsAskedAgain() throws InterruptedException {
        assertTrue(
                trips(converting("return new double[to.size()];")).errors().get(ColorModel.CMY)
                        > 0.5);
        OwnTrips.Trips right = trips(EXERCISE.evidence().model().orElseThrow());
        assertTrue(right.errors().get(ColorModel.CMY) < 1e-9, right.toString());
    }
}
