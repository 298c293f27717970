package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.mine.OwnMethods;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** A program of the user's own that draws circles or ellipses. */
@Tag("slow")
class OwnFigureTest {
    @ParameterizedTest
    @CsvSource({"circle, CIRCLE", "ellipse, ELLIPSE"})
    void theModelSolutionIsRightAndStepped(String id, LineMode mode) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named(id);
        List<Throwable> failures = new CopyOnWriteArrayList<>();
        try (var own = new OwnMethods();
                var model = new FigureLabModel(own, Runnable::run, failures::add)) {
            own.bring(exercise, exercise.evidence().model().orElseThrow());
            model.chooseMode(mode);
            model.chooseMethod(OwnMethods.NAME);
            model.settle();
            FigureDrawing drawing = model.state().drawing();
            assertEquals(OwnMethods.NAME, drawing.method());
            assertTrue(drawing.isRight(), drawing.message());
            assertEquals(drawing.pixels().size(), model.last());
            assertEquals(List.of(), failures);
        }
    }
}
