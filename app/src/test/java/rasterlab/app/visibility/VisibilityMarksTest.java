package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.pipeline.Renderer;

/**
 * Checks what stands over the pictures, and how long: marks of wrong pixels, problems with files.
 */
@Timeout(300)
class VisibilityMarksTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final VisibilityLabModel model =
            new VisibilityLabModel(new OwnMethods(), new Renderer()::render, thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    /** Waits for the pictures and hands their answers to the model. */
    private void settle() {
        thread.settle(model::settle);
    }

    @Test
    void problemWithAFileIsToldUntilTheNextChange(@TempDir Path folder) throws Exception {
        model.resize(60, 40);
        model.watchSteps(true);
        settle();
        List<Runnable> changes =
                List.of(
                        () -> model.turn(0.1, 0),
                        () -> model.goTo(3),
                        () -> model.choosePixel(new ChosenPixel(false, 30, 20)),
                        model::reset);
        for (Runnable change : changes) {
            model.open(folder.resolve("gone.obj"));
            settle();
            assertNotEquals("", model.state().problem());
            model.resize(61, 41);
            model.resize(60, 40);
            assertNotEquals("", model.state().problem(), "another size is no change of a choice");
            change.run();
            assertEquals("", model.state().problem());
        }
    }

    @Test
    void wrongPixelsAreCountedWhenTheLabOpensThoughNotMarked() {
        model.resize(60, 40);
        settle();
        assertFalse(model.state().choice().difference());
        var readings = new VisibilityReadings(model, Texts.of("visibility", Language.ENGLISH));
        assertTrue(readings.wrongPixels().matches("[0-9]+ pixels"), readings.wrongPixels());
        assertFalse(model.state().marked());
        model.turn(0.1, 0);
        settle();
        assertTrue(model.state().difference().isEmpty(), "counting slows turning down");
    }

    @Test
    void wrongPixelsAreMarkedAtTheLastStepOnly() {
        model.resize(60, 40);
        model.choose(
                choice -> choice.comparing("cyclic-overlap", "painter", "").withDifference(true));
        model.watchSteps(true);
        settle();
        assertTrue(model.state().difference().isPresent());
        assertTrue(model.state().marked());
        model.goTo(2);
        assertFalse(model.state().marked());
        var readings = new VisibilityReadings(model, Texts.of("visibility", Language.ENGLISH));
        for (String said : List.of(readings.wrongPixels(), readings.missing(), readings.share()))
            assertEquals("known at the end", said);
        model.goTo(model.lastStep());
        assertTrue(model.state().marked());
        model.goTo(2);
        model.watchSteps(false);
        assertTrue(model.state().marked(), "a scene that turns is drawn to the end");
    }
}
