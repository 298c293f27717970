package rasterlab.app.line.figure;

import java.util.Optional;
import rasterlab.engine.raster.PixelDifference;

/**
 * The drawings of the methods of one choice.
 *
 * @param drawing by the chosen method
 * @param other by the second one, if one is compared
 * @param apart pixels of two methods: extra is what only the chosen one lights, missing what only
 *     the second one does; empty where no two pictures are compared
 */
public record FigureDrawings(
        FigureScene scene,
        FigureDrawing drawing,
        Optional<FigureDrawing> other,
        Optional<PixelDifference> apart) {

    static FigureDrawings of(FigureTopics topics, FigureScene scene) {
        FigureDrawing drawing = FigureDrawing.of(topics, scene, scene.method());
        if (scene.comparison().isEmpty())
            return new FigureDrawings(scene, drawing, Optional.empty(), Optional.empty());
        FigureDrawing other = FigureDrawing.of(topics, scene, scene.comparison());
        boolean pictures = scene.figure() instanceof ArcFigure && drawing.whole() && other.whole();
        return new FigureDrawings(
                scene,
                drawing,
                Optional.of(other),
                pictures
                        ? Optional.of(PixelDifference.of(other.pixels(), drawing.pixels()))
                        : Optional.empty());
    }
}
