package rasterlab.app.visibility;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.FaceDrawing;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.visibility.buffer.PixelTouch;

/**
 * The events at one pixel.
 *
 * @param asked the pixel, and in which picture
 * @param touches every face that touched it, in the order in which they did
 * @param stored what the depth buffer holds in the end, where the method keeps one
 * @param askable whether the picture is one whose faces can be asked
 */
record PixelReport(
        PixelRequest asked, List<PixelTouch> touches, OptionalDouble stored, boolean askable) {
    /**
     * @param x column
     * @param y row
     */
    record PixelRequest(RenderRequest request, int x, int y) {
        boolean isAt(ChosenPixel pixel) {
            return pixel.x() == x && pixel.y() == y;
        }
    }

    static PixelReport of(PixelRequest asked, BooleanSupplier cancelled) {
        Optional<FaceDrawing> drawing = FaceDrawing.of(asked.request);
        if (drawing.isEmpty()) return untold(asked);
        try {
            List<PixelTouch> touches = drawing.get().history(asked.x, asked.y, cancelled);
            OptionalDouble stored =
                    drawing.get().keepsDepths()
                            ? drawing.get().depths(Frame.ALL, cancelled).at(asked.x, asked.y)
                            : OptionalDouble.empty();
            return new PixelReport(asked, touches, stored, true);
        } catch (IllegalArgumentException refused) {
            return untold(asked); // The picture says why.
        }
    }

    private static PixelReport untold(PixelRequest asked) {
        return new PixelReport(asked, List.of(), OptionalDouble.empty(), false);
    }
}
