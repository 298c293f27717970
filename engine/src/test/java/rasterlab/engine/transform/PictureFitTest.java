package rasterlab.engine.transform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class PictureFitTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void mapsThePoint(int width, int height, double pixelX, double pixelY) {
        var fit = PictureFit.of(width, height, 2);
        assertEquals(pixelX, fit.toPixelX(10));
        assertEquals(pixelY, fit.toPixelY(30));
        assertEquals(10, fit.toPlaneX(pixelX));
        assertEquals(30, fit.toPlaneY(pixelY));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("y is not flipped", 800, 600, 420, 240),
                argumentSet("a wide picture is stretched", 1600, 600, 820, 240),
                argumentSet("a tall picture is stretched", 800, 1200, 420, 540),
                argumentSet("a large picture is not enlarged", 1600, 1200, 840, 480));
    }

    @Test
    @DisplayName("the centre of an odd size lies between pixels")
    void centerIsAPixel() {
        var fit = PictureFit.of(5, 1, 1);
        assertEquals(2, fit.centerX());
        assertEquals(0, fit.centerY());
    }

    @Test
    @DisplayName("an unknown projection is parallel")
    void namesTheKnownProjections() {
        assertEquals(Projection.PARALLEL, Projection.named("parallel"));
        var refusal = assertThrows(IllegalArgumentException.class, () -> Projection.named("iso"));
        assertEquals(
                "no projection 'iso'; there are " + String.join(", ", Projection.names()),
                refusal.getMessage());
    }
}
