package rasterlab.app.coordinates.view;

import static rasterlab.app.coordinates.view.ViewNumber.*;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.coordinates.view.ViewStage.CoordinateSpace;
import rasterlab.engine.scene.House;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.matrix.MatrixCall;

/**
 * The matrices of a view, stage by stage, all by the names that the course gives them.
 *
 * <p>The object's frame and the world are right-handed, z up. How the eye's frame lies depends on
 * the kind: x right, y up and z towards the viewer, or away where it is left-handed.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "forming the
 * picture", "view transformation" and appendix.
 */
final class ViewStages {
    /** Pixels per unit of the picture plane in a window of 800×600. */
    private static final double NATURAL_SCALE = 2.4;

    /**
     * Pixels per unit for the course's own scene, which lies below the middle of its picture plane.
     */
    private static final double NATURAL_SCALE_OF_THE_COURSE = 1.5;

    static final double NEAR = 50;
    static final double FAR = 2000;

    private static final MatrixCall UPRIGHT = MatrixCall.of("ROT3DX", -90);

    private final ViewChoice choice;

    private ViewStages(ViewChoice choice) {
        this.choice = choice;
    }

    static List<ViewStage> of(ViewChoice choice) {
        var stages = new ViewStages(choice);
        var picture = new ArrayList<>(stages.toPlane());
        picture.addAll(stages.projection());
        return List.of(
                new ViewStage(CoordinateSpace.OBJECT, List.of()),
                new ViewStage(CoordinateSpace.WORLD, stages.world()),
                new ViewStage(CoordinateSpace.EYE, stages.eye()),
                new ViewStage(CoordinateSpace.PICTURE, picture),
                new ViewStage(CoordinateSpace.SCREEN, stages.screen()));
    }

    /** The matrix that moves the eye's space to where the projection expects it. */
    static List<MatrixCall> toPlane(ViewChoice choice) {
        return new ViewStages(choice).toPlane();
    }

    /** The matrices from there to the picture plane. */
    static List<MatrixCall> projection(ViewChoice choice) {
        return new ViewStages(choice).projection();
    }

    private MatrixCall call(String name, ViewNumber... numbers) {
        var values = new double[numbers.length];
        for (int i = 0; i < values.length; i++) values[i] = choice.number(numbers[i]);
        return MatrixCall.of(name, values);
    }

    /** Metres times 16; but for the course's own scene about the middle of the house. */
    private List<MatrixCall> world() {
        var calls = new ArrayList<MatrixCall>();
        if (choice.kind() != ViewKind.HOUSE) calls.add(MatrixCall.of("TRANSL3D", -4, -3, -4.5));
        for (String axis : List.of("X", "Y", "Z"))
            calls.add(MatrixCall.of("SCALE3D" + axis, House.SCALE));
        return calls;
    }

    private List<MatrixCall> eye() {
        return switch (choice.kind()) {
            case HOUSE ->
                    List.of(call("ROT3DX", ANGLE_X), call("ROT3DY", ANGLE_Y), call("ROT3DX", TILT));
            case SPHERICAL_LEFT -> List.of(call("VIEW_LEFT", THETA, PHI, RHO));
            case SPHERICAL_RIGHT -> List.of(call("VIEW_RIGHT", THETA, PHI, RHO));
            case LOOK_AT ->
                    List.of(
                            MatrixCall.of(
                                    "LOOKAT",
                                    choice.number(EYE_X),
                                    choice.number(EYE_Y),
                                    choice.number(EYE_Z),
                                    0,
                                    0,
                                    0,
                                    0,
                                    0,
                                    1));
            case CENTRAL -> List.of(UPRIGHT, MatrixCall.of("REFL3DXY"));
            default -> List.of(UPRIGHT);
        };
    }

    private List<MatrixCall> toPlane() {
        return choice.kind() == ViewKind.HOUSE
                ? List.of(MatrixCall.of("TRANSL3D", 0, choice.number(SHIFT), 0))
                : List.of();
    }

    private List<MatrixCall> projection() {
        return switch (choice.kind()) {
            case HOUSE, ONE_POINT -> List.of(MatrixCall.of("PERSPECTIVE", 0, 0, choice.number(R)));
            case TWO_POINT ->
                    List.of(MatrixCall.of("PERSPECTIVE", choice.number(P), 0, choice.number(R)));
            case THREE_POINT -> List.of(call("PERSPECTIVE", P, Q, R));
            case CENTRAL -> List.of(call("CENTRAL", K));
            case SPHERICAL_LEFT, SPHERICAL_RIGHT -> List.of(call("CENTRAL_ORIGIN", D));
            case LOOK_AT ->
                    List.of(
                            MatrixCall.of(
                                    "GL_PERSPECTIVE",
                                    choice.number(FOVY),
                                    choice.number(WIDTH) / choice.number(HEIGHT),
                                    NEAR,
                                    FAR));
            case TRIMETRIC -> List.of(call("TRIMETRIC", ALPHA, BETA));
            default -> List.of(MatrixCall.of(choice.kind().name()));
        };
    }

    /** {@link PictureFit}, which keeps the proportions, as matrices; OpenGL's has y upwards. */
    private List<MatrixCall> screen() {
        if (choice.kind() == ViewKind.LOOK_AT)
            return List.of(
                    MatrixCall.of(
                            "VIEWPORT", 0, 0, choice.number(WIDTH), choice.number(HEIGHT), 0, 1));
        PictureFit fit = fit(choice);
        double s = fit.pixelsPerUnit();
        return List.of(
                MatrixCall.of("SCALE3DX", s),
                MatrixCall.of("SCALE3DY", choice.kind().yDown() ? s : -s),
                MatrixCall.of("TRANSL3D", fit.centerX(), fit.centerY(), 0));
    }

    static PictureFit fit(ViewChoice choice) {
        return PictureFit.of(
                (int) Math.round(choice.number(WIDTH)),
                (int) Math.round(choice.number(HEIGHT)),
                choice.kind() == ViewKind.HOUSE ? NATURAL_SCALE_OF_THE_COURSE : NATURAL_SCALE);
    }
}
