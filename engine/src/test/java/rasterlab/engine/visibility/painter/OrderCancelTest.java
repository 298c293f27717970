package rasterlab.engine.visibility.painter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.hidden.TestScenes;
import rasterlab.engine.visibility.hidden.Visibilities;

class OrderCancelTest {
    @ParameterizedTest(name = "{0} orders on when cancelled")
    @ValueSource(strings = {"newell", "bsp"})
    void endsBeforeAnythingIsPainted(String method) {
        ViewedMesh view =
                TestScenes.seen(
                        TestScenes.crossing(60, 60, 7),
                        new SphericalView(0.4, 1, 500),
                        Projection.PERSPECTIVE,
                        40,
                        30);
        var out = new Raster(40, 30);
        var asked = new AtomicInteger();
        assertThrows(
                CancellationException.class,
                () ->
                        new Visibilities()
                                .named(method)
                                .implementation()
                                .draw(
                                        view,
                                        TestScenes.numbers(view.mesh()),
                                        out,
                                        () -> asked.incrementAndGet() == 3));
        assertEquals(3, asked.get());
        for (int argb : out.argb()) assertEquals(0, argb);
    }
}
