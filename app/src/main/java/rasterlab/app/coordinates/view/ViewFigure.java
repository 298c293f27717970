package rasterlab.app.coordinates.view;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkBounds;
import rasterlab.app.coordinates.figure.MarkInk;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.coordinates.figure.Viewpoint;
import rasterlab.app.coordinates.figure.Wireframe;
import rasterlab.engine.transform.VanishingPoints;
import rasterlab.engine.transform.matrix.MatrixCall;

/** The picture of a scene on the stage. */
final class ViewFigure {
    /** Sizes of the house between it and the farthest vanishing point that is brought in sight. */
    private static final double FARTHEST = 3;

    /** Corners of the house on its long edges, from which lines run to vanishing points. */
    private static final int[] FROM = {0, 6};

    private static final String[] AXES = {"x", "y", "z"};

    private final ViewScene scene;
    private final ViewChoice choice;
    private final int stage;
    private final List<Mark> marks = new ArrayList<>();

    private ViewFigure(ViewScene scene, int stage) {
        this.scene = scene;
        this.stage = stage;
        choice = scene.choice();
    }

    static Figure of(ViewScene scene, int stage) {
        var figure = new ViewFigure(scene, stage);
        ViewStage.CoordinateSpace space = scene.stages().get(stage).space();
        scene.image(stage)
                .ifPresent(
                        image -> {
                            if (space.deep()) figure.space(image);
                            else figure.plane(image);
                        });
        return new Figure(figure.marks, !space.deep());
    }

    /** Where the chosen vertex is on the stage; empty where it has no image. */
    static Optional<StagePoint> vertex(ViewScene scene, int stage) {
        var figure = new ViewFigure(scene, stage);
        int vertex = scene.choice().vertex() - 1;
        if (!scene.eyes().isEmpty() && !scene.stages().get(stage).space().deep())
            return Optional.of(figure.eye(0).get(vertex)).filter(StagePoint::isFinite);
        return scene.image(stage)
                .map(image -> figure.places(image).get(vertex))
                .filter(StagePoint::isFinite);
    }

    private List<StagePoint> places(ViewScene.StagePoints image) {
        return scene.stages().get(stage).space().deep()
                ? seen(image.numbers())
                : Viewpoint.spots(image.numbers(), 3);
    }

    /** Places on the stage of points of the stage's space. */
    private List<StagePoint> seen(double... points) {
        return choice.viewpoint().places(upright(), points);
    }

    /** Brings the frame of the stage to x right, y up, z towards the viewer. */
    private List<MatrixCall> upright() {
        if (scene.stages().get(stage).space() != ViewStage.CoordinateSpace.EYE)
            return List.of(MatrixCall.of("ROT3DX", -90));
        return switch (choice.kind()) {
            case SPHERICAL_LEFT, CENTRAL -> List.of(MatrixCall.of("REFL3DXY"));
            case SPHERICAL_RIGHT -> List.of(MatrixCall.of("ROT3DX", 180));
            default -> List.of();
        };
    }

    private void space(ViewScene.StagePoints image) {
        axes(image);
        if (scene.stages().get(stage).space() == ViewStage.CoordinateSpace.EYE
                && choice.kind().central()) new EyeSpace().draw(image);
        wire(image, seen(image.numbers()), MarkInk.OBJECT, "");
    }

    /** Draws the axes from the origin, half as long again as the object reaches. */
    private void axes(ViewScene.StagePoints image) {
        for (int axis = 0; axis < 3; axis++) {
            double reach = 0;
            for (int v = 0; v < ViewScene.HOUSE.size(); v++)
                for (int any = 0; any < 3; any++)
                    reach =
                            Math.max(
                                    reach,
                                    Math.abs(image.coordinate(v, any) - image.coordinate(0, any)));
            var tip = new double[3];
            tip[axis] = 0.9 * reach;
            marks.add(
                    new Mark.ArrowMark(
                            seen(0, 0, 0).get(0),
                            seen(tip).get(0),
                            MarkInk.axis(axis),
                            AXES[axis]));
        }
    }

