package rasterlab.app.coordinates.view;

import static rasterlab.app.coordinates.view.ViewNumber.*;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** How the lab looks at the house: every view and projection that the course names. */
public enum ViewKind {
    /** The course's worked scene, with its own turns, its shift and its r. */
    HOUSE(ANGLE_X, ANGLE_Y, TILT, SHIFT, R),
    SPHERICAL_LEFT(THETA, PHI, RHO, D),
    SPHERICAL_RIGHT(THETA, PHI, RHO, D),
    LOOK_AT(EYE_X, EYE_Y, EYE_Z, FOVY),
    CENTRAL(K),
    ONE_POINT(R),
    TWO_POINT(P, R),
    THREE_POINT(P, Q, R),
    FRONT,
    BACK,
    LEFT,
    RIGHT,
    TOP,
    BOTTOM,
    TRIMETRIC(ALPHA, BETA),
    DIMETRIC,
    ISOMETRIC,
    CAVALIER,
    CABINET;

    private final List<ViewNumber> own;

    ViewKind(ViewNumber... own) {
        this.own = List.of(own);
    }

    /** Lower-case name with hyphens. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    static ViewKind named(String code) {
        return Named.find("view", code, List.of(values()), ViewKind::code);
    }

    /** The kind's own numbers, without the size of the window. */
    List<ViewNumber> numbers() {
        return own;
    }

    boolean spherical() {
        return this == SPHERICAL_LEFT || this == SPHERICAL_RIGHT;
    }

    /** Whether lines of sight meet in an eye. */
    boolean central() {
        return ordinal() < FRONT.ordinal();
    }

    /** Where the kind stands in the tree of projections, as a text's key. */
    String family() {
        if (this == TWO_POINT) return "two-point";
        if (this == THREE_POINT) return "three-point";
        if (central()) return this == ONE_POINT || this == CENTRAL ? "one-point" : "central";
        if (ordinal() < TRIMETRIC.ordinal()) return "orthographic";
        return ordinal() < CAVALIER.ordinal() ? "axonometric" : "oblique";
    }

    /** Whether y of the picture plane points down, as on a screen. */
    boolean yDown() {
        return this == SPHERICAL_RIGHT;
    }
}
