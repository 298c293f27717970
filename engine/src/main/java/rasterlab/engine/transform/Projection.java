package rasterlab.engine.transform;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.joml.Matrix4d;
import rasterlab.engine.naming.Named;

/**
 * Projects eye space onto the picture plane; the named parallel ones also say from where.
 *
 * <p>The named ones have directions of their own and take no more than ρ from the camera. Their
 * matrices are the course's, whose y points up; the world's z becomes it, its y goes away from the
 * viewer of {@link #FRONT}.
 */
public enum Projection {
    /**
     * Central: X = d·x/z, Y = d·y/z. With d = ρ, what lies at the object's centre keeps its size
     * while ρ changes the amount of perspective.
     */
    PERSPECTIVE,
    /**
     * X = x, Y = y: what the vase's program does, whose d and ρ never divide anything. Nothing is
     * too near, the eye is infinitely far.
     */
    PARALLEL,
    /** The view from −y; x to the right, z up. */
    FRONT,
    /** The view from +y; −x to the right, z up. */
    BACK,
    /** The view from −x; −y to the right, z up. */
    LEFT,
    /** The view from +x; y to the right, z up. */
    RIGHT,
    /** The view from +z; x to the right, y up. */
    TOP,
    /** The view from −z; x to the right, −y up. */
    BOTTOM,
    /** Axes shortened each in its way: α = −30°, β = 20°, the course's example. */
    TRIMETRIC,
    /** Two axes shortened alike, the third to a half of them. */
    DIMETRIC,
    /** All axes shortened alike. */
    ISOMETRIC,
    /** Oblique: what goes away from the viewer is drawn at 45° in its full length. */
    CAVALIER,
    /** Oblique: what goes away from the viewer is drawn at 45° in half its length. */
    CABINET;

    /** Lower-case name, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The names that {@link #named} knows. */
    public static List<String> names() {
        return Arrays.stream(values()).map(Projection::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static Projection named(String name) {
        return Named.find("projection", name, List.of(values()), Projection::code);
    }

    /** Whether the camera's angles turn the picture. */
    public boolean turnsWithCamera() {
        return this == PERSPECTIVE || this == PARALLEL;
    }

    /** Whether lines to the picture plane are slanted to it. */
    public boolean oblique() {
        return this == CAVALIER || this == CABINET;
    }

    /** World → eye space (x right, y up, z forward, the world's origin at z = ρ). */
    Matrix4d worldToView(SphericalView camera) {
        if (turnsWithCamera()) return camera.matrix();
        var zUpToYUp =
                new Matrix4d(
                        1, 0, 0, 0, //
                        0, 0, -1, 0, //
                        0, 1, 0, 0, //
                        0, 0, 0, 1);
        return TextbookMatrices.translation(0, 0, camera.rho())
                .mul(TextbookMatrices.scale(1, 1, -1))
                .mul(turned())
                .mul(zUpToYUp);
    }

    /** The turn into the course's axes: x right, y up, z to the viewer. */
    private Matrix4d turned() {
        double quarter = Math.PI / 2;
        return switch (this) {
            case BACK -> TextbookMatrices.rotationY(2 * quarter);
            case LEFT -> TextbookMatrices.rotationY(quarter);
            case RIGHT -> TextbookMatrices.rotationY(-quarter);
            case TOP -> TextbookMatrices.rotationX(quarter);
            case BOTTOM -> TextbookMatrices.rotationX(-quarter);
            case TRIMETRIC ->
                    ProjectionMatrices.trimetric(
                            Angle.ofRadians(-Math.PI / 6), Angle.ofRadians(Math.PI / 9));
            case DIMETRIC -> ProjectionMatrices.dimetric();
            case ISOMETRIC -> ProjectionMatrices.isometric();
            case CAVALIER -> ProjectionMatrices.oblique(ProjectionMatrices.CAVALIER);
            case CABINET -> ProjectionMatrices.oblique(ProjectionMatrices.CABINET);
            default -> new Matrix4d();
        };
    }
}
