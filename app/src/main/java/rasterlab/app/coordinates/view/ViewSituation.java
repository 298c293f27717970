package rasterlab.app.coordinates.view;

import static rasterlab.app.coordinates.view.ViewNumber.*;

import java.util.Locale;
import java.util.Map;

/** Numbers under which a view is worth a look. */
public enum ViewSituation {
    /** The course's worked scene. */
    WORKED(
            ViewKind.HOUSE,
            Map.of(ANGLE_X, -90.0, ANGLE_Y, -40.0, TILT, 10.0, SHIFT, -150.0, R, -1.0 / 700)),
    /** H = 1 − 128/128: one gable lies in the eye's own plane. */
    AT_THE_EYE(
            ViewKind.HOUSE,
            Map.of(ANGLE_X, -90.0, ANGLE_Y, -90.0, TILT, 0.0, SHIFT, -72.0, R, -1.0 / 128)),
    /** The eye stands within the house. */
    BEHIND_THE_EYE(
            ViewKind.HOUSE,
            Map.of(ANGLE_X, -90.0, ANGLE_Y, -90.0, TILT, 0.0, SHIFT, -72.0, R, -1.0 / 64)),
    /** z' below 2 dz': the amount of perspective runs away. */
    RUNAWAY(ViewKind.SPHERICAL_LEFT, Map.of(THETA, 30.0, PHI, 70.0, RHO, 150.0)),
    /** Perspective is hardly seen. */
    FROM_AFAR(ViewKind.SPHERICAL_LEFT, Map.of(THETA, 30.0, PHI, 70.0, RHO, 4000.0)),
    /** The eye above the north pole. */
    POLE(ViewKind.SPHERICAL_LEFT, Map.of(THETA, 30.0, PHI, 0.0, RHO, 400.0)),
    /** sin φ is below 0: the picture stands on its head. */
    UPSIDE_DOWN(ViewKind.SPHERICAL_LEFT, Map.of(THETA, 30.0, PHI, -70.0, RHO, 400.0)),
    /** The dimetric α and 45°, as the appendix prints them beside the isometric cells. */
    PRINTED_ISOMETRIC(ViewKind.TRIMETRIC, Map.of(ALPHA, 22.207654298596487, BETA, 45.0));

    private final ViewKind kind;
    private final transient Map<ViewNumber, Double> numbers;

    ViewSituation(ViewKind kind, Map<ViewNumber, Double> numbers) {
        this.kind = kind;
        this.numbers = numbers;
    }

    /** Lower-case name with hyphens. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    ViewChoice in(ViewChoice choice) {
        ViewChoice next = choice.with(kind).withStable(true).with(Stereoscopy.NONE);
        for (ViewNumber each : ViewNumber.values())
            if (numbers.containsKey(each)) next = next.with(each, numbers.get(each));
        return next;
    }
}