    private void wire(
            ViewScene.StagePoints image, List<StagePoint> places, MarkInk ink, String label) {
        for (Wireframe.Edge edge : ViewScene.HOUSE.edges()) {
            boolean right = image.inFront(edge.from()) && image.inFront(edge.to());
            marks.add(
                    new Mark.LineMark(
                            places.get(edge.from()),
                            places.get(edge.to()),
                            right ? ink : MarkInk.WRONG));
        }
        if (!label.isEmpty())
            for (int v = 0; v < places.size(); v++)
                if (image.inFront(v))
                    marks.add(new Mark.DotMark(places.get(v), ink, String.valueOf(v + 1)));
    }

    private void plane(ViewScene.StagePoints image) {
        if (scene.stages().get(stage).space() == ViewStage.CoordinateSpace.SCREEN) window();
        if (!scene.eyes().isEmpty()) {
            twoEyes();
            return;
        }
        if (choice.vanishing()) vanishing(image);
        // Far points make the house so small that its numbers would lie on each other.
        wire(image, places(image), MarkInk.OBJECT, choice.vanishing() ? "" : "numbered");
    }

    /** Draws the window's edge, and its middle where the picture plane's origin falls. */
    private void window() {
        double width = choice.number(ViewNumber.WIDTH);
        double height = choice.number(ViewNumber.HEIGHT);
        marks.add(
                new Mark.AreaMark(
                        List.of(
                                new StagePoint(0, 0),
                                new StagePoint(width, 0),
                                new StagePoint(width, height),
                                new StagePoint(0, height)),
                        MarkInk.PLANE));
        var fit = ViewStages.fit(choice);
        marks.add(
                new Mark.CrossMark(new StagePoint(fit.centerX(), fit.centerY()), MarkInk.HELP, ""));
    }

    /** Draws left and right one over the other, or in the halves of a picture twice as wide. */
    private void twoEyes() {
        for (int eye = 0; eye < 2; eye++)
            wire(image(eye), eye(eye), eye == 0 ? MarkInk.LEFT_EYE : MarkInk.RIGHT_EYE, "");
    }

    /**
     * @param eye 0 for the left one, 1 for the right one
     */
    private ViewScene.StagePoints image(int eye) {
        boolean screen = scene.stages().get(stage).space() == ViewStage.CoordinateSpace.SCREEN;
        return scene.eyes().get(2 * eye + (screen ? 1 : 0));
    }

    private List<StagePoint> eye(int eye) {
        ViewScene.StagePoints image = image(eye);
        boolean apart = choice.stereo() == Stereoscopy.SIDE_BY_SIDE;
        double way = apart ? (eye == 0 ? -1 : 1) * apart(image) : 0;
        var shift = List.of(Chains.cells(MatrixCall.of("TRANSL3D", way, 0, 0)));
        return Viewpoint.spots(Chains.images(3, shift, image.numbers()).images().coordinates(), 3);
    }

