package rasterlab.app.light;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.light.step.LightSteps;
import rasterlab.app.light.step.NormalSteps;
import rasterlab.app.light.step.OwnSteps;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.light.face.SeenBrightness;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.visibility.SeenPoint;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * A choice to be drawn.
 *
 * @param width of each of the three pictures, in device pixels
 * @param height of each
 */
public record LightFrame(LightChoice choice, int width, int height) {
    /** The shadings side by side. */
    public static final List<ShadingMethod> SHADINGS =
            List.of(ShadingMethod.FLAT, ShadingMethod.GOURAUD, ShadingMethod.PHONG);

    /** Samples of a profile, and how many of them a place of the eye looks to each side. */
    private static final int SAMPLES = 401;

    private static final int REACH = 12;

    /** The pictures of the user's own program: its own, the right one, and their difference. */
    static final String MINE = "mine";

    static final String RIGHT = "right";
    static final String OFF = "off";

    /** The pictures of a plan: the full one, the least one, and their difference. */
    private static final String FULL = "full";

    private static final String LEAST = "least";

    /**
     * One of the three pictures.
     *
     * @param name code of its shading, or one of the program's pictures
     * @param brightness along the line; no numbers where there is no light in it
     * @param reported what the eye makes of it
     */
    public record ShadedPicture(
            String name, Raster raster, double[] brightness, double[] reported) {
        private ShadedPicture with(Raster other) {
            return new ShadedPicture(name, other, brightness, reported);
        }
    }

    /**
     * All that is shown of a choice.
     *
     * @param pictures by flat, Gouraud's and Phong's shading, or those of the user's own program
     * @param places where the lamps are on them
     * @param faceArrows normals of faces: x and y of both ends of each, in pixels
     * @param cornerArrows normals of corners likewise
     * @param rightArrows right normals of corners, where the user's own program found the others
     * @param point the formula at the chosen point; empty where no face is
     * @param own what there is to say of the user's own program; empty where it does nothing
     * @param least the least light beside the full one; empty where it is not wished
     */
    public record DrawnFrame(
            LightChoice choice,
            int width,
            int height,
            List<ShadedPicture> pictures,
            PicturePlaces places,
            double[] faceArrows,
            double[] cornerArrows,
            double[] rightArrows,
            Optional<PointReading> point,
            Optional<OwnRemarks> own,
            Optional<LitPlans.ComparedPictures> least) {
        /** The answers of the user's own program; empty where there are none. */
        public Optional<OwnSteps> steps() {
            return own.flatMap(OwnRemarks::steps);
        }

        /** This drawing with the program's answers up to a step alone. */
        public DrawnFrame upTo(int step) {
            if (steps().isEmpty() || step >= steps().get().count()) return this;
            if (steps().get() instanceof LightSteps light) {
                List<Raster> shown = OwnLight.upTo(step, light);
                return with(
                        List.of(
                                pictures.get(0).with(shown.get(0)),
                                pictures.get(1),
                                pictures.get(2).with(shown.get(1))),
                        cornerArrows,
                        rightArrows);
            }
            int reached = step == 0 ? -1 : ((NormalSteps) steps().get()).vertex(step);
            return with(pictures, upTo(reached, cornerArrows), upTo(reached, rightArrows));
        }

        private double[] upTo(int vertex, double[] arrows) {
            int[] of = places.cornerVertices();
            return IntStream.range(0, arrows.length)
                    .filter(i -> of[i / 4] <= vertex)
                    .mapToDouble(i -> arrows[i])
                    .toArray();
        }

        private DrawnFrame with(List<ShadedPicture> others, double[] corners, double[] rights) {
            return new DrawnFrame(
                    choice,
                    width,
                    height,
                    others,
                    places,
                    faceArrows,
                    corners,
                    rights,
                    point,
                    own,
                    least);
        }
    }

    /**
     * @param body the choice's scene
     * @param normals of the user's own program, if the body is lit by those
     * @param mine the user's own programs
     * @param plans draws the least light
     */
    DrawnFrame drawn(
            Scene body,
            Optional<OwnNormals> normals,
            OwnMethods mine,
            LitPlans plans,
            PictureMaker maker,
            BooleanSupplier cancelled) {
        var places = PicturePlaces.of(choice, body, width, height);
        if (choice.shaded().isEmpty()) {
            Optional<LitPlans.ComparedPictures> least =
                    choice.least()
                            .tolerance()
                            .map(within -> plans.drawn(this, body, within, maker, cancelled));
            return drawn(
                    least.map(this::pictures).orElseGet(() -> shadings(body, maker, cancelled)),
                    places,
                    normals.map(OwnNormals::right),
                    normals.map(OwnNormals::remarks),
                    least);
        }
        int[] at = {column(), row()};
        var light = OwnLight.of(choice, places, body.backgroundRgb(), at, mine, cancelled);
        return drawn(
                List.of(
                        profiled(MINE, light.mine()),
                        profiled(RIGHT, light.right()),
                        new ShadedPicture(OFF, light.off(), new double[0], new double[0])),
                places,
                Optional.empty(),
                Optional.of(light.remarks()),
                Optional.empty());
    }

    private List<ShadedPicture> pictures(LitPlans.ComparedPictures least) {
        return List.of(
                profiled(FULL, least.full()),
                profiled(LEAST, least.picture().raster()),
                new ShadedPicture(OFF, least.difference().raster(), new double[0], new double[0]));
    }

    private List<ShadedPicture> shadings(
            Scene body, PictureMaker maker, BooleanSupplier cancelled) {
        var pictures = new ArrayList<ShadedPicture>();
        for (ShadingMethod shading : SHADINGS) {
            RenderRequest request = LitScene.request(choice, body, shading, width, height);
            pictures.add(profiled(shading.code(), maker.picture(request, cancelled)));
        }
        return List.copyOf(pictures);
    }

    /**
     * @param right the body with right normals, where its own may be wrong
     */
    private DrawnFrame drawn(
            List<ShadedPicture> pictures,
            PicturePlaces places,
            Optional<Scene> right,
            Optional<OwnRemarks> own,
            Optional<LitPlans.ComparedPictures> least) {
        ViewedMesh view = places.view();
        boolean arrows = choice.arrows();
        return new DrawnFrame(
                choice,
                width,
                height,
                pictures,
                places,
                arrows ? places.faceArrows() : new double[0],
                arrows ? places.cornerArrows() : new double[0],
                right.filter(body -> arrows)
                        .map(body -> PicturePlaces.of(choice, body, width, height).cornerArrows())
                        .orElse(new double[0]),
                SeenPoint.at(view, column(), row())
                        .map(point -> PointReading.of(choice, view, point)),
                own,
                least);
    }

    private ShadedPicture profiled(String name, Raster raster) {
        LightChoice.LightMarks line = choice.line();
        MarkPlaces marks = marks();
        double[] brightness =
                SeenBrightness.along(
                        raster,
                        Math.min(width - 1, marks.x(line.fromX())),
                        Math.min(height - 1, marks.y(line.fromY())),
                        Math.min(width - 1, marks.x(line.toX())),
                        Math.min(height - 1, marks.y(line.toY())),
                        SAMPLES);
        return new ShadedPicture(
                name, raster, brightness, SeenBrightness.reported(brightness, REACH));
    }

    private MarkPlaces marks() {
        return new MarkPlaces(width, height);
    }

    private int column() {
        return (int) Math.min(width - 1, marks().x(choice.line().atX()));
    }

    private int row() {
        return (int) Math.min(height - 1, marks().y(choice.line().atY()));
    }
}
