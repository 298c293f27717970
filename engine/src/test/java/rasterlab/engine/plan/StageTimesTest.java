package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;

class StageTimesTest {
    private static RenderRequest picture(String scene, String visibility, String shading) {
        Scene known = Scenes.named(scene);
        return new RenderRequest(
                known, visibility, shading, "perspective", known.defaultCamera(), 64, 48);
    }

    private static StageTimes times(String scene, String visibility, String shading) {
        return StageTimes.of(picture(scene, visibility, shading), 0, () -> false);
    }

    @Test
    @DisplayName("work that a picture does not have is given time")
    void whatIsNotDoneTakesNothing() {
        for (String visibility : List.of("pipeline", "zfloat", "painter", "auto")) {
            for (String shading : List.of("flat", "gouraud", "phong")) {
                Map<String, Double> took = times("vase", visibility, shading).milliseconds();
                String told = visibility + ", " + shading + ": " + took;
                assertEquals(0, took.get("texels"), told);
                if (!shading.equals("gouraud")) assertEquals(0, took.get("lights"), told);
                if (!shading.equals("phong")) assertEquals(0, took.get("pixel-lights"), told);
            }
        }
    }

    @Test
    @DisplayName("a stage is of no kind of counted work, or shares leave out a stage")
    void stagesAreThoseThatAreCounted() {
        RenderRequest picture = picture("globe", "pipeline", "phong");
        StageTimes times = StageTimes.of(picture, 0, () -> false);
        var unknown = new TreeSet<>(times.milliseconds().keySet());
        unknown.removeAll(WorkCount.of(picture, () -> false).stages().keySet());
        assertEquals(new TreeSet<String>(), unknown);
        double shares = times.milliseconds().keySet().stream().mapToDouble(times::share).sum();
        assertEquals(1, shares, 1e-9);
        assertTrue(times.rounds() >= 1, "rounds " + times.rounds());
    }

    @Test
    @DisplayName("a picture that nobody waits for any more is measured to its end")
    void measuringStopsWhenItIsCancelled() {
        RenderRequest picture = picture("cube", "zfloat", "flat");
        assertThrows(CancellationException.class, () -> StageTimes.of(picture, 1000, () -> true));
    }

    @Test
    @DisplayName("a time below 0 is taken")
    void refusesTimesBelowZero() {
        assertThrows(
                IllegalArgumentException.class, () -> new StageTimes(Map.of("faces", -1.0), 1));
        assertThrows(IllegalArgumentException.class, () -> new StageTimes(Map.of(), 0));
    }
}