    /** Half of the way between two pictures that do not touch. */
    private static double apart(ViewScene.StagePoints image) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int v = 0; v < ViewScene.HOUSE.size(); v++) {
            least = Math.min(least, image.coordinate(v, 0));
            most = Math.max(most, image.coordinate(v, 0));
        }
        return 0.6 * (most - least);
    }

    /** The box around all marks, but for vanishing points so far that the house would be a dot. */
    static Rectangle2D frame(List<Mark> marks) {
        Rectangle2D house =
                MarkBounds.around(
                        marks.stream().filter(mark -> mark.ink() == MarkInk.OBJECT).toList());
        double most = FARTHEST * Math.max(house.getWidth(), house.getHeight());
        return MarkBounds.around(
                marks.stream()
                        .filter(
                                mark ->
                                        !(mark instanceof Mark.LineMark line
                                                && line.ink() == MarkInk.HELP))
                        .filter(
                                mark ->
                                        !(mark instanceof Mark.CrossMark cross
                                                && far(cross, house, most)))
                        .toList());
    }

    private static boolean far(Mark.CrossMark cross, Rectangle2D house, double most) {
        double x = cross.at().x() - house.getCenterX();
        double y = cross.at().y() - house.getCenterY();
        return Math.hypot(x, y) > most;
    }

    /** Draws where the images of all parallels to one edge of the house meet. */
    private void vanishing(ViewScene.StagePoints image) {
        Matrix4d all = scene.matrix(stage);
        for (int axis = 0; axis < 3; axis++) {
            Optional<Vector3d> found = VanishingPoints.of(all, axis);
            if (found.isEmpty() || !choice.kind().central()) continue;
            var point = new StagePoint(found.get().x, found.get().y);
            if (Math.abs(point.x()) > 1e6 || Math.abs(point.y()) > 1e6) continue;
            for (int from : FROM)
                if (image.inFront(from))
                    marks.add(new Mark.LineMark(places(image).get(from), point, MarkInk.HELP));
            marks.add(new Mark.CrossMark(point, MarkInk.EYE, AXES[axis] + "∞"));
        }
    }

    /** The eye, the plane before it, and the image there, as they lie in the eye's space. */
    private final class EyeSpace {
        private final Matrix4d back =
                Chains.product(Chains.cells(ViewStages.toPlane(choice))).invert();
        private final Matrix4d projection =
                Chains.product(Chains.cells(ViewStages.projection(choice)));

        void draw(ViewScene.StagePoints image) {
            List<Vector3d> centers = new ArrayList<>();
            for (int axis = 0; axis < 3; axis++)
                VanishingPoints.center(projection, axis)
                        .ifPresent(at -> centers.add(back.transformPosition(at)));
            for (Vector3d center : centers)
                marks.add(
                        new Mark.CrossMark(
                                seen(center.x, center.y, center.z).get(0), MarkInk.EYE, "E"));
            if (centers.size() == 1) sight(image, centers.get(0));
        }

        private void sight(ViewScene.StagePoints image, Vector3d eye) {
            int vertex = choice.vertex() - 1;
            List<StagePoint> line =
                    seen(
                            eye.x,
                            eye.y,
                            eye.z,
                            image.coordinate(vertex, 0),
                            image.coordinate(vertex, 1),
                            image.coordinate(vertex, 2));
            marks.add(new Mark.LineMark(line.get(0), line.get(1), MarkInk.EYE));
            if (choice.kind() == ViewKind.LOOK_AT) return;
            double z = choice.kind().spherical() ? choice.number(ViewNumber.D) : 0;
            scene.image(ViewStage.CoordinateSpace.PICTURE.ordinal())
                    .ifPresent(flat -> image(flat, z));
        }

        /** Draws the picture on its plane, with an edge around both. */
        private void image(ViewScene.StagePoints flat, double z) {
            if (flat.behind() > 0) return;
            double[] points = flat.numbers();
            double left = Double.POSITIVE_INFINITY;
            double right = Double.NEGATIVE_INFINITY;
            double low = left;
            double high = right;
            for (int i = 0; i < points.length; i += 3) {
                left = Math.min(left, points[i]);
                right = Math.max(right, points[i]);
                low = Math.min(low, points[i + 1]);
                high = Math.max(high, points[i + 1]);
                points[i + 2] = z;
            }
            double free = 0.15 * Math.max(right - left, high - low);
            double[] edge = {
                left - free,
                low - free,
                z,
                right + free,
                low - free,
                z, //
                right + free,
                high + free,
                z,
                left - free,
                high + free,
                z
            };
            marks.add(new Mark.AreaMark(inEyeSpace(edge), MarkInk.PLANE));
            List<StagePoint> places = inEyeSpace(points);
            for (Wireframe.Edge each : ViewScene.HOUSE.edges())
                marks.add(
                        new Mark.LineMark(
                                places.get(each.from()), places.get(each.to()), MarkInk.PLANE));
        }

        private List<StagePoint> inEyeSpace(double[] planePoints) {
            return seen(
                    Chains.images(3, List.of(Chains.cells(back)), planePoints)
                            .images()
                            .coordinates());
        }
    }
}
