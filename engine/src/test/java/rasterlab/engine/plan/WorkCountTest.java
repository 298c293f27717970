package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.sight.LightWork;
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

    @Test
    @DisplayName("the bound that tells where light may be mixed is free")
    void boundsOfMixedLightAreCounted() {
        Scene torus = Scenes.named("torus");
        var phong =
                new RenderRequest(
                        torus, "pipeline", "phong", "perspective", torus.defaultCamera(), 160, 120);
        RenderRequest mixed = phong.with(phong.look().withSavings(new Savings(8, false)));
        PictureWork all = WorkCount.of(phong, () -> false);
        PictureWork some = WorkCount.of(mixed, () -> false);
        assertTrue(some.pixelLights() < all.pixelLights(), some + " of " + all);
        assertTrue(some.lights() > LightWork.BOUND * some.faces(), some.toString());
        assertEquals(WorkEstimate.of(mixed).lights(), some.lights());
    }

    @ParameterizedTest(name = "the work of the {0} is predicted far from what is counted")
    @ValueSource(strings = {"cube", "torus", "vase", "house", "globe"})
    void predictionIsNearTheCount(String name) {
        Scene scene = Scenes.named(name);
        for (String method : List.of("pipeline", "zfloat", "painter")) {
            var request =
                    new RenderRequest(
                            scene, method, "phong", "perspective", scene.defaultCamera(), 160, 120);
            PictureWork counted = WorkCount.of(request, () -> false);
            PictureWork predicted = WorkEstimate.of(request);
            assertEquals(counted.vertices(), predicted.vertices());
            assertEquals(counted.faces(), predicted.faces());
            assertEquals(counted.pixels(), predicted.pixels());
            assertEquals(counted.lights(), predicted.lights());
            String both = method + ": " + counted + " and " + predicted;
            assertEquals(counted.fragments(), predicted.fragments(), 0.02 * counted.fragments());
            within(2, counted.pixelLights(), predicted.pixelLights(), both);
            within(2, counted.texels(), predicted.texels(), both);
        }
    }

    /** The order decides what is lit before nearer faces hide it; it is not predicted. */
    private static void within(double factor, long counted, long predicted, String both) {
        assertTrue(predicted <= factor * counted && counted <= factor * predicted, both);
    }
}
