package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.sight.cost.PictureWork;

class WorkCountTest {
    /** A cube by painter's, so near that a face is many rows high. */
    private static RenderRequest cube() {
        Scene cube = Scenes.named("cube").zoomed(2);
        return new RenderRequest(
                cube, "painter", "flat", "perspective", cube.defaultCamera(), 160, 120);
    }

    @ParameterizedTest(name = "counting goes on after the {0}th question was answered yes")
    @ValueSource(ints = {1, 2, 20})
    void stopsAtTheFirstYes(int last) {
        var asked = new AtomicInteger();
        assertThrows(
                CancellationException.class,
                () -> WorkCount.of(cube(), () -> asked.incrementAndGet() >= last));
        assertEquals(last, asked.get());
    }

    @Test
    @DisplayName("a face as large as the picture is filled to its end before it is asked again")
    void asksAtEachRow() {
        var asked = new AtomicInteger();
        PictureWork work = WorkCount.of(cube(), () -> asked.incrementAndGet() == 0);
        long rows = work.fragments() / 160;
        assertTrue(rows > 50, "the cube is too small: " + work);
        assertTrue(asked.get() >= work.faces() + rows, asked + " times, " + work);
    }

    @Test
    @DisplayName("thousands of faces that cover no pixel are gone through without a question")
    void asksAtEachFaceThatCoversNothing() {
        Scene torus = Scenes.named("torus", 48);
        var request =
                new RenderRequest(
                        torus, "zfloat", "flat", "perspective", torus.defaultCamera(), 4, 3);
        var asked = new AtomicInteger();
        PictureWork work = WorkCount.of(request, () -> asked.incrementAndGet() == 0);
        assertTrue(work.fragments() < work.faces() / 2, "the torus is too large: " + work);
        assertTrue(asked.get() >= work.faces(), asked + " times, " + work);
    }
}
